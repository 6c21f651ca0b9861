#include "analysis/study/terrain/scenarios.hpp"

#include <algorithm>
#include <table/random.hpp>
#include <terrain/lipschitz.hpp>
#include <terrain/session.hpp>

namespace tcert::terrain::study {
namespace {

constexpr std::uint32_t kScenarioPurpose = 0x7e44ba;

}  // namespace

std::vector<Scenario> scenarios() {
  return {
      {"general", "4.2", 1000.0, {230, 220}, Cell{470, 290}, 54},
      {"around", "4.3", 1000.0, {230, 220}, Cell{104, 82}, 210},
      {"around_500", "4.4", 500.0, {40, 221}, Cell{185, 360}, 461},
      {"reuse", "4.5", 1000.0, {104, 82}, Cell{260, 235}, 10, true},
      {"explore", "4.6", 1000.0, {230, 220}, std::nullopt, 9, false, 8},
  };
}

GpPrior prior_of(double lipschitz, double length_scale, double mean) {
  const double sd = lipschitz * length_scale / 4.4;
  return {mean, sd * sd, length_scale, 1.0};
}

Variant published(double threshold) {
  Variant v;
  v.name = "published";
  v.rules.kind = RuleSet::published;
  v.rules.threshold = threshold;
  v.prior = {0.0, 2.0, 30.0, 1.0 + 1e-8};
  return v;
}

Variant thesis_as_printed(double threshold) {
  Variant v = published(threshold);
  v.name = "thesis, App. B";
  v.rules.kind = RuleSet::thesis;
  return v;
}

Variant thesis_tuned(double threshold, double lipschitz) {
  Variant v = thesis_as_printed(threshold);
  v.name = "thesis, true L";
  v.rules.lipschitz = lipschitz;
  v.prior = prior_of(lipschitz, 70.0, threshold);
  return v;
}

Variant certified(double threshold, double lipschitz, double mean) {
  Variant v;
  v.name = "certified";
  v.rules.threshold = threshold;
  v.rules.lipschitz = lipschitz;
  v.prior = prior_of(lipschitz, 70.0, mean);
  v.batch = false;
  return v;
}

std::vector<Cell> first_batch(const Terrain& terrain,
                              const CellSet& blocked,
                              Cell start,
                              double threshold,
                              std::uint64_t seed) {
  table::RandomStream random(seed, kScenarioPurpose, 0);
  const auto draw = [&](int centre, int limit) {
    const int low = std::max(0, centre - 20);
    const int high = std::min(limit, centre + 20);
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low)));
  };
  std::vector<Cell> cells;
  for (int k = 0; k < 50; ++k) {
    const int x = draw(start.x, terrain.grid.rows);
    const int y = draw(start.y, terrain.grid.columns);
    const bool is_free = blocked.empty() || blocked[terrain.grid.index({x, y})] == 0;
    if (is_free && terrain.at({x, y}) >= threshold) {
      cells.push_back({x, y});
    }
  }
  return cells;
}

void settle_by_start(ExploreSetup& setup, const Terrain& terrain) {
  if (!(setup.confidence > 0.0)) {
    return;
  }
  std::vector<Measurement> first = setup.known;
  for (const Cell c : setup.first_cells) {
    first.push_back({position(c), terrain.at(c)});
  }
  first.push_back({position(setup.start), terrain.at(setup.start)});
  settle(setup, terrain.grid, first, {});
}

ExploreSetup setup_of(const Terrain& terrain,
                      const Scenario& scenario,
                      const Variant& variant,
                      std::uint64_t seed) {
  ExploreSetup setup;
  setup.rules = variant.rules;
  setup.prior = variant.prior;
  setup.start = scenario.start;
  setup.goal = scenario.goal;
  setup.max_steps = scenario.max_steps;
  setup.motion = variant.motion;
  setup.adaptive = variant.adaptive;
  setup.sub_goal_depth = variant.sub_goal_depth;
  setup.confidence = variant.confidence;
  if (variant.batch && !scenario.reuse) {
    setup.first_cells = first_batch(terrain, {}, scenario.start, scenario.threshold, seed);
  }
  if (variant.confidence > 0.0) {
    setup.first_cells = cells_round(terrain.grid, {}, scenario.start, 2);
  }
  if (variant.rules.kind == RuleSet::thesis) {
    setup.seeds = setup.first_cells;
    setup.seeds.push_back(scenario.start);
  }
  return setup;
}

}  // namespace tcert::terrain::study
