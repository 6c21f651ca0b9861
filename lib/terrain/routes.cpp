#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <terrain/confidence.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

using Entry = std::pair<double, std::size_t>;

[[nodiscard]] bool is_member(const Grid& grid, const CellSet& set, Cell c) {
  return grid.contains(c) && set[grid.index(c)] != 0;
}

/// Lower bound of the way over 8-connected cells.
[[nodiscard]] double octile(Cell a, Cell b) {
  const double dx = std::abs(a.x - b.x);
  const double dy = std::abs(a.y - b.y);
  return std::max(dx, dy) + (std::sqrt(2.0) - 1.0) * std::min(dx, dy);
}

}  // namespace

std::vector<Cell> shortest_route(const Grid& grid, const CellSet& ground, Cell from, Cell to) {
  if (!is_member(grid, ground, from) || !is_member(grid, ground, to)) {
    return {};
  }
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<double> cost(grid.size(), kUnbounded);
  std::vector<std::size_t> before(grid.size(), kNone);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const std::size_t goal = grid.index(to);
  cost[grid.index(from)] = 0.0;
  open.emplace(octile(from, to), grid.index(from));
  while (!open.empty()) {
    const auto [estimate, at] = open.top();
    open.pop();
    if (at == goal) {
      break;
    }
    const Cell c = grid.cell(at);
    if (estimate > cost[at] + octile(c, to) + 1e-9) {
      continue;
    }
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
      const Cell next{c.x + kSteps[k].x, c.y + kSteps[k].y};
      if (!is_member(grid, ground, next)) {
        continue;
      }
      const bool diagonal = k >= 4;
      if (diagonal &&
          !(is_member(grid, ground, {next.x, c.y}) && is_member(grid, ground, {c.x, next.y}))) {
        continue;
      }
      const double through = cost[at] + (diagonal ? std::sqrt(2.0) : 1.0);
      const std::size_t i = grid.index(next);
      if (through < cost[i]) {
        cost[i] = through;
        before[i] = at;
        open.emplace(through + octile(next, to), i);
      }
    }
  }
  if (cost[goal] == kUnbounded) {
    return {};
  }
  std::vector<Cell> route{to};
  for (std::size_t at = goal; before[at] != kNone; at = before[at]) {
    route.push_back(grid.cell(before[at]));
  }
  std::reverse(route.begin(), route.end());
  return route;
}

double route_length(const std::vector<Cell>& route) noexcept {
  double length = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) {
    length += distance(route[i - 1], route[i]);
  }
  return length;
}

namespace {

/// Gives `visit` every cell that is joined to `from` with the width of the widest way there, the
/// widest first, until it returns true.
template <class Visit>
void by_width(const Grid& grid,
              const CellSet& ground,
              std::span<const double> value,
              Cell from,
              Visit visit) {
  if (!is_member(grid, ground, from)) {
    return;
  }
  std::vector<double> widest(grid.size(), -kUnbounded);
  CellSet done(grid.size(), 0);
  std::priority_queue<Entry> open;
  widest[grid.index(from)] = value[grid.index(from)];
  open.emplace(widest[grid.index(from)], grid.index(from));
  while (!open.empty()) {
    const auto [width, at] = open.top();
    open.pop();
    if (done[at] != 0) {
      continue;
    }
    done[at] = 1;
    if (visit(at, width)) {
      return;
    }
    const Cell c = grid.cell(at);
    for (std::size_t k = 0; k < 4; ++k) {
      const Cell next{c.x + kSteps[k].x, c.y + kSteps[k].y};
      if (!is_member(grid, ground, next)) {
        continue;
      }
      const std::size_t i = grid.index(next);
      const double through = std::min(width, value[i]);
      if (done[i] == 0 && (through > widest[i] || widest[i] == -kUnbounded)) {
        widest[i] = through;
        open.emplace(through, i);
      }
    }
  }
}

}  // namespace

std::optional<double> widest_route(const Grid& grid,
                                   const CellSet& ground,
                                   std::span<const double> value,
                                   double threshold,
                                   Cell from,
                                   Cell to) {
  std::optional<double> found;
  if (!is_member(grid, ground, to)) {
    return found;
  }
  const std::size_t wanted = grid.index(to);
  by_width(grid, ground, value, from, [&](std::size_t at, double width) {
    if (at == wanted) {
      found = width - threshold;
    }
    return found.has_value();
  });
  return found;
}

std::vector<double> widest_field(const Grid& grid,
                                 const CellSet& ground,
                                 std::span<const double> value,
                                 double threshold,
                                 Cell from) {
  std::vector<double> field(grid.size(), std::numeric_limits<double>::quiet_NaN());
  by_width(grid, ground, value, from, [&](std::size_t at, double width) {
    field[at] = width - threshold;
    return false;
  });
  return field;
}

}  // namespace tcert::terrain
