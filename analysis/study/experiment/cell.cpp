#include "analysis/study/experiment/cell.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tcert/certifier.hpp>

namespace tcert::study {

namespace {

/// Before the first cell is made: a few axes of a few values are more cells than memory holds.
void require_size(std::span<const GridAxis> axes) {
  std::size_t cells = 1;
  for (const GridAxis& axis : axes) {
    cells *= axis.values.size();
    if (cells > kMostGridCells) {
      throw std::invalid_argument("grid: more than " + std::to_string(kMostGridCells) +
                                  " combinations; give fewer values, or cells from a file");
    }
  }
}

}  // namespace

std::string overrides_text(const Cell& cell) {
  std::string text;
  for (const auto& [key, value] : cell.overrides) {
    text += text.empty() ? "" : " ";
    text += key;
    text += '=';
    text += value;
  }
  return text.empty() ? "(none)" : text;
}

std::vector<Cell> grid_cells(std::span<const GridAxis> axes) {
  require_size(axes);
  if (axes.empty()) {
    throw std::invalid_argument("a grid needs a parameter");
  }
  std::vector<Cell> cells(1);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const GridAxis& axis = axes[a];
    if (axis.values.empty()) {
      throw std::invalid_argument("grid: '" + axis.key + "' has no value");
    }
    if (std::any_of(axes.begin(),
                    axes.begin() + static_cast<std::ptrdiff_t>(a),
                    [&](const auto& b) { return b.key == axis.key; })) {
      throw std::invalid_argument("grid: '" + axis.key + "' comes twice");
    }
    std::vector<Cell> longer;
    longer.reserve(cells.size() * axis.values.size());
    for (const Cell& cell : cells) {
      for (const std::string& value : axis.values) {
        longer.push_back(cell);
        longer.back().overrides.emplace_back(axis.key, value);
      }
    }
    cells = std::move(longer);
  }
  for (Cell& cell : cells) {
    cell.name = overrides_text(cell);
  }
  return cells;
}

std::optional<std::string> impossible_value(std::span<const PlannedCell> cells) {
  struct Seen {
    bool possible = false;
    const std::string* reason = nullptr;
  };
  std::map<std::pair<std::string, std::string>, Seen> values;
  for (const PlannedCell& planned : cells) {
    for (const auto& value : planned.cell.overrides) {
      Seen& seen = values[value];
      seen.possible = seen.possible || !planned.refused();
      if (planned.refused() && seen.reason == nullptr) {
        seen.reason = &std::get<std::string>(planned.parameters);
      }
    }
  }
  for (const PlannedCell& planned : cells) {
    for (const auto& value : planned.cell.overrides) {
      if (const Seen& seen = values.at(value); !seen.possible) {
        return value.first + '=' + value.second + ": " + *seen.reason;
      }
    }
  }
  return std::nullopt;
}

PlannedCell plan(Cell cell, const ParameterSet& base, const Robot& robot, const Course& course) {
  ParameterSet set = base;
  try {
    for (const auto& [key, value] : cell.overrides) {
      set_parameter(set, key, value);
    }
    validate(set);
    (void)Certifier(with_overrides(robot, set.robot), course, set.certificate);
  } catch (const std::invalid_argument& error) {
    return {std::move(cell), std::string(error.what())};
  }
  return {std::move(cell), set};
}

}  // namespace tcert::study
