#include <algorithm>
#include <cmath>
#include <limits>
#include <terrain/components.hpp>
#include <terrain/explore_checks.hpp>
#include <terrain/explorer.hpp>
#include <terrain/projection.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] const ExploreSetup& valid(const Grid& grid, const ExploreSetup& setup) {
  require_valid(grid, setup);
  return setup;
}

[[nodiscard]] bool certifies(RuleSet kind) {
  return kind == RuleSet::certified || kind == RuleSet::band;
}

}  // namespace

Explorer::Explorer(const Grid& grid, const ExploreSetup& setup)
    : setup_(valid(grid, setup)),
      planner_(grid, setup.rules, setup.prior, setup.seeds),
      choices_(setup),
      goal_(setup.goal),
      leg_start_(setup.start),
      robot_(position(setup.start)) {
  planner_.set_body(setup.body);
  if (!setup.blocked.empty()) {
    planner_.set_blocked(setup.blocked);
  }
  for (const Measurement& m : setup.known) {
    planner_.add(m);
  }
}

bool Explorer::asks_for(Cell c) const {
  const auto& known = planner_.measurements();
  return !certifies(setup_.rules.kind) ||
         std::none_of(
             known.begin(), known.end(), [&](const Measurement& m) { return m.at == position(c); });
}

void Explorer::place(const Position& robot) {
  travelled_ += (robot - robot_).norm();
  robot_ = robot;
}

const ExploreStep& Explorer::plan(int step, const Measurement& last) {
  choices_.renew(planner_);
  const Plan& plan = planner_.plan(goal_, nearest_cell(robot_));
  row_ = {};
  row_.step = step;
  row_.at = last.at;
  row_.value = last.value;
  row_.safe = plan.safe;
  row_.expanders = plan.expanders;
  row_.next = plan.next;
  row_.lower = plan.lower;
  row_.upper = plan.upper;
  row_.lipschitz = planner_.rules().lipschitz;
  row_.travelled = travelled_;
  if (goal_) {
    row_.certificate = widest_route(planner_.grid(),
                                    planner_.standing(),
                                    proven_under_body(),
                                    setup_.rules.threshold,
                                    leg_start_,
                                    *goal_);
  }
  return row_;
}

std::vector<double> Explorer::proven_under_body() const {
  return least_under(planner_.grid(), planner_.proven(), planner_.standing(), planner_.footprint());
}

Layers Explorer::layers() const {
  const auto known = [](std::span<const double> values) {
    std::vector<double> finite(values.begin(), values.end());
    for (double& v : finite) {
      v = std::isfinite(v) ? v : std::numeric_limits<double>::quiet_NaN();
    }
    return finite;
  };
  const bool is_band = setup_.rules.kind == RuleSet::band;
  const double scale =
      is_band ? planner_.field_variance() / planner_.model().prior().variance : 1.0;
  std::vector<double> sd = known(planner_.model().variance());
  for (double& v : sd) {
    v = std::sqrt(std::max(v, 0.0) * scale);
  }
  return {planner_.ground(),
          planner_.standing(),
          known(planner_.proven()),
          known(planner_.possible()),
          known(planner_.model().mean()),
          known(sd),
          known(widest_field(planner_.grid(),
                             planner_.standing(),
                             proven_under_body(),
                             setup_.rules.threshold,
                             setup_.start))};
}

std::optional<End> Explorer::end(int step) const {
  const Plan& plan = planner_.last_plan();
  if (plan.safe == 0) {
    return End::empty_safe_set;
  }
  const bool stands = planner_.standing()[planner_.grid().index(nearest_cell(robot_))] != 0;
  const bool has_body = !planner_.footprint().is_point();
  if ((certifies(setup_.rules.kind) || has_body) && !stands) {
    return End::stranded;
  }
  const bool joined = is_joined_to_goal();
  if (joined && deep_enough(step)) {
    return End::reached;
  }
  if (plan.next && step < setup_.max_steps) {
    return std::nullopt;
  }
  if (joined) {
    return End::goal_at_edge;
  }
  if (plan.next) {
    return End::step_limit;
  }
  if (!stands) {
    return End::stranded;
  }
  return goal_ ? End::exhausted : End::explored;
}

bool Explorer::is_joined_to_goal() const {
  return goal_ && are_joined(planner_.grid(), planner_.standing(), nearest_cell(robot_), *goal_);
}

/// The published program stops only when the goal lies deep within the outline, but for the first
/// plan.
bool Explorer::deep_enough(int step) const {
  if (setup_.rules.kind != RuleSet::published || step == 0) {
    return true;
  }
  return projected_inwards(planner_.grid(), planner_.safe(), *goal_, setup_.simplification) ==
         goal_;
}

Cell Explorer::target() const {
  Cell wanted = *planner_.last_plan().next;
  if (setup_.rules.kind != RuleSet::published) {
    return wanted;
  }
  const Grid& grid = planner_.grid();
  const bool only_reachable = !setup_.blocked.empty() || !planner_.footprint().is_point();
  CellSet ground = planner_.standing();
  if (is_joined_to_goal()) {
    wanted = *goal_;
  }
  if (only_reachable) {
    ground = component_of(grid, ground, nearest_cell(robot_));
  }
  const Cell inwards =
      projected_inwards(grid, ground, wanted, setup_.simplification).value_or(wanted);
  // Holes are filled, as published, but nobody goes onto what is blocked.
  return !only_reachable || ground[grid.index(inwards)] != 0 ? inwards : wanted;
}

Way Explorer::go() { return follow(target()); }

Way Explorer::go_to_goal() { return follow(*goal_); }

Way Explorer::follow(Cell to) {
  Way way = way_to(planner_.grid(), planner_.standing(), robot_, to, to == goal_, setup_);
  for (const double step : way.driven) {
    travelled_ += step;
  }
  travelled_ += way.walked;
  robot_ = position(to);
  return way;
}

bool Explorer::take_next_goal() {
  if (goals_taken_ == setup_.more_goals.size()) {
    return false;
  }
  leg_start_ = *goal_;
  goal_ = setup_.more_goals[goals_taken_++];
  return true;
}

Position Explorer::frontier() const {
  if (!goal_) {
    return robot_;
  }
  const Grid& grid = planner_.grid();
  const CellSet reach = component_of(grid, planner_.standing(), nearest_cell(robot_));
  Position frontier = robot_;
  double best = kUnbounded;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const double d2 = squared_distance(grid.cell(i), *goal_);
    if (reach[i] != 0 && d2 < best) {
      best = d2;
      frontier = position(grid.cell(i));
    }
  }
  return frontier;
}

}  // namespace tcert::terrain
