#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <terrain/components.hpp>
#include <terrain/controller.hpp>
#include <terrain/explore.hpp>
#include <terrain/limits.hpp>
#include <terrain/lipschitz.hpp>
#include <terrain/projection.hpp>
#include <terrain/routes.hpp>

namespace tcert::terrain {
namespace {

constexpr std::array<std::string_view, 3> kMotions{"jump", "route", "reactive"};

[[nodiscard]] std::string text_of(Cell c) {
  return "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")";
}

class Run {
 public:
  Run(const Terrain& terrain, const ExploreSetup& setup, const Observer& observe)
      : terrain_(terrain),
        setup_(setup),
        observe_(observe),
        planner_(terrain.grid, setup.rules, setup.prior, setup.seeds),
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
      adapt();
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

  /// Doubles: the length scale and the Lipschitz constant are chosen anew.
  void adapt() {
    const std::size_t n = planner_.measurements().size();
    if (n < next_choice_) {
      return;
    }
    next_choice_ = std::max(setup_.adaptive.first, 2 * n);
    if (setup_.lipschitz_confidence > 0.0) {
      estimate_anew();
    }
    if (setup_.adaptive.on && n >= setup_.adaptive.first) {
      choose_length_scale();
    }
  }

  /// Raises the Lipschitz constant where the measurements ask for it. Never lowers it: where they
  /// were taken depends on what was measured before. Without a further place nothing new is known,
  /// and no risk is taken.
  void estimate_anew() {
    const double confidence = confidence_of_estimate(setup_.lipschitz_confidence, estimates_ + 1);
    const LipschitzEstimate estimate = estimate_lipschitz(terrain_.grid,
                                                          planner_.measurements(),
                                                          planner_.model().prior().length_scale,
                                                          setup_.rules.noise_bound,
                                                          confidence);
    if (estimate.patches <= patches_) {
      return;
    }
    ++estimates_;
    patches_ = estimate.patches;
    if (estimate.constant > planner_.rules().lipschitz) {
      planner_.set_lipschitz(estimate.constant);
    }
  }

  void choose_length_scale() {
    GpPrior best = planner_.model().prior();
    double highest = planner_.model().log_likelihood();
    for (const double factor : setup_.adaptive.factors) {
      GpPrior prior = setup_.prior;
      prior.length_scale *= factor;
      const double likelihood = log_likelihood(prior, planner_.measurements());
      if (likelihood > highest) {
        highest = likelihood;
        best = prior;
      }
    }
    if (best != planner_.model().prior()) {
      planner_.change_prior(best);
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
    if (setup_.goal && ground[terrain_.grid.index(*setup_.goal)] != 0 && joined(ground, here) &&
        deep_enough(step)) {
      go(*setup_.goal);
      result_.steps.back().travelled = travelled_;
      result_.steps.back().unsafe_visits = unsafe_visits_;
      return End::reached;
    }
    const bool over = step >= setup_.max_steps;
    if (planner_.last_plan().next && !over) {
      return std::nullopt;
    }
    if (setup_.goal && ground[terrain_.grid.index(*setup_.goal)] != 0 && joined(ground, here)) {
      return End::goal_at_edge;
    }
    if (planner_.last_plan().next) {
      return End::step_limit;
    }
    if (ground[terrain_.grid.index(here)] == 0) {
      return End::stranded;
    }
    return setup_.goal ? what_forbids() : End::explored;
  }

  /// What stands between start and goal, by the terrain itself.
  [[nodiscard]] End what_forbids() const {
    CellSet good(terrain_.grid.size());
    for (std::size_t i = 0; i < good.size(); ++i) {
      // What a gap holds is not known: it may be good.
      good[i] = terrain_.values[i] < setup_.rules.threshold ? 0 : 1;
    }
    if (!goal_joined_over(good)) {
      return End::not_reachable;
    }
    for (std::size_t i = 0; i < setup_.blocked.size(); ++i) {
      good[i] = setup_.blocked[i] != 0 ? 0 : good[i];
    }
    if (!goal_joined_over(good)) {
      return End::past_obstacles;
    }
    return setup_.rules.kind == RuleSet::certified ? End::only_lipschitz : End::only_rules;
  }

  [[nodiscard]] bool goal_joined_over(const CellSet& set) const {
    return component_of(terrain_.grid, set, setup_.start)[terrain_.grid.index(*setup_.goal)] != 0;
  }

  [[nodiscard]] bool joined(const CellSet& ground, Cell here) const {
    return component_of(terrain_.grid, ground, here)[terrain_.grid.index(*setup_.goal)] != 0;
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
    if (setup_.goal && ground[terrain_.grid.index(*setup_.goal)] != 0 && joined(ground, here)) {
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
  ExploreResult result_;
  Position robot_;
  Measurement last_;
  double travelled_ = 0.0;
  std::size_t unsafe_visits_ = 0;
  std::size_t next_choice_ = 0;
  int estimates_ = 0;
  int patches_ = 0;
};

void require_inside(const Grid& grid, const CellSet& blocked, Cell c, const std::string& who) {
  if (!grid.contains(c)) {
    throw std::invalid_argument("the " + who + " " + text_of(c) + " lies outside the terrain of " +
                                std::to_string(grid.rows) + " x " + std::to_string(grid.columns) +
                                " cells");
  }
  if (!blocked.empty() && blocked[grid.index(c)] != 0) {
    throw std::invalid_argument("the " + who + " " + text_of(c) +
                                " lies in a physical obstacle or a gap of the terrain");
  }
}

void require_valid(const Terrain& terrain, const ExploreSetup& setup) {
  const Grid& grid = terrain.grid;
  if (terrain.values.size() != grid.size() ||
      (!setup.blocked.empty() && setup.blocked.size() != grid.size())) {
    throw std::invalid_argument("terrain and obstacles need one value a cell");
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool felt = setup.blocked.empty() || setup.blocked[i] == 0;
    if (felt && !(std::abs(terrain.values[i]) <= kLargestValue)) {
      throw std::invalid_argument("the value at " + text_of(grid.cell(i)) +
                                  " is not a number within +-1e30; block the cell if it is a gap");
    }
  }
  require_within("max-steps", setup.max_steps);
  require_within("robot-radius", setup.robot_radius);
  require_within("simplification", setup.simplification);
}

}  // namespace

std::string_view to_string(Motion motion) noexcept {
  return kMotions[static_cast<std::size_t>(motion)];
}

std::optional<Motion> motion_from(std::string_view word) noexcept {
  const auto found = std::find(kMotions.begin(), kMotions.end(), word);
  if (found == kMotions.end()) {
    return std::nullopt;
  }
  return static_cast<Motion>(found - kMotions.begin());
}

std::string_view to_string(End end) noexcept {
  switch (end) {
    case End::reached:
      return "reached";
    case End::explored:
      return "explored: no cell can make the ground grow";
    case End::not_reachable:
      return "not reachable at this threshold";
    case End::past_obstacles:
      return "not reachable at this threshold past the obstacles and gaps";
    case End::only_lipschitz:
      return "not certified: only the Lipschitz constant forbids it";
    case End::only_rules:
      return "not certified: only the rule set forbids it";
    case End::goal_at_edge:
      return "the goal is certified and joined, but not deep enough within the outline";
    case End::step_limit:
      return "step limit";
    case End::empty_safe_set:
      return "empty safe set";
    case End::stranded:
      break;
  }
  return "stranded";
}

ExploreResult explore(const Terrain& terrain, const ExploreSetup& setup, const Observer& observe) {
  require_valid(terrain, setup);
  require_inside(terrain.grid, setup.blocked, setup.start, "start");
  if (setup.goal) {
    require_inside(terrain.grid, setup.blocked, *setup.goal, "goal");
  }
  for (const Cell c : setup.first_cells) {
    require_inside(terrain.grid, setup.blocked, c, "first measurement");
  }
  if (setup.rules.kind == RuleSet::certified &&
      terrain.at(setup.start) - setup.rules.noise_bound < setup.rules.threshold) {
    throw std::invalid_argument(
        "the start " + text_of(setup.start) +
        " stands on unsafe ground: " + std::to_string(terrain.at(setup.start)) +
        " less the noise bound is below the threshold " + std::to_string(setup.rules.threshold));
  }
  return Run(terrain, setup, observe).run();
}

}  // namespace tcert::terrain
