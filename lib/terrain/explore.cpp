#include <algorithm>
#include <limits>
#include <terrain/components.hpp>
#include <terrain/controller.hpp>
#include <terrain/explore.hpp>
#include <terrain/explore_checks.hpp>
#include <terrain/model_choices.hpp>
#include <terrain/projection.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

class Run {
 public:
  Run(const Terrain& terrain, const ExploreSetup& setup, const Observer& observe)
      : terrain_(terrain),
        setup_(setup),
        observe_(observe),
        planner_(terrain.grid, setup.rules, setup.prior, setup.seeds),
        choices_(setup),
        robot_(position(setup.start)) {
    if (!setup.blocked.empty()) {
      planner_.set_blocked(setup.blocked);
    }
    result_.path.push_back(robot_);
  }

  ExploreResult run() {
    for (const Measurement& m : setup_.known) {
      planner_.add(m);
    }
    for (const Cell c : setup_.first_cells) {
      planner_.add({position(c), terrain_.at(c)});
    }
    measure();
    for (int step = 0;; ++step) {
      choices_.renew(planner_);
      planner_.plan(setup_.goal, nearest_cell(robot_));
      record(step);
      if (const auto end = finished(step)) {
        result_.end = *end;
        note_frontier();
        return std::move(result_);
      }
      go(target());
      measure();
    }
  }

 private:
  void measure() {
    const Cell c = nearest_cell(robot_);
    last_ = {robot_, terrain_.at(c)};
    if (setup_.rules.kind == RuleSet::certified && already_measured(c)) {
      return;
    }
    visit(c);
    planner_.add(last_);
  }

  [[nodiscard]] bool already_measured(Cell c) const {
    const auto& known = planner_.measurements();
    return std::any_of(
        known.begin(), known.end(), [&](const Measurement& m) { return m.at == position(c); });
  }

  void visit(Cell c) {
    if (terrain_.at(c) < setup_.rules.threshold) {
      ++unsafe_visits_;
    }
  }

  void record(int step) {
    const Plan& plan = planner_.last_plan();
    ExploreStep s;
    s.step = step;
    s.at = last_.at;
    s.value = last_.value;
    s.safe = plan.safe;
    s.expanders = plan.expanders;
    s.next = plan.next;
    s.lower = plan.lower;
    s.upper = plan.upper;
    s.lipschitz = planner_.rules().lipschitz;
    s.travelled = travelled_;
    s.unsafe_visits = unsafe_visits_;
    const CellSet ground = planner_.ground();
    for (std::size_t i = 0; i < terrain_.values.size(); ++i) {
      const bool unsafe = ground[i] != 0 && terrain_.values[i] < setup_.rules.threshold;
      s.unsafe_certified += unsafe ? 1U : 0U;
    }
    result_.most_unsafe_certified = std::max(result_.most_unsafe_certified, s.unsafe_certified);
    if (setup_.goal) {
      s.certificate = widest_route(terrain_.grid,
                                   ground,
                                   planner_.proven(),
                                   setup_.rules.threshold,
                                   setup_.start,
                                   *setup_.goal);
    }
    result_.steps.push_back(s);
    if (observe_) {
      observe_(planner_, result_.steps.back(), result_);
    }
  }

  [[nodiscard]] std::optional<End> finished(int step) {
    const CellSet ground = planner_.ground();
    if (planner_.last_plan().safe == 0) {
      return End::empty_safe_set;
    }
    const Cell here = nearest_cell(robot_);
    if (setup_.rules.kind == RuleSet::certified && ground[terrain_.grid.index(here)] == 0) {
      return End::stranded;
    }
    if (is_joined_to_goal(ground, here) && deep_enough(step)) {
      go(*setup_.goal);
      result_.steps.back().travelled = travelled_;
      result_.steps.back().unsafe_visits = unsafe_visits_;
      return End::reached;
    }
    const bool over = step >= setup_.max_steps;
    if (planner_.last_plan().next && !over) {
      return std::nullopt;
    }
    if (is_joined_to_goal(ground, here)) {
      return End::goal_at_edge;
    }
    if (planner_.last_plan().next) {
      return End::step_limit;
    }
    if (ground[terrain_.grid.index(here)] == 0) {
      return End::stranded;
    }
    return setup_.goal ? what_forbids(terrain_, setup_) : End::explored;
  }

  [[nodiscard]] bool is_joined_to_goal(const CellSet& ground, Cell here) const {
    return setup_.goal && are_joined(terrain_.grid, ground, here, *setup_.goal);
  }

  /// The published program stops only when the goal lies deep within the outline, but for the first
  /// plan.
  [[nodiscard]] bool deep_enough(int step) const {
    if (setup_.rules.kind != RuleSet::published || step == 0) {
      return true;
    }
    return projected_inwards(terrain_.grid, planner_.safe(), *setup_.goal, setup_.simplification) ==
           setup_.goal;
  }

  /// Where the next measurement is to be taken.
  [[nodiscard]] Cell target() const {
    Cell wanted = *planner_.last_plan().next;
    if (setup_.rules.kind != RuleSet::published) {
      return wanted;
    }
    const Cell here = nearest_cell(robot_);
    CellSet ground = planner_.ground();
    if (is_joined_to_goal(ground, here)) {
      wanted = *setup_.goal;
    }
    if (!setup_.blocked.empty()) {
      ground = component_of(terrain_.grid, ground, here);
    }
    const Cell inwards =
        projected_inwards(terrain_.grid, ground, wanted, setup_.simplification).value_or(wanted);
    // Holes are filled, as published, but nobody goes onto what is blocked.
    return setup_.blocked.empty() || ground[terrain_.grid.index(inwards)] != 0 ? inwards : wanted;
  }

  void go(Cell to) {
    if (setup_.motion == Motion::reactive) {
      react(to);
    }
    const Cell from = nearest_cell(robot_);
    std::vector<Cell> route;
    if (setup_.motion != Motion::jump) {
      route = shortest_route(terrain_.grid, planner_.ground(), from, to);
    }
    if (route.empty()) {
      route = {from, to};
    }
    for (std::size_t k = 1; k < route.size(); ++k) {
      // The end is visited by the measurement there, if there is one.
      if (k + 1 < route.size() || to == setup_.goal) {
        visit(route[k]);
      }
      result_.path.push_back(position(route[k]));
    }
    const double length = route_length(route);
    travelled_ += length;
    ++result_.ways;
    result_.route_cells += length;
    robot_ = position(to);
  }

  /// As far as the controller brings the robot; a route does the rest.
  void react(Cell to) {
    ControllerOptions options;
    options.robot_radius = setup_.robot_radius;
    options.simplification = setup_.simplification;
    const ReactiveWay way =
        reactive_way(terrain_.grid, planner_.ground(), robot_, position(to), options);
    result_.free_space = way.free_space;
    Cell before = nearest_cell(robot_);
    for (std::size_t k = 1; k < way.path.size(); ++k) {
      const Cell c = nearest_cell(way.path[k]);
      const double length = (way.path[k] - way.path[k - 1]).norm();
      travelled_ += length;
      result_.controller_cells += length;
      if (!(c == before)) {
        visit(c);
        before = c;
      }
      result_.path.push_back(way.path[k]);
    }
    result_.controller_fallbacks += way.arrived ? 0U : 1U;
    robot_ = position(before);
  }

  void note_frontier() {
    result_.frontier = robot_;
    if (!setup_.goal) {
      return;
    }
    const CellSet reach = component_of(terrain_.grid, planner_.ground(), nearest_cell(robot_));
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < reach.size(); ++i) {
      const double d2 = squared_distance(terrain_.grid.cell(i), *setup_.goal);
      if (reach[i] != 0 && d2 < best) {
        best = d2;
        result_.frontier = position(terrain_.grid.cell(i));
      }
    }
  }

  const Terrain& terrain_;
  const ExploreSetup& setup_;
  const Observer& observe_;
  Planner planner_;
  ModelChoices choices_;
  ExploreResult result_;
  Position robot_;
  Measurement last_;
  double travelled_ = 0.0;
  std::size_t unsafe_visits_ = 0;
};

}  // namespace

ExploreResult explore(const Terrain& terrain, const ExploreSetup& setup, const Observer& observe) {
  require_explorable(terrain, setup);
  return Run(terrain, setup, observe).run();
}

}  // namespace tcert::terrain
