#include "analysis/study/terrain/price.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <table/random.hpp>
#include <terrain/components.hpp>
#include <terrain/lipschitz.hpp>
#include <terrain/session.hpp>

#include "datasets/terrain_field/crater_field.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain::study {
namespace {

constexpr std::uint32_t kPlacesPurpose = 0x7e44be;
constexpr std::uint32_t kNoisePurpose = 0x7e44bf;
constexpr double kLengthScale = 8.0;
constexpr int kStartRadius = 2;

struct Ground {
  Terrain terrain;
  double threshold = 0.0;
  double lipschitz = 0.0;
  double noise_sd = 0.0;
};

[[nodiscard]] Terrain field_of(const GroundKind& kind, std::uint64_t seed, std::uint64_t number) {
  if (kind.field == GroundKind::Field::craters) {
    CraterFieldOptions craters;
    craters.rows = 90;
    craters.columns = 60;
    craters.least_diameter = 6.0;
    craters.reach = 1;
    craters.most_diameter = 40.0;
    craters.density = 0.05;
    craters.seed = seed;
    craters.number = number;
    TerrainGrid made = crater_slopes(craters);
    return {{made.rows, made.columns}, std::move(made.values)};
  }
  TerrainFieldOptions field;
  field.kind = kind.field == GroundKind::Field::matern52   ? FieldKind::matern52
               : kind.field == GroundKind::Field::matern32 ? FieldKind::matern32
                                                           : FieldKind::gaussian;
  field.rows = 60;
  field.columns = 48;
  field.mean = 0.0;
  field.length_scale = kLengthScale;
  field.seed = seed;
  field.number = number;
  TerrainGrid made = random_terrain(field);
  return {{made.rows, made.columns}, std::move(made.values)};
}

[[nodiscard]] Ground ground_of(const GroundKind& kind, std::uint64_t seed, std::uint64_t number) {
  Ground ground{field_of(kind, seed, number)};
  Terrain& terrain = ground.terrain;
  ground.lipschitz = lipschitz_bound(terrain.grid, terrain.values);
  if (kind.noise > 0.0) {
    double squares = 0.0;
    for (const double v : terrain.values) {
      squares += v * v;
    }
    ground.noise_sd = kind.noise * std::sqrt(squares / static_cast<double>(terrain.values.size()));
    table::RandomStream random(seed, kNoisePurpose, number);
    for (const double v : terrain.values) {
      terrain.felt.push_back(v + ground.noise_sd * random.normal());
    }
  }
  return ground;
}

}  // namespace

std::vector<PriceCell> price_cells() {
  using Field = GroundKind::Field;
  const std::vector<GroundKind> kinds{{"squared-exponential"},
                                      {"length scale told twice", Field::gaussian, 2.0},
                                      {"length scale told half", Field::gaussian, 0.5},
                                      {"Matern 5/2", Field::matern52},
                                      {"Matern 3/2", Field::matern32},
                                      {"noise of 1 %", Field::gaussian, 1.0, 0.01},
                                      {"craters", Field::craters}};
  const std::vector<Method> methods{{"L told"},
                                    {"L bounded", RuleSet::certified, false},
                                    {"band", RuleSet::band, false, 1.0, Selection::thesis},
                                    {"band, half", RuleSet::band, false, 0.5, Selection::thesis}};
  std::vector<PriceCell> cells;
  for (const GroundKind& kind : kinds) {
    for (const Method& method : methods) {
      cells.push_back({kind, method});
    }
  }
  // The choice of frontiers, and a length scale that is learnt.
  for (const Selection selection : {Selection::thesis, Selection::look_ahead, Selection::pareto}) {
    cells.push_back({kinds[0],
                     {"L told, " + std::string(to_string(selection)),
                      RuleSet::certified,
                      true,
                      0.5,
                      selection}});
  }
  cells.push_back({kinds[0], {"band, half, pareto", RuleSet::band, false, 0.5, Selection::pareto}});
  for (const std::size_t kind : {0U, 1U, 3U}) {
    cells.push_back(
        {kinds[kind], {"band, adaptive", RuleSet::band, false, 1.0, Selection::thesis, true}});
  }
  return cells;
}

PriceOutcome explore_at_price(const PriceCell& cell, std::uint64_t seed, std::uint64_t number) {
  Ground ground = ground_of(cell.ground, seed, number);
  const Terrain& terrain = ground.terrain;
  const Method& method = cell.method;
  ExploreSetup setup;
  setup.rules.kind = method.rules;
  setup.rules.threshold = ground.threshold;
  setup.rules.lipschitz = ground.lipschitz;
  setup.rules.selection = method.selection;
  setup.rules.noise_sd = ground.noise_sd;
  setup.noise_sd = ground.noise_sd;
  setup.max_steps = 300;
  setup.motion = Motion::pursuit;
  setup.adaptive.on = method.adaptive;
  setup.confidence = method.told ? 0.0 : 0.95;
  if (method.rules == RuleSet::certified) {
    setup.rules.noise_bound = gaussian_noise_bound(ground.noise_sd, 0.95, 313);
  } else {
    setup.rules.beta = kTrustedBeta;
  }
  const double told_length = cell.ground.told_length * kLengthScale;
  setup.prior.length_scale =
      method.rules == RuleSet::band ? method.least_length * told_length : told_length;

  table::RandomStream random(seed, kPlacesPurpose, number);
  const auto is_safe = [&](Cell c) {
    return terrain.at(c) >= ground.threshold &&
           terrain.felt_at(c) - setup.rules.noise_bound >= ground.threshold;
  };
  const auto safe_cell = [&](int radius) {
    for (int tries = 0;; ++tries) {
      const Cell c =
          terrain.grid.cell(random.below(static_cast<std::uint32_t>(terrain.grid.size())));
      // Ground that has no such place is begun on with what there is.
      const auto around = cells_round(terrain.grid, {}, c, tries < 10000 ? radius : 0);
      if (tries > 1000000) {
        throw std::domain_error("a terrain of the study has no safe cell to begin on");
      }
      if (is_safe(c) && std::all_of(around.begin(), around.end(), is_safe)) {
        return c;
      }
    }
  };
  setup.start = safe_cell(kStartRadius);
  setup.goal = safe_cell(0);
  for (const Cell c : cells_round(terrain.grid, {}, setup.start, kStartRadius)) {
    if (is_safe(c)) {
      setup.first_cells.push_back(c);
    }
  }
  std::vector<Measurement> first;
  for (const Cell c : setup.first_cells) {
    first.push_back({position(c), terrain.felt_at(c)});
  }
  first.push_back({position(setup.start), terrain.felt_at(setup.start)});
  settle(setup, terrain.grid, first, {method.told, false, false});

  PriceOutcome outcome;
  const ExploreResult result = explore(terrain, setup);
  outcome.unsafe_cells = result.most_unsafe_certified > 0;
  outcome.unsafe_visits = result.last().unsafe_visits > 0;
  outcome.covered =
      method.rules == RuleSet::certified &&
      std::all_of(result.steps.begin(), result.steps.end(), [&](const ExploreStep& step) {
        return step.lipschitz >= ground.lipschitz;
      });
  CellSet good(terrain.grid.size());
  for (std::size_t i = 0; i < good.size(); ++i) {
    good[i] = terrain.values[i] >= ground.threshold ? 1 : 0;
  }
  outcome.reachable = are_joined(terrain.grid, good, setup.start, *setup.goal);
  outcome.reached = result.end == End::reached;
  outcome.samples = result.steps.size();
  outcome.travelled = result.last().travelled;
  if (method.rules == RuleSet::certified) {
    outcome.first_ratio = result.steps.front().lipschitz / ground.lipschitz;
    outcome.last_ratio = result.last().lipschitz / ground.lipschitz;
  }
  return outcome;
}

void Prices::add(const PriceOutcome& one) {
  ++terrains;
  unsafe_cells += one.unsafe_cells ? 1U : 0U;
  unsafe_visits += one.unsafe_visits ? 1U : 0U;
  covered += one.covered ? 1U : 0U;
  reachable += one.reachable ? 1U : 0U;
  reached += one.reached ? 1U : 0U;
  if (one.reached) {
    samples.push_back(static_cast<double>(one.samples));
    ways.push_back(one.travelled);
  }
  last_ratios.push_back(one.last_ratio);
}

}  // namespace tcert::terrain::study
