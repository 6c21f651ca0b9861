#pragma once
/// \file
/// What the rules of exploration hold safe that is not, and what they cost.

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/study/terrain/price.hpp"
#include "analysis/study/terrain/scenario_runs.hpp"
#include "analysis/study/terrain/terrain_soundness.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Random terrains under one way of telling the rules what they need.
struct TerrainRates {
  terrain::study::Telling telling;
  terrain::study::Soundness found;
};

/// Tables terrain_soundness and terrain_trust.
[[nodiscard]] FitReport terrain_soundness_report(const std::vector<TerrainRates>& told,
                                                 const std::vector<TerrainRates>& trusted,
                                                 std::uint64_t seed);

/// One kind of ground under one method.
struct PriceRow {
  terrain::study::PriceCell cell;
  terrain::study::Prices found;
};

/// Table price.
[[nodiscard]] FitReport price_report(const std::vector<PriceRow>& rows, std::uint64_t seed);

/// Tables scenarios and baselines.
[[nodiscard]] FitReport scenario_report(const std::vector<terrain::study::ScenarioRun>& runs,
                                        const std::vector<terrain::study::BaselineRun>& baselines,
                                        const std::optional<SyntheticLabel>& label);

}  // namespace tcert
