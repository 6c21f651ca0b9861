#include "cli/runs/explore_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <terrain/limits.hpp>
#include <terrain/lipschitz.hpp>
#include <terrain/settle.hpp>

#include "analysis/study/terrain/scenarios.hpp"
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
                                                  const ExploreRequest& o,
                                                  const Terrain& terrain) {
  std::vector<Cell> around = setup.first_cells;
  around.push_back(setup.start);
  for (const Cell c : around) {
    if (terrain.at(c) - setup.rules.noise_bound < setup.rules.threshold) {
      throw BadData(
          fmt::format("the ground round the start is not safe: {}{} at ({}, {}) is below "
                      "the threshold {}{}; start elsewhere{}",
                      terrain.at(c),
                      setup.rules.noise_bound > 0.0
                          ? fmt::format(" less --noise-bound {}", setup.rules.noise_bound)
                          : std::string(),
                      c.x,
                      c.y,
                      setup.rules.threshold,
                      is_given(o.given, "threshold") ? "" : ", which --threshold changes",
                      setup.first_cells.empty() ? "" : " or lower --start-radius"));
    }
  }
  std::vector<Measurement> first = setup.known;
  const std::vector<Measurement> now = measured(terrain, around);
  first.insert(first.end(), now.begin(), now.end());
  return first;
}

/// What the certified rules and band take from what was measured round the start.
void set_by_measurements(terrain::ExploreSetup& setup,
                         const ExploreRequest& o,
                         Progress& progress,
                         const Terrain& terrain) {
  if (told_of(o).lipschitz) {
    setup.rules.lipschitz = lipschitz_of(o);
  }
  try {
    terrain::settle_noise(setup, setup.known.size() + setup.first_cells.size() + 1);
    const std::vector<Measurement> first = safe_start(setup, o, terrain);
    terrain::settle(setup, terrain.grid, first, told_of(o));
    const double variance = setup.rules.kind == RuleSet::band
                                ? terrain::first_scale(setup, first).variance_bound()
                                : 0.0;
    say_settled(setup, o, variance, progress);
    if (o.noise_sd > 0.0) {
      progress.say(
          "note: the terrain is felt as the file has it: unless its values carry that noise, a "
          "bound of the terrain that is made with --noise-sd is too low.");
    }
  } catch (const std::invalid_argument& error) {
    const char* const ways_out = setup.rules.kind == RuleSet::band
                                     ? " (--start-radius, --gradient-prior, --kernel-length-scale)"
                                     : " (--lipschitz, --start-radius)";
    throw BadData(error.what() + std::string(ways_out));
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

terrain::ExploreSetup places_setup(const ExploreRequest& o,
                                   const Places& places,
                                   terrain::CellSet blocked) {
  terrain::ExploreSetup setup;
  setup.start = places.start;
  if (!places.goals.empty()) {
    setup.goal = places.goals.front();
    setup.more_goals.assign(places.goals.begin() + 1, places.goals.end());
  }
  setup.blocked = std::move(blocked);
  setup.max_steps = static_cast<int>(o.max_steps);
  return setup;
}

terrain::Told told_of(const ExploreRequest& o) {
  return {!o.lipschitz.empty() && o.lipschitz != "auto",
          is_given(o.given, "kernel-variance"),
          is_given(o.given, "kernel-mean")};
}

terrain::ExploreSetup unsettled_setup(const ExploreRequest& o,
                                      const terrain::Grid& grid,
                                      terrain::CellSet blocked) {
  terrain::ExploreSetup setup = places_setup(o, places_of(o, grid), std::move(blocked));
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
  setup.motion = *terrain::motion_from(motion_of(o));
  setup.sub_goal_depth = o.sub_goal_depth;
  setup.simplification = o.simplification;
  setup.robot_radius = o.robot_radius;
  setup.body = body_of(o.body);
  setup.adaptive.on = o.adaptive;
  setup.known = known_of(o.known, grid, setup.blocked);
  if (setup.rules.kind == RuleSet::certified || setup.rules.kind == RuleSet::band) {
    setup.confidence = o.confidence;
  }
  if (setup.rules.kind == RuleSet::band) {
    setup.prior.length_scale = o.least_length_scale.value_or(0.5 * o.kernel_length_scale);
  }
  return setup;
}

void say_settled(const terrain::ExploreSetup& setup,
                 const ExploreRequest& o,
                 double variance,
                 Progress& progress) {
  if (setup.rules.kind == RuleSet::band) {
    progress.say(fmt::format(
        "band of {:.3g} sd, sd at most {:.4g} at {:g} % confidence. It takes the terrain for a "
        "Gaussian field with a squared-exponential covariance of length scale {:g} cells or more: "
        "on rougher ground it holds unsafe cells safe (see --help).",
        setup.rules.band(),
        std::sqrt(variance),
        100.0 * setup.confidence,
        setup.prior.length_scale));
    return;
  }
  if (setup.noise_sd > 0.0 && !is_given(o.given, "noise-bound")) {
    progress.say(
        fmt::format("noise bound {:.4g}: with --noise-sd {:g} all measurements of the run keep it "
                    "at {:g} % confidence.",
                    setup.rules.noise_bound,
                    setup.noise_sd,
                    100.0 * o.confidence));
  }
  if (!(setup.confidence > 0.0)) {
    return;
  }
  if (told_of(o).lipschitz) {
    progress.say(
        fmt::format("warning: the Lipschitz constant {} is contradicted by the first measurements; "
                    "it is estimated instead. Give the terrain's own with --lipschitz.",
                    lipschitz_of(o)));
  }
  progress.say(
      fmt::format("Lipschitz constant {:.4g} per cell at {:g} % confidence; it changes as more is "
                  "measured. That takes the terrain for a Gaussian field of length scale {:g} "
                  "cells (--kernel-length-scale), everywhere like here: on ground that is rougher "
                  "elsewhere it is too low, and unsafe cells are held safe (--gradient-prior).",
                  setup.rules.lipschitz,
                  100.0 * setup.confidence,
                  setup.prior.length_scale));
}

terrain::ExploreSetup explore_setup(const ExploreRequest& o,
                                    Progress& progress,
                                    const Terrain& terrain,
                                    terrain::CellSet blocked) {
  terrain::ExploreSetup setup = unsettled_setup(o, terrain.grid, std::move(blocked));
  setup.first_cells =
      setup.rules.kind == RuleSet::published
          ? terrain::study::first_batch(terrain,
                                        setup.blocked,
                                        setup.start,
                                        o.threshold,
                                        static_cast<std::uint64_t>(o.seed))
          : terrain::cells_round(
                terrain.grid, setup.blocked, setup.start, static_cast<int>(o.start_radius));
  if (setup.rules.kind == RuleSet::certified || setup.rules.kind == RuleSet::band) {
    set_by_measurements(setup, o, progress, terrain);
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
