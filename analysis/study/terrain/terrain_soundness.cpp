#include "analysis/study/terrain/terrain_soundness.hpp"

#include <table/random.hpp>
#include <terrain/explore.hpp>

#include "analysis/study/terrain/scenarios.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain::study {
namespace {

constexpr std::uint32_t kSoundnessPurpose = 0x7e44bb;

}  // namespace

TerrainOutcome explore_terrain(const Telling& telling, std::uint64_t seed, std::uint64_t number) {
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
  setup.rules.lipschitz = telling.told * kLipschitz;
  setup.rules.trust_model = telling.trusted;
  setup.rules.beta = telling.beta;
  setup.rules.selection = number % 2 == 0 ? Selection::look_ahead : Selection::thesis;
  setup.prior = prior_of(setup.rules.lipschitz, field.length_scale, terrain.at(setup.start));
  setup.max_steps = 150;
  setup.motion = number % 3 == 0 ? Motion::reactive : Motion::route;
  const ExploreResult result = explore(terrain, setup);
  TerrainOutcome outcome;
  outcome.unsafe_cells = result.most_unsafe_certified > 0;
  outcome.unsafe_visits = result.last().unsafe_visits > 0;
  outcome.contradicted = result.last().lipschitz > setup.rules.lipschitz;
  outcome.reached = result.end == End::reached;
  outcome.not_reachable = result.end == End::not_reachable || result.end == End::only_lipschitz ||
                          result.end == End::explored;
  outcome.samples = result.steps.size();
  return outcome;
}

void Soundness::add(const TerrainOutcome& one) {
  ++terrains;
  with_unsafe_cells += one.unsafe_cells ? 1U : 0U;
  with_unsafe_visits += one.unsafe_visits ? 1U : 0U;
  contradicted += one.contradicted ? 1U : 0U;
  reached += one.reached ? 1U : 0U;
  not_reachable += one.not_reachable ? 1U : 0U;
  limit += one.reached || one.not_reachable ? 0U : 1U;
  samples += one.samples;
}

double Soundness::mean_samples() const noexcept {
  return static_cast<double>(samples) / static_cast<double>(terrains);
}

}  // namespace tcert::terrain::study
