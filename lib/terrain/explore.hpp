#pragma once
/// \file
/// The exploration loop: measure, plan, move, until the goal is connected or no cell helps.

#include <functional>
#include <optional>
#include <string_view>
#include <terrain/field_scale.hpp>
#include <terrain/planner.hpp>
#include <vector>

namespace tcert::terrain {

/// The ground truth that a simulated robot feels, one value a cell. Those of blocked cells are not
/// looked at and may be NaN.
struct Terrain {
  Grid grid;
  std::vector<double> values;
  std::vector<double> felt{};  ///< What a measurement says, if that is not the value; or empty.

  [[nodiscard]] double at(Cell c) const { return values[grid.index(c)]; }
  [[nodiscard]] double felt_at(Cell c) const { return felt.empty() ? at(c) : felt[grid.index(c)]; }
};

/// How the robot comes from one measurement to the next.
enum class Motion {
  jump,      ///< It is there: decisions alone are studied.
  route,     ///< The shortest way over cells of S_t.
  reactive,  ///< The diffeomorphic controller; a route finishes where it stands still.
  pursuit,   ///< Line-of-sight pursuit of that route: see pursuit_way().
};

[[nodiscard]] std::string_view to_string(Motion motion) noexcept;
[[nodiscard]] std::optional<Motion> motion_from(std::string_view word) noexcept;

/// The length scale is chosen anew, by marginal likelihood, whenever the measurements have doubled.
struct AdaptivePrior {
  bool on = false;
  std::vector<double> factors{0.5, 0.7071067811865476, 1.0, 1.4142135623730951, 2.0};
  std::size_t first = 16;  ///< Measurements before the first choice.
};

/// What is known of every cell at the end; NaN where nothing is.
struct Layers {
  CellSet safe;      ///< S_t without blocked cells.
  CellSet standing;  ///< Where the body stands on it.
  std::vector<double>
      lower;  ///< l_t as the certificate takes it: under `certified` without the model.
  std::vector<double> upper;  ///< u_t likewise.
  std::vector<double> mean;   ///< Of the model.
  std::vector<double> sd;
  std::vector<double> certificate;  ///< Of the start and the cell: see widest_field().
};

struct ExploreSetup {
  Rules rules;
  GpPrior prior;
  Cell start;
  std::optional<Cell> goal;        ///< None: explore.
  std::vector<Cell> more_goals;    ///< Gone to in turn, once `goal` is reached.
  std::vector<Cell> first_cells;   ///< Measured before the first step, the start not among them.
  std::vector<Measurement> known;  ///< Of an earlier run.
  std::vector<Cell> seeds;         ///< S_0.
  CellSet blocked;                 ///< Physical obstacles and gaps of the terrain; empty: none.
  int max_steps = 2000;            ///< Measurements after the first batch.
  Motion motion = Motion::route;
  double robot_radius = 2.0;
  double simplification = 4.0;  ///< Tolerance of outlines and depth of sub-goals (`published`).
  /// `reactive`, not `published`: the controller drives between the nearest cells so deep within
  /// the ground, and routes lead there and away.
  double sub_goal_depth = 0.0;
  Body body;  ///< What must be certified for the robot to stand.
  AdaptivePrior adaptive;
  bool wants_layers = false;  ///< See ExploreResult::layers.
  /// Confidence of FieldScale's bounds, of which `band` has its scale and, unless it is 0,
  /// `certified` its Lipschitz constant, which then falls as more is measured.
  double confidence = 0.0;
  /// The prior's variance follows the Lipschitz constant that is bounded: see variance_of().
  bool prior_follows_lipschitz = false;
  double noise_sd = 0.0;   ///< Of a measurement, for these bounds.
  GradientPrior gradient;  ///< Declared for these bounds, from earlier ground.
};

enum class End {
  reached,   ///< The goal, the last if there are several, is safe and joined to the robot.
  explored,  ///< There is no goal, and no cell within reach can make the safe set grow.
  /// No cell within reach can make the safe set grow; under `certified` the measurements and the
  /// Lipschitz constant alone say so, not the model. All that a robot can know;
  exhausted,
  // of a terrain that is known, it says itself what stands in the way:
  not_reachable,   ///< No way from start to goal keeps the threshold.
  past_obstacles,  ///< Ways that keep it lead over blocked cells alone.
  only_body,       ///< Ways that keep it past blocked cells are too narrow for the body.
  only_lipschitz,  ///< `certified`: there is a way, but none that this constant certifies.
  only_rules,      ///< Other rules: there is a way, but these rules do not find it.
  /// `published`: the goal is safe and joined to the robot, but not so deep within the outline as
  /// these rules want it.
  goal_at_edge,
  step_limit,
  empty_safe_set,  ///< Nothing is safe: the published program dies here.
  stranded,        ///< The ground under the robot is no longer certified.
};

[[nodiscard]] std::string_view to_string(End end) noexcept;

/// State after a measurement and the planning that followed. Row 0 is after the first batch; of the
/// last one `travelled` and `unsafe_visits` include the way to the goal.
struct ExploreStep {
  int step = 0;
  Position at{0.0, 0.0};  ///< Where the measurement was taken.
  double value = 0.0;
  std::size_t safe = 0;
  std::size_t expanders = 0;
  std::optional<Cell> next;
  double lower = 0.0;  ///< Of the next sample; meaningless without one.
  double upper = 0.0;
  /// Over S_t from the start, or the goal before, to the goal; none until they are joined.
  std::optional<double> certificate;
  double lipschitz = 0.0;
  double travelled = 0.0;            ///< Cells, since the start.
  std::size_t unsafe_certified = 0;  ///< Cells of S_t whose true value is below h.
  std::size_t unsafe_visits = 0;     ///< Steps onto such cells so far, measured or walked over.
};

struct ExploreResult {
  End end = End::step_limit;
  std::vector<ExploreStep> steps;
  std::vector<Position> path;
  std::vector<Position> free_space;  ///< Local free space of the controller when it last set out.
  std::size_t most_unsafe_certified = 0;
  std::size_t goals_reached = 0;
  std::size_t ways = 0;  ///< From one cell to the next that was chosen, or to the goal.
  /// `reactive`: ways whose end the controller did not come to within a cell; a route went the
  /// rest.
  std::size_t controller_fallbacks = 0;
  double controller_cells = 0.0;  ///< Length of the way gone by the controller.
  double route_cells = 0.0;       ///< Length of the way gone by routes.
  Position frontier{0.0, 0.0};    ///< The cell within reach that is nearest to the goal.
  std::optional<Layers> layers;   ///< If they were wanted.
  Cell goal;                      ///< The last that was looked for; meaningless without one.

  [[nodiscard]] const ExploreStep& last() const { return steps.back(); }
};

using Observer = std::function<void(const Planner&, const ExploreStep&, const ExploreResult&)>;

/// Runs until the goal is connected or nothing more can be done. `observe` sees every step.
/// \throws std::invalid_argument if the start or the goal lies outside the grid or on a blocked
/// cell, the start is known to be unsafe, a value that may be felt is not within +-1e30, or the
/// setup is not within its limits.
[[nodiscard]] ExploreResult explore(const Terrain& terrain,
                                    const ExploreSetup& setup,
                                    const Observer& observe = {});

}  // namespace tcert::terrain
