#pragma once
/// \file
/// The scenarios under every rule set, and the baselines beside them.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analysis/study/terrain/baselines.hpp"
#include "analysis/study/terrain/scenarios.hpp"

namespace tcert::terrain::study {

/// The rule sets a scenario is run under: published, thesis as printed and tuned, certified and
/// what may be added to it.
[[nodiscard]] std::vector<Variant> variants_of(const Scenario& scenario,
                                               const Terrain& terrain,
                                               double lipschitz);

struct ScenarioRun {
  std::string scenario;
  std::string variant;
  std::uint64_t seed = 0;
  ExploreResult result;
  std::size_t first = 0;  ///< Cells that were measured before the first step.
};

/// Every scenario under every variant, of those that draw with `seeds` seeds from 0. In parallel,
/// in order; `done` is called after each, one at a time.
[[nodiscard]] std::vector<ScenarioRun> run_scenarios(
    const Terrain& terrain,
    std::size_t seeds,
    const std::function<void(std::size_t done, std::size_t total)>& done);

struct BaselineRun {
  std::string scenario;
  std::string method;
  std::uint64_t seed = 0;
  BaselineResult result;
};

/// The straight walk, and the sparse process under RRT* with `seeds` seeds, on the scenarios that
/// have a goal and begin with no map.
[[nodiscard]] std::vector<BaselineRun> run_baselines(const Terrain& terrain, std::size_t seeds);

}  // namespace tcert::terrain::study
