#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <tcert/cell_graph.hpp>
#include <tuple>

namespace tcert::policies {
namespace {

constexpr double kUnitsPerMetre = 1e6;
/// More than the search would raise a cost by, so that ways of one shape cost the same everywhere.
constexpr PathCost kAboveDistance = 2;
constexpr std::uint32_t kNone = DStarLite::kNoState;

/// Of a next cell, the smallest first: what the way costs, how far it leads off the straight line,
/// to the other side, back.
using Preference = std::tuple<PathCost, std::int64_t, std::int64_t, std::int64_t>;

}  // namespace

CellGraph::CellGraph(const PolicySetup& setup)
    : grid_(setup),
      search_(grid_.cells(), 4 * grid_.cells()),
      soft_weight_(setup.parameters.soft_weight),
      edges_(grid_.cells()),
      obstacle_(grid_.cells()),
      obstacles_near_(grid_.cells()),
      level_(grid_.cells()) {
  const double half_width_m = 0.5 * setup.robot.body_width_m;
  for_each_offset_within(std::max(half_width_m - setup.parameters.inflation_slack_m, 0.0),
                         grid_.cell_m(),
                         [&](GridCell offset) { inflation_.push_back(offset); });
  build();
}

void CellGraph::reset() noexcept {
  std::fill(obstacle_.begin(), obstacle_.end(), std::uint8_t{0});
  std::fill(obstacles_near_.begin(), obstacles_near_.end(), std::uint16_t{0});
  std::fill(level_.begin(), level_.end(), std::uint8_t{0});
  build();
}

void CellGraph::build() noexcept {
  search_.clear();
  for (std::uint32_t cell = 0; cell < grid_.cells(); ++cell) {
    search_.add_state(grid_.centre(grid_.cell(cell)));
  }
  for (std::uint32_t cell = 0; cell < grid_.cells(); ++cell) {
    for (std::size_t i = 0; i < edges_[cell].size(); ++i) {
      const std::uint32_t other = grid_.index(grid_.cell(cell) + kNeighbours[i]);
      edges_[cell][i] =
          other == CourseGrid::kOutside ? kNone : search_.add_edge(cell, other, cost(cell, other));
    }
  }
}

std::uint32_t CellGraph::edge_to(std::uint32_t cell, std::size_t neighbour) const noexcept {
  if (neighbour < 4) {
    return edges_[cell][neighbour];
  }
  const std::uint32_t other = grid_.index(grid_.cell(cell) + kNeighbours[neighbour]);
  return other == CourseGrid::kOutside ? kNone : edges_[other][neighbour - 4];
}

PathCost CellGraph::cost(std::uint32_t a, std::uint32_t b) const noexcept {
  if (!is_free(a) || !is_free(b)) {
    return kBlocked;
  }
  const GridCell from = grid_.cell(a);
  const GridCell to = grid_.cell(b);
  const double steps = from.x != to.x && from.y != to.y ? std::numbers::sqrt2 : 1.0;
  const double level = 0.5 * (level_[a] + level_[b]) / kMostLevel;
  const double inflated = kUnitsPerMetre * grid_.cell_m() * steps * (1.0 + soft_weight_ * level);
  return static_cast<PathCost>(std::ceil(inflated)) + kAboveDistance;
}

void CellGraph::renew_edges(std::uint32_t cell) noexcept {
  for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
    const std::uint32_t edge = edge_to(cell, i);
    if (edge != kNone) {
      search_.set_cost(edge, cost(cell, grid_.index(grid_.cell(cell) + kNeighbours[i])));
    }
  }
}

void CellGraph::set_obstacle(std::uint32_t cell, bool obstacle) noexcept {
  if (is_obstacle(cell) == obstacle) {
    return;
  }
  obstacle_[cell] = obstacle ? 1 : 0;
  for (const GridCell offset : inflation_) {
    const std::uint32_t near = grid_.index(grid_.cell(cell) + offset);
    if (near == CourseGrid::kOutside) {
      continue;
    }
    const bool was_free = is_free(near);
    obstacles_near_[near] = static_cast<std::uint16_t>(obstacles_near_[near] + (obstacle ? 1 : -1));
    if (is_free(near) != was_free) {
      renew_edges(near);
    }
  }
}

void CellGraph::set_level(std::uint32_t cell, std::uint8_t level) noexcept {
  if (level_[cell] != level) {
    level_[cell] = level;
    renew_edges(cell);
  }
}

void CellGraph::set_goal(std::uint32_t cell) noexcept {
  goal_ = cell;
  search_.set_goal(cell);
}

PathCost CellGraph::plan(std::uint32_t start) noexcept {
  start_ = start;
  search_.set_start(start);
  return search_.plan();
}

// All ways of least cost are exact in the search, so which of them is taken is settled here, by
// where cells lie and not by the order in which they were looked at.
std::uint32_t CellGraph::next(std::uint32_t cell, int side) const noexcept {
  const GridCell from = grid_.cell(start_);
  const GridCell goal = grid_.cell(goal_);
  std::uint32_t best = kNone;
  Preference best_rank;
  for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
    const std::uint32_t edge = edge_to(cell, i);
    const GridCell to = grid_.cell(cell) + kNeighbours[i];
    const std::uint32_t other = grid_.index(to);
    if (edge == kNone || search_.cost(edge) == kBlocked ||
        search_.cost_to_goal(other) == kBlocked) {
      continue;
    }
    // Along the straight line to the goal, and to the side of it that wins ties; times its length.
    const std::int64_t line_x = goal.x - from.x;
    const std::int64_t line_y = goal.y - from.y;
    const std::int64_t along = line_x * (to.x - from.x) + line_y * (to.y - from.y);
    const std::int64_t aside = side * (line_x * (to.y - from.y) - line_y * (to.x - from.x));
    const Preference rank{
        search_.cost(edge) + search_.cost_to_goal(other), std::abs(aside), -aside, -along};
    if (best == kNone || rank < best_rank) {
      best = other;
      best_rank = rank;
    }
  }
  return best;
}

Point CellGraph::ahead(double lookahead_m, int side) const noexcept {
  const Point from = grid_.centre(grid_.cell(start_));
  std::uint32_t at = start_;
  // A way that winds is not followed for longer than a few lookaheads.
  const auto most = 4 * static_cast<int>(std::ceil(lookahead_m / grid_.cell_m())) + 4;
  for (int step = 0; step < most && at != goal_; ++step) {
    if (distance(grid_.centre(grid_.cell(at)), from) >= lookahead_m) {
      break;
    }
    const std::uint32_t onward = next(at, side);
    if (onward == kNone) {
      break;
    }
    at = onward;
  }
  return grid_.centre(grid_.cell(at));
}

}  // namespace tcert::policies
