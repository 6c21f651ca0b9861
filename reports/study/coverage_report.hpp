#pragma once
/// \file
/// Studies of the intervals and tests themselves: how often they hold what they say.

#include <cstdint>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <utility>
#include <vector>

#include "analysis/study/coverage/advance_study.hpp"
#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/coverage/equivalence_study.hpp"
#include "analysis/study/coverage/gate_study.hpp"
#include "analysis/study/coverage/hypotheses_study.hpp"
#include "analysis/study/coverage/inference_study.hpp"
#include "analysis/study/coverage/ray_study.hpp"
#include "analysis/study/h1/hypothesis_h1.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

[[nodiscard]] FitReport coverage_report(const std::vector<study::coverage::Coverage>& rows,
                                        const study::coverage::Options& options);

using ScenarioRates =
    std::pair<study::coverage::LightingScenario, study::coverage::EquivalenceRates>;
[[nodiscard]] FitReport equivalence_report(const std::vector<ScenarioRates>& rows,
                                           std::size_t data_sets,
                                           std::uint64_t seed);

[[nodiscard]] FitReport inference_report(const std::vector<study::coverage::InferenceRate>& rows,
                                         const study::coverage::Options& options);

/// What the tables of H1 and H2 print, and those of H3.
[[nodiscard]] FitReport hypotheses_report(const std::vector<study::coverage::MissRate>& rows,
                                          const study::coverage::Options& options);
[[nodiscard]] FitReport advance_report(const std::vector<study::coverage::AdvanceRate>& rows,
                                       const study::coverage::Options& options);

[[nodiscard]] FitReport gate_coverage_report(const study::coverage::GateSummary& summary,
                                             const study::coverage::GateOptions& options);

/// Of the bound of ray calibrations.
[[nodiscard]] FitReport ray_coverage_report(const std::vector<study::coverage::RayCoverage>& rows,
                                            std::uint64_t seed);

/// H1's AUC of the certificate on a corpus whose outcomes have nothing to do with it.
struct NullAuc {
  std::uint64_t seed = 0;
  study::H1PanelKind panel{};
  std::optional<double> auc;
  std::optional<statistics::Interval> interval;

  [[nodiscard]] std::optional<bool> covers() const noexcept;
};

void row_cells(auto& row, table::Is<NullAuc> auto& one) {
  row(one.seed, one.panel, one.auc, one.interval);
}

[[nodiscard]] FitReport null_report(const std::vector<NullAuc>& rows);

}  // namespace tcert
