#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <tuple>

#include "analysis/study/truth/cell_grid.hpp"
#include "analysis/study/truth/clearance_value.hpp"

namespace tcert::study {
namespace {

constexpr std::uint8_t kFromSource = 8;
constexpr std::uint8_t kUnseen = 9;
constexpr std::array<std::array<int, 2>, 8> kMoves{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// A widest path over the eight neighbours: its cells from S to G, or none.
class WidestPath {
 public:
  WidestPath(const CellGrid& grid, const std::vector<std::uint32_t>& clearance)
      : grid_(grid), clearance_(clearance), came_by_(grid.size(), kUnseen) {}

  [[nodiscard]] std::vector<std::size_t> find(const std::vector<std::uint8_t>& start,
                                              const std::vector<std::uint8_t>& goal) {
    for (std::size_t cell = 0; cell < grid_.size(); ++cell) {
      if (start[cell] != 0) {
        offer(cell, clearance_[cell], kFromSource);
      }
    }
    while (!queue_.empty()) {
      const auto [width, cell] = queue_.top();
      queue_.pop();
      if (goal[cell] != 0) {
        return trace(cell);
      }
      const auto column = static_cast<std::int64_t>(cell % grid_.columns);
      const auto row = static_cast<std::int64_t>(cell / grid_.columns);
      for (std::size_t move = 0; move < kMoves.size(); ++move) {
        const std::int64_t x = column + kMoves[move][0];
        const std::int64_t y = row + kMoves[move][1];
        if (x >= 0 && y >= 0 && x < static_cast<std::int64_t>(grid_.columns) &&
            y < static_cast<std::int64_t>(grid_.rows)) {
          const std::size_t next =
              static_cast<std::size_t>(y) * grid_.columns + static_cast<std::size_t>(x);
          offer(next, std::min(width, clearance_[next]), static_cast<std::uint8_t>(move));
        }
      }
    }
    return {};
  }

 private:
  // A cell's width is final when it is first seen: the queue gives widths in falling order, and
  // all its neighbours would offer min(their width, its clearance).
  void offer(std::size_t cell, std::uint32_t width, std::uint8_t move) {
    if (width > 0 && came_by_[cell] == kUnseen) {
      came_by_[cell] = move;
      queue_.push({width, static_cast<std::uint32_t>(cell)});
    }
  }

  [[nodiscard]] std::vector<std::size_t> trace(std::size_t cell) const {
    std::vector<std::size_t> cells{cell};
    while (came_by_[cell] != kFromSource) {
      const auto& move = kMoves[came_by_[cell]];
      cell = static_cast<std::size_t>(static_cast<std::int64_t>(cell) - move[0] -
                                      move[1] * static_cast<std::int64_t>(grid_.columns));
      cells.push_back(cell);
    }
    std::reverse(cells.begin(), cells.end());
    return cells;
  }

  const CellGrid& grid_;
  const std::vector<std::uint32_t>& clearance_;
  std::vector<std::uint8_t> came_by_;
  std::priority_queue<std::pair<std::uint32_t, std::uint32_t>> queue_;
};

}  // namespace

GridClearance grid_clearance(const World& world, double step_m) {
  require_regions(world);
  const CellGrid grid = cell_grid(world, step_m);
  const double half_diagonal = step_m / std::sqrt(2.0);
  std::vector<std::uint32_t> squared;
  {
    std::vector<std::uint8_t> marks(grid.size(), 0);
    for (const Region& obstacle : world.obstacles) {
      mark_region(grid, obstacle, half_diagonal, marks);
    }
    squared = squared_distances(grid, marks);
  }
  std::vector<std::uint8_t> start(grid.size(), 0);
  std::vector<std::uint8_t> goal(grid.size(), 0);
  mark_region(grid, *world.start, half_diagonal, start);
  mark_region(grid, *world.goal, half_diagonal, goal);

  const double error = std::sqrt(2.0) * step_m;
  GridClearance result;
  result.value.upper_m = error;
  const std::vector<std::size_t> cells = WidestPath(grid, squared).find(start, goal);
  if (cells.empty()) {
    return result;
  }
  const std::size_t tightest =
      *std::min_element(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) {
        return squared[a] < squared[b];
      });
  ClearanceValue& value = result.value;
  value.clearance_m = step_m * std::sqrt(static_cast<double>(squared[tightest]));
  value.upper_m = value.clearance_m + error;
  value.lower_m = value.clearance_m > error ? value.clearance_m - error : ClearanceValue::kNoPath;
  value.bottleneck = grid.centre(tightest);
  for (const std::size_t cell : cells) {
    result.path.push_back(grid.centre(cell));
  }
  return result;
}

}  // namespace tcert::study
