#include "analysis/study/terrain/terrain_soundness.hpp"

#include <tbb/parallel_for.h>

#include <table/random.hpp>
#include <terrain/explore.hpp>
#include <vector>

#include "analysis/study/terrain/scenarios.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain::study {
namespace {

constexpr std::uint32_t kSoundnessPurpose = 0x7e44bb;

struct Outcome {
  ExploreResult result;
  bool contradicted = false;
};

Outcome run(
    std::uint64_t number, double factor, bool trust_model, std::uint64_t seed, double beta) {
  constexpr double kLipschitz = 20.0;
  TerrainFieldOptions field;
  field.rows = 48;
  field.columns = 36;
  field.length_scale = 8.0;
  field.lipschitz = kLipschitz;
  field.seed = seed;
  field.number = number;
  TerrainGrid made = random_terrain(field);
  const Terrain terrain{{made.rows, made.columns}, std::move(made.values)};
  table::RandomStream random(seed, kSoundnessPurpose, number);
  const auto safe_cell = [&] {
    for (;;) {
      const Cell c =
          terrain.grid.cell(random.below(static_cast<std::uint32_t>(terrain.grid.size())));
      if (terrain.at(c) >= field.mean) {
        return c;
      }
    }
  };
  ExploreSetup setup;
  setup.start = safe_cell();
  if (number % 4 != 0) {
    setup.goal = safe_cell();
  }
  setup.rules.threshold = field.mean;
  setup.rules.lipschitz = factor * kLipschitz;
  setup.rules.trust_model = trust_model;
  setup.rules.beta = beta;
  setup.rules.look_ahead = number % 2 == 0;
  setup.prior = prior_of(setup.rules.lipschitz, field.length_scale, terrain.at(setup.start));
  setup.max_steps = 150;
  setup.motion = number % 3 == 0 ? Motion::reactive : Motion::route;
  Outcome outcome;
  outcome.result = explore(terrain, setup);
  outcome.contradicted = outcome.result.last().lipschitz > setup.rules.lipschitz;
  return outcome;
}

}  // namespace

Soundness soundness(
    std::size_t terrains, double factor, bool trust_model, std::uint64_t seed, double beta) {
  std::vector<Outcome> outcomes(terrains);
  tbb::parallel_for(std::size_t{0}, terrains, [&](std::size_t i) {
    outcomes[i] = run(i, factor, trust_model, seed, beta);
  });
  Soundness sum;
  sum.terrains = terrains;
  for (const Outcome& o : outcomes) {
    sum.with_unsafe_cells += o.result.most_unsafe_certified > 0 ? 1U : 0U;
    sum.with_unsafe_visits += o.result.last().unsafe_visits > 0 ? 1U : 0U;
    sum.contradicted += o.contradicted ? 1U : 0U;
    sum.reached += o.result.end == End::reached ? 1U : 0U;
    const End end = o.result.end;
    sum.not_reachable +=
        end == End::not_reachable || end == End::only_lipschitz || end == End::explored ? 1U : 0U;
    sum.mean_samples += static_cast<double>(o.result.steps.size()) / static_cast<double>(terrains);
  }
  sum.limit = terrains - sum.reached - sum.not_reachable;
  return sum;
}

}  // namespace tcert::terrain::study
