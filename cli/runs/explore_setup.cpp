#include "cli/runs/explore_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <table/random.hpp>
#include <terrain/limits.hpp>
#include <terrain/lipschitz.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/explore_flags.hpp"
#include "cli/runs/explore_values.hpp"
#include "cli/runs/progress.hpp"

namespace tcert::cli {
namespace {

using terrain::Cell;
using terrain::Measurement;
using terrain::RuleSet;
using terrain::Terrain;

/// Whether nobody is to measure at a cell.
[[nodiscard]] bool is_blocked(const Terrain& terrain, const terrain::CellSet& blocked, Cell c) {
  return !blocked.empty() && blocked[terrain.grid.index(c)] != 0;
}

/// The cells within `radius` of the start that are not blocked, the start not among them.
[[nodiscard]] std::vector<Cell> cells_round(const Terrain& terrain,
                                            const terrain::CellSet& blocked,
                                            Cell start,
                                            int radius) {
  std::vector<Cell> cells;
  for (int x = start.x - radius; x <= start.x + radius; ++x) {
    for (int y = start.y - radius; y <= start.y + radius; ++y) {
      const Cell c{x, y};
      if (terrain.grid.contains(c) && !(c == start) &&
          squared_distance(c, start) <= radius * radius && !is_blocked(terrain, blocked, c)) {
        cells.push_back(c);
      }
    }
  }
  return cells;
}

/// The published program's 50 draws round the start; those below the threshold are discarded, and
/// those that are blocked.
[[nodiscard]] std::vector<Cell> published_batch(const Terrain& terrain,
                                                const terrain::CellSet& blocked,
                                                Cell start,
                                                double threshold,
                                                std::int64_t seed) {
  constexpr std::uint32_t kPurpose = 0x7e44ba;
  constexpr int kReach = 20;
  constexpr int kDraws = 50;
  table::RandomStream random(static_cast<std::uint64_t>(seed), kPurpose, 0);
  const auto draw = [&](int centre, int limit) {
    const int low = std::max(0, centre - kReach);
    const int high = std::min(limit, centre + kReach);
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low)));
  };
  std::vector<Cell> cells;
  for (int k = 0; k < kDraws; ++k) {
    const int x = draw(start.x, terrain.grid.rows);
    const int y = draw(start.y, terrain.grid.columns);
    if (!is_blocked(terrain, blocked, {x, y}) && terrain.at({x, y}) >= threshold) {
      cells.push_back({x, y});
    }
  }
  return cells;
}

[[nodiscard]] std::vector<Measurement> measured(const Terrain& terrain,
                                                const std::vector<Cell>& cells) {
  std::vector<Measurement> measurements;
  measurements.reserve(cells.size());
  for (const Cell c : cells) {
    measurements.push_back({terrain::position(c), terrain.at(c)});
  }
  return measurements;
}

/// What is measured first of all, the start among them. \throws BadData if it is not safe.
[[nodiscard]] std::vector<Measurement> safe_start(const terrain::ExploreSetup& setup,
                                                  const Terrain& terrain) {
  std::vector<Cell> around = setup.first_cells;
  around.push_back(setup.start);
  for (const Cell c : around) {
    if (terrain.at(c) - setup.rules.noise_bound < setup.rules.threshold) {
      throw BadData(
          fmt::format("the ground round the start is not safe: {}{} at ({}, {}) is below "
                      "the threshold {}; start elsewhere or lower --start-radius",
                      terrain.at(c),
                      setup.rules.noise_bound > 0.0
                          ? fmt::format(" less --noise-bound {}", setup.rules.noise_bound)
                          : std::string(),
                      c.x,
                      c.y,
                      setup.rules.threshold));
    }
  }
  std::vector<Measurement> first = setup.known;
  const std::vector<Measurement> now = measured(terrain, around);
  first.insert(first.end(), now.begin(), now.end());
  return first;
}

/// The bound that the exploration itself begins with.
[[nodiscard]] terrain::FieldScale scale_of(const terrain::ExploreSetup& setup,
                                           double length_scale,
                                           const std::vector<Measurement>& first) {
  terrain::FieldScale scale({length_scale, setup.noise_sd, setup.confidence, setup.gradient});
  for (const Measurement& m : first) {
    scale.add(m);
  }
  (void)scale.renew();
  return scale;
}

/// The Lipschitz constant that the first measurements bound. \throws UsageError, BadData.
[[nodiscard]] double first_bound(const terrain::ExploreSetup& setup,
                                 const std::vector<Measurement>& first,
                                 const terrain::Grid& grid,
                                 Progress& progress) {
  const terrain::FieldScale scale = scale_of(setup, setup.prior.length_scale, first);
  const double bound = std::max(scale.lipschitz_bound(grid),
                                terrain::steepest_measured(first, setup.rules.noise_bound));
  if (!std::isfinite(bound) || !(bound > 0.0)) {
    throw UsageError("the Lipschitz constant cannot be estimated from " +
                     std::to_string(first.size()) +
                     " measurements; give it with --lipschitz or raise --start-radius");
  }
  if (const double least = terrain::limit_of("lipschitz").low; bound < least) {
    throw BadData(
        fmt::format("the slopes of the terrain are too small to reckon with: {:.3g} per cell, at "
                    "least {:g} is "
                    "needed; multiply its values",
                    bound,
                    least));
  }
  progress.say(
      fmt::format("Lipschitz constant {:.4g} per cell at {:g} % confidence, from {} measurements; "
                  "it falls as more is measured. That takes the terrain for a Gaussian field of "
                  "length scale {:g} cells (--kernel-length-scale).",
                  bound,
                  100.0 * setup.confidence,
                  first.size(),
                  setup.prior.length_scale));
  return bound;
}

/// What no error of so many measurements exceeds with the confidence, if each is Gaussian.
[[nodiscard]] double noise_bound_of(double sd, double confidence, std::size_t measurements) {
  const double tail =
      (1.0 - confidence) / static_cast<double>(std::max<std::size_t>(measurements, 1));
  double low = 0.0;
  double high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::sqrt(2.0)) > tail ? low : high) = middle;
  }
  return sd * high;
}

/// Lipschitz constant and prior of the certified rules, from what was measured round the start.
void set_certified(terrain::ExploreSetup& setup,
                   const ExploreRequest& o,
                   Progress& progress,
                   const Terrain& terrain) {
  if (o.noise_sd > 0.0 && !is_given(o.given, "noise-bound")) {
    const auto most = static_cast<std::size_t>(setup.max_steps) + setup.first_cells.size() + 1;
    setup.rules.noise_bound = noise_bound_of(o.noise_sd, o.confidence, most);
    progress.say(fmt::format(
        "noise bound {:.4g}: with --noise-sd {:g} all of {} measurements keep it at {:g} % "
        "confidence.",
        setup.rules.noise_bound,
        o.noise_sd,
        most,
        100.0 * o.confidence));
  }
  const std::vector<Measurement> first = safe_start(setup, terrain);
  const double steepest = terrain::steepest_measured(first, setup.rules.noise_bound);
  bool estimated = o.lipschitz.empty() || o.lipschitz == "auto";
  if (!estimated) {
    setup.rules.lipschitz = lipschitz_of(o);
    if (steepest > setup.rules.lipschitz * (1.0 + 1e-9)) {
      estimated = true;
      progress.say(fmt::format(
          "warning: the Lipschitz constant {} is contradicted by the first measurements "
          "({:.3g} per cell); it is estimated instead. Give the terrain's own with "
          "--lipschitz.",
          setup.rules.lipschitz,
          steepest));
    }
  }
  if (estimated) {
    setup.confidence = o.confidence;
    setup.rules.lipschitz = first_bound(setup, first, terrain.grid, progress);
  }
  // The prior's scale is that of the data: a field whose steepest gradient is the constant.
  if (!is_given(o.given, "kernel-variance")) {
    setup.prior.variance =
        terrain::variance_of(terrain.grid, setup.rules.lipschitz, setup.prior.length_scale);
    setup.prior_follows_lipschitz = estimated;
  }
  if (!is_given(o.given, "kernel-mean")) {
    setup.prior.mean = terrain.at(setup.start);
  }
}

/// A field of unit variance, whose scale the exploration bounds.
void set_band(terrain::ExploreSetup& setup,
              const ExploreRequest& o,
              Progress& progress,
              const Terrain& terrain) {
  setup.confidence = o.confidence;
  const double length_scale = o.least_length_scale.value_or(0.5 * o.kernel_length_scale);
  setup.prior = {terrain.at(setup.start), 1.0, length_scale, terrain::kBandNugget, true};
  const terrain::FieldScale scale = scale_of(setup, length_scale, safe_start(setup, terrain));
  progress.say(fmt::format(
      "band of {:.3g} sd, sd at most {:.4g} at {:g} % confidence. It takes the terrain for a "
      "Gaussian field with a squared-exponential covariance of length scale {:g} cells or more: "
      "on rougher ground it holds unsafe cells safe (see --help).",
      setup.rules.band(),
      std::sqrt(scale.variance_bound()),
      100.0 * o.confidence,
      length_scale));
}

/// S_0 is what was measured round the start and found safe.
void set_thesis(terrain::ExploreSetup& setup, const Terrain& terrain, Progress& progress) {
  std::vector<Cell> around = setup.first_cells;
  around.push_back(setup.start);
  const double steepest = terrain::steepest_measured(measured(terrain, around), 0.0);
  if (steepest > setup.rules.lipschitz) {
    progress.say(fmt::format(
        "warning: the Lipschitz constant {:g} is contradicted by the first measurements ({:.3g} "
        "per "
        "cell); Algorithm 1 as printed uses it all the same and may hold any ground safe. Give the "
        "terrain's own with --lipschitz.",
        setup.rules.lipschitz,
        steepest));
  }
  setup.seeds = std::move(around);
  for (const Measurement& m : setup.known) {
    setup.seeds.push_back(terrain::nearest_cell(m.at));
  }
  std::erase_if(setup.seeds, [&](Cell c) { return terrain.at(c) < setup.rules.threshold; });
  if (setup.seeds.empty()) {
    throw BadData("no cell round the start is safe, and Algorithm 1 needs a safe seed set");
  }
}

}  // namespace

Places places_of(const ExploreRequest& o, const terrain::Grid& grid) {
  Places places;
  places.start = cell_of("start", o.start);
  if (o.mode != "explore") {
    places.goals = cells_of("goal", o.goal);
  }
  const auto require_inside = [&](const char* name, Cell cell) {
    if (!grid.contains(cell)) {
      throw UsageError(fmt::format("--{}: ({}, {}) lies outside the terrain of {} x {} cells",
                                   name,
                                   cell.x,
                                   cell.y,
                                   grid.rows,
                                   grid.columns));
    }
  };
  require_inside("start", places.start);
  for (const Cell goal : places.goals) {
    require_inside("goal", goal);
  }
  return places;
}

terrain::ExploreSetup explore_setup(const ExploreRequest& o,
                                    Progress& progress,
                                    const Terrain& terrain,
                                    terrain::CellSet blocked) {
  const Places places = places_of(o, terrain.grid);
  terrain::ExploreSetup setup;
  setup.start = places.start;
  if (!places.goals.empty()) {
    setup.goal = places.goals.front();
    setup.more_goals.assign(places.goals.begin() + 1, places.goals.end());
  }
  setup.blocked = std::move(blocked);
  setup.rules.kind = *terrain::rule_set_from(o.rules);
  setup.rules.threshold = o.threshold;
  setup.rules.beta = o.beta;
  setup.rules.expanders = static_cast<int>(o.expanders);
  setup.rules.noise_bound = o.noise_bound;
  setup.rules.noise_sd = o.noise_sd;
  setup.rules.trust_model = o.trust_model;
  setup.rules.selection = *terrain::selection_from(selection_of(o));
  setup.rules.travel_weight = o.travel_weight;
  setup.rules.horizon = static_cast<int>(o.horizon);
  setup.rules.growth_weight = o.growth_weight;
  setup.prior = {o.kernel_mean, o.kernel_variance, o.kernel_length_scale, o.noise_variance};
  setup.noise_sd = o.noise_sd;
  setup.gradient = gradient_prior_of(o.gradient_prior);
  setup.max_steps = static_cast<int>(o.max_steps);
  setup.motion = *terrain::motion_from(motion_of(o));
  setup.sub_goal_depth = o.sub_goal_depth;
  setup.simplification = o.simplification;
  setup.robot_radius = o.robot_radius;
  setup.body = body_of(o.body);
  setup.adaptive.on = o.adaptive;
  setup.known = known_of(o.known, terrain.grid, setup.blocked);
  setup.first_cells =
      setup.rules.kind == RuleSet::published
          ? published_batch(terrain, setup.blocked, setup.start, o.threshold, o.seed)
          : cells_round(terrain, setup.blocked, setup.start, static_cast<int>(o.start_radius));
  if (setup.rules.kind == RuleSet::certified) {
    set_certified(setup, o, progress, terrain);
    return setup;
  }
  if (setup.rules.kind == RuleSet::band) {
    set_band(setup, o, progress, terrain);
    return setup;
  }
  if (!o.lipschitz.empty()) {
    setup.rules.lipschitz = lipschitz_of(o);
  }
  if (setup.rules.kind == RuleSet::thesis) {
    set_thesis(setup, terrain, progress);
  }
  if (terrain.at(setup.start) < o.threshold) {
    progress.say(fmt::format(
        "warning: the start ({}, {}) stands on unsafe ground: {} is below the threshold "
        "{}.",
        setup.start.x,
        setup.start.y,
        terrain.at(setup.start),
        o.threshold));
  }
  return setup;
}

}  // namespace tcert::cli
