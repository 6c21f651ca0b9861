#include "cli/runs/explore_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <table/random.hpp>
#include <terrain/limits.hpp>
#include <terrain/lipschitz.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/explore_flags.hpp"
#include "cli/runs/progress.hpp"

namespace tcert::cli {
namespace {

using terrain::Cell;
using terrain::Measurement;
using terrain::RuleSet;
using terrain::Terrain;

[[nodiscard]] Cell cell_of(const std::string& option, const std::string& text) {
  Cell cell;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, cell.x);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ',') {
    const auto second = std::from_chars(first.ptr + 1, end, cell.y);
    if (second.ec == std::errc{} && second.ptr == end) {
      return cell;
    }
  }
  throw UsageError("--" + option + ": found '" + text +
                   "', expected a cell as X,Y with whole numbers");
}

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

/// Lipschitz constant and prior of the certified rules, from what was measured round the start.
void set_certified(terrain::ExploreSetup& setup,
                   const ExploreRequest& o,
                   Progress& progress,
                   const Terrain& terrain) {
  std::vector<Cell> around = setup.first_cells;
  around.push_back(setup.start);
  for (const Cell c : around) {
    if (terrain.at(c) - o.noise_bound < o.threshold) {
      throw BadData(
          fmt::format("the ground round the start is not safe: {}{} at ({}, {}) is below "
                      "the threshold {}; start elsewhere or lower --start-radius",
                      terrain.at(c),
                      o.noise_bound > 0.0 ? fmt::format(" less --noise-bound {}", o.noise_bound)
                                          : std::string(),
                      c.x,
                      c.y,
                      o.threshold));
    }
  }
  const std::vector<Measurement> first = measured(terrain, around);
  const double steepest = terrain::steepest_measured(first, o.noise_bound);
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
    const auto estimate =
        terrain::estimate_lipschitz(terrain.grid,
                                    first,
                                    o.kernel_length_scale,
                                    o.noise_bound,
                                    terrain::confidence_of_estimate(o.confidence, 1));
    if (!std::isfinite(estimate.constant) || !(estimate.constant > 0.0)) {
      throw UsageError("the Lipschitz constant cannot be estimated from " +
                       std::to_string(first.size()) +
                       " measurements; give it with --lipschitz or raise --start-radius");
    }
    if (const double least = terrain::limit_of("lipschitz").low; estimate.constant < least) {
      throw BadData(
          fmt::format("the slopes of the terrain are too small to reckon with: {:.3g} per cell, at "
                      "least {:g} is "
                      "needed; multiply its values",
                      estimate.constant,
                      least));
    }
    setup.rules.lipschitz = estimate.constant;
    setup.lipschitz_confidence = o.confidence;
    progress.say(
        fmt::format("Lipschitz constant {:.4g} per cell at {:g} % confidence, from {} "
                    "measurements; raised where later ones ask for it.",
                    estimate.constant,
                    100.0 * o.confidence,
                    first.size()));
  }
  // The prior's scale is that of the data: a field whose steepest gradient is the constant.
  if (!is_given(o.given, "kernel-variance")) {
    const double factor = terrain::steepest_factor(terrain.grid, o.kernel_length_scale, 0.5);
    const double sd = setup.rules.lipschitz * o.kernel_length_scale / factor;
    setup.prior.variance = sd * sd;
  }
  if (!is_given(o.given, "kernel-mean")) {
    setup.prior.mean = terrain.at(setup.start);
  }
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
  std::erase_if(setup.seeds, [&](Cell c) { return terrain.at(c) < setup.rules.threshold; });
  if (setup.seeds.empty()) {
    throw BadData("no cell round the start is safe, and Algorithm 1 needs a safe seed set");
  }
}

}  // namespace

Places places_of(const ExploreRequest& o, const terrain::Grid& grid) {
  Places places;
  places.start = cell_of("start", o.start);
  if (!o.goal.empty() && o.mode != "explore") {
    places.goal = cell_of("goal", o.goal);
  }
  for (const auto& [name, cell] :
       {std::pair{"start", std::optional(places.start)}, std::pair{"goal", places.goal}}) {
    if (cell && !grid.contains(*cell)) {
      throw UsageError(fmt::format("--{}: ({}, {}) lies outside the terrain of {} x {} cells",
                                   name,
                                   cell->x,
                                   cell->y,
                                   grid.rows,
                                   grid.columns));
    }
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
  setup.goal = places.goal;
  setup.blocked = std::move(blocked);
  setup.rules.kind = *terrain::rule_set_from(o.rules);
  setup.rules.threshold = o.threshold;
  setup.rules.beta = o.beta;
  setup.rules.expanders = static_cast<int>(o.expanders);
  setup.rules.noise_bound = o.noise_bound;
  setup.rules.trust_model = o.trust_model;
  setup.rules.look_ahead = o.look_ahead;
  setup.rules.travel_weight = o.travel_weight;
  setup.prior = {o.kernel_mean, o.kernel_variance, o.kernel_length_scale, o.noise_variance};
  setup.max_steps = static_cast<int>(o.max_steps);
  setup.motion = *terrain::motion_from(o.motion);
  setup.simplification = o.simplification;
  setup.robot_radius = o.robot_radius;
  setup.adaptive.on = o.adaptive;
  setup.first_cells =
      setup.rules.kind == RuleSet::published
          ? published_batch(terrain, setup.blocked, setup.start, o.threshold, o.seed)
          : cells_round(terrain, setup.blocked, setup.start, static_cast<int>(o.start_radius));
  if (setup.rules.kind == RuleSet::certified) {
    set_certified(setup, o, progress, terrain);
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
