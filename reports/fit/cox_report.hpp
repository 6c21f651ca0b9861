#pragma once
/// \file
/// A Cox model as tables, with broom's column names.

#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/concordance/concordance.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_baseline.hpp>
#include <statistics/cox/cox_residuals.hpp>
#include <statistics/cox/cox_terms.hpp>
#include <statistics/cox/cox_zph.hpp>
#include <string>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// The coefficients, the tests of the whole model, C of the linear predictor if it is there;
/// `inferences` is of every coefficient where there are clusters.
[[nodiscard]] FitReport cox_report(const statistics::CoxFit& fit,
                                   const std::optional<statistics::ConcordanceResult>& concordance,
                                   const statistics::ClusterInferences& inferences = {});

/// The test of proportional hazards, by term and by coefficient.
void add_proportionality(const statistics::ProportionalityTests& by_term,
                         const statistics::ProportionalityTests& by_column,
                         FitReport& report);

/// Likelihood-ratio tests: terms added in turn, and each taken out.
void add_term_tests(const statistics::TermTests& anova,
                    const statistics::TermTests& drop1,
                    FitReport& report);

[[nodiscard]] Table baseline_table(const std::vector<statistics::BaselineHazard>& hazards);

/// `rows` names the new rows of the curves, counted from 1.
[[nodiscard]] Table curve_table(const std::vector<statistics::CoxCurve>& curves,
                                const std::vector<std::size_t>& rows);

/// Which residuals: martingale, deviance, score, dfbeta, dfbetas, schoenfeld, scaledsch.
/// \throws std::invalid_argument for another word, or if the fit has none of that kind.
[[nodiscard]] Table residual_table(const statistics::CoxResiduals& residuals,
                                   const std::string& word,
                                   const std::vector<std::string>& columns,
                                   const std::vector<std::size_t>& rows);

}  // namespace tcert
