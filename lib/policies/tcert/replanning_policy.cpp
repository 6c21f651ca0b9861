#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/replanning_policy.hpp>

namespace tcert::policies {
namespace {

constexpr double kForgetAgain = 5.0;  // s

}  // namespace

ReplanningPolicy::ReplanningPolicy(const PolicySetup& setup)
    : pilot_(setup),
      grid_(setup),
      memory_(setup),
      graph_(setup),
      half_width_m_(0.5 * setup.robot.body_width_m),
      // So that every cell of the grid has the centre of one of the memory within it.
      memory_radius_m_(0.75 * setup.certificate.memory_cell_m),
      forget_steps_(static_cast<std::uint32_t>(kForgetAgain / setup.control_period_s)),
      since_forgotten_(forget_steps_),
      rows_(static_cast<std::int32_t>(2.0 * setup.parameters.lookahead_m /
                                      setup.parameters.policy_cell_m)),
      closed_(graph_.grid().cells()) {
  for_each_offset_within(setup.robot.body_width_m,
                         setup.parameters.policy_cell_m,
                         [&](GridCell offset) { near_.push_back(offset); });
}

void ReplanningPolicy::forget() noexcept {
  grid_.reset();
  graph_.reset();
  std::fill(closed_.begin(), closed_.end(), std::uint8_t{0});
  goal_ = CourseGrid::kOutside;
  since_forgotten_ = 0;
}

void ReplanningPolicy::reset() noexcept {
  forget();
  pilot_.reset();
  memory_.reset();
  since_forgotten_ = forget_steps_;
  row_ = 0;
}

void ReplanningPolicy::take_obstacles() noexcept {
  for (const std::uint32_t cell : grid_.touched()) {
    const bool felt = grid_.certainties()[cell] >= pilot_.parameters().blocked_certainty;
    graph_.set_obstacle(cell, felt || closed_[cell] != 0);
  }
}

// A row to either side of the robot a step, so that the mirrored rows are always as old.
void ReplanningPolicy::take_levels(const Outlook& now) noexcept {
  const CourseGrid& grid = graph_.grid();
  const GridCell here = grid.cell_at(now.body.origin);
  row_ = row_ < rows_ ? row_ + 1 : 0;
  for (const std::int32_t y : {row_, -row_}) {
    for (std::int32_t x = -rows_; x <= rows_; ++x) {
      const GridCell cell = here + GridCell{x, y};
      const std::uint32_t index = grid.index(cell);
      if (index != CourseGrid::kOutside) {
        const double memory = memory_.largest_within(grid.centre(cell), memory_radius_m_);
        graph_.set_level(index,
                         static_cast<std::uint8_t>(std::round(CellGraph::kMostLevel * memory)));
      }
    }
  }
}

void ReplanningPolicy::close_ahead(const Outlook& now) noexcept {
  const CourseGrid& grid = graph_.grid();
  const Point ahead = now.body.to_odometry({half_width_m_ + grid.cell_m(), 0.0});
  const std::uint32_t cell = grid.index(grid.cell_at(ahead));
  if (cell != CourseGrid::kOutside) {
    closed_[cell] = 1;
    graph_.set_obstacle(cell, true);
  }
}

// The cell at `p`, or the free one nearest to it; of two as near, that on the side that wins ties.
std::uint32_t ReplanningPolicy::nearest_free(Point p, const Outlook& now) const noexcept {
  const CourseGrid& grid = graph_.grid();
  const GridCell here = grid.clamped(grid.cell_at(p));
  std::uint32_t best = grid.index(here);
  if (graph_.is_free(best)) {
    return best;
  }
  double nearest_m = std::numeric_limits<double>::infinity();
  double best_aside_m = 0.0;
  for (const GridCell offset : near_) {
    const std::uint32_t index = grid.index(here + offset);
    if (index == CourseGrid::kOutside || !graph_.is_free(index)) {
      continue;
    }
    const Point away = grid.centre(here + offset) - p;
    const double aside_m = now.side * cross(now.body.ahead, away);
    const double away_m = norm(away);
    if (away_m < nearest_m || (away_m == nearest_m && aside_m > best_aside_m)) {
      best = index;
      nearest_m = away_m;
      best_aside_m = aside_m;
    }
  }
  return best;
}

// A point of the way to G; G itself where it is near, or where there is no way.
Point ReplanningPolicy::route_point(const Outlook& now, Point goal) noexcept {
  const double lookahead_m = pilot_.parameters().lookahead_m;
  if (distance(now.body.origin, goal) <= lookahead_m) {
    return goal;
  }
  const std::uint32_t goal_cell = nearest_free(goal, now);
  if (goal_cell != goal_) {
    goal_ = goal_cell;
    graph_.set_goal(goal_cell);
  }
  const std::uint32_t start = nearest_free(now.body.origin, now);
  if (graph_.plan(start) == kBlocked) {
    if (since_forgotten_ >= forget_steps_) {
      forget();
    }
    return goal;
  }
  return graph_.ahead(lookahead_m, now.side);
}

Command ReplanningPolicy::pursue(const Outlook& now, Point target) noexcept {
  const Point local = now.body.to_body(target);
  const double bearing_rad = bearing_of(local);
  const double speed_mps = pilot_.cautious_speed(now.depth);
  if (std::abs(bearing_rad) > 0.5 * std::numbers::pi) {
    return pilot_.steer(now, bearing_rad, speed_mps);
  }
  // The arc from the heading through the target has the curvature 2 y / d^2.
  const double square_m2 = std::fmax(dot(local, local), 1e-6);
  return pilot_.drive(speed_mps, speed_mps * (2.0 * local.y_m / square_m2));
}

Command ReplanningPolicy::step(const Senses& senses) noexcept {
  Outlook now;
  const auto settled = pilot_.begin(senses, now);
  if (now.whole) {
    since_forgotten_ = std::min(since_forgotten_ + 1, forget_steps_);
    grid_.take(now);
    memory_.take(now, senses);
    take_obstacles();
    take_levels(now);
    if (now.gave_up) {
      close_ahead(now);
    }
  }
  if (settled) {
    return *settled;
  }
  const Point target = route_point(now, senses.goal);
  if (now.held_turn_rad) {
    return pilot_.steer(now, *now.held_turn_rad, pilot_.cautious_speed(now.depth));
  }
  return pursue(now, target);
}

}  // namespace tcert::policies
