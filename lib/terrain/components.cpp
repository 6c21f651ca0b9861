#include <array>
#include <terrain/components.hpp>

namespace tcert::terrain {
namespace {

/// Calls `visit(index)` for every unvisited neighbour of the cells in `open`, until none is left.
template <class Visit>
void flood(const Grid& grid, std::vector<std::size_t>& open, std::size_t steps, Visit visit) {
  while (!open.empty()) {
    const Cell c = grid.cell(open.back());
    open.pop_back();
    for (std::size_t k = 0; k < steps; ++k) {
      const Cell next{c.x + kSteps[k].x, c.y + kSteps[k].y};
      if (grid.contains(next) && visit(grid.index(next))) {
        open.push_back(grid.index(next));
      }
    }
  }
}

}  // namespace

std::vector<std::int32_t> label_components(const Grid& grid, const CellSet& set) {
  std::vector<std::int32_t> labels(grid.size(), kNoLabel);
  std::vector<std::size_t> open;
  std::int32_t next = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (set[i] == 0 || labels[i] != kNoLabel) {
      continue;
    }
    labels[i] = next;
    open.push_back(i);
    flood(grid, open, 4, [&](std::size_t at) {
      if (set[at] == 0 || labels[at] != kNoLabel) {
        return false;
      }
      labels[at] = next;
      return true;
    });
    ++next;
  }
  return labels;
}

CellSet component_of(const Grid& grid, const CellSet& set, Cell seed) {
  CellSet part(grid.size(), 0);
  if (!grid.contains(seed) || set[grid.index(seed)] == 0) {
    return part;
  }
  part[grid.index(seed)] = 1;
  std::vector<std::size_t> open{grid.index(seed)};
  flood(grid, open, 4, [&](std::size_t at) {
    if (set[at] == 0 || part[at] != 0) {
      return false;
    }
    part[at] = 1;
    return true;
  });
  return part;
}

bool are_joined(const Grid& grid, const CellSet& set, Cell a, Cell b) {
  return set[grid.index(b)] != 0 && component_of(grid, set, a)[grid.index(b)] != 0;
}

CellSet fill_holes(const Grid& grid, const CellSet& set) {
  CellSet filled(grid.size(), 1);
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t at) {
    if (set[at] != 0 || filled[at] == 0) {
      return false;
    }
    filled[at] = 0;
    return true;
  };
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Cell c = grid.cell(i);
    const bool edge = c.x == 0 || c.y == 0 || c.x == grid.rows - 1 || c.y == grid.columns - 1;
    if (edge && reach(i)) {
      open.push_back(i);
      flood(grid, open, 8, reach);
    }
  }
  return filled;
}

}  // namespace tcert::terrain
