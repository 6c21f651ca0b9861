#include "analysis/study/experiment/cell.hpp"

#include <algorithm>
#include <stdexcept>
#include <tcert/certifier.hpp>

namespace tcert::study {

std::string overrides_text(const Cell& cell) {
  std::string text;
  for (const auto& [key, value] : cell.overrides) {
    text += (text.empty() ? "" : " ") + key + '=' + value;
  }
  return text.empty() ? "(none)" : text;
}

std::vector<Cell> grid_cells(std::span<const GridAxis> axes) {
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
  return {std::move(cell), std::move(set)};
}

}  // namespace tcert::study
