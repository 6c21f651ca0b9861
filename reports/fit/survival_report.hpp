#pragma once
/// \file
/// Kaplan-Meier curves, log-rank test and cumulative incidence as tables.

#include <optional>
#include <statistics/survival/cumulative_incidence.hpp>
#include <statistics/survival/gray_test.hpp>
#include <statistics/survival/log_rank.hpp>
#include <statistics/survival/restricted_means.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

struct SurvivalReportOptions {
  statistics::IntervalScale scale = statistics::IntervalScale::log;
  double level = 0.95;
  std::vector<double> times;  ///< At which the curves are shown; empty: five quantiles of the event
                              ///< times, rounded.
  std::optional<double> limit = std::nullopt;  ///< Where the times end, if none were given.
};

/// Events and medians by group, the curves at `times`, every point as a detail, the test if there
/// are groups to compare.
[[nodiscard]] FitReport survival_report(const std::vector<statistics::SurvivalCurve>& curves,
                                        const std::optional<statistics::LogRankTest>& test,
                                        const SurvivalReportOptions& options);

[[nodiscard]] Table gray_table(const std::vector<statistics::GrayTest>& tests, double rho);

[[nodiscard]] Table restricted_mean_table(const std::vector<statistics::RestrictedMeanRow>& rows,
                                          double limit,
                                          bool clustered);

/// Adds the cumulative incidence of each cause at `times`, and every point as a detail.
void add_incidence(const std::vector<statistics::IncidenceCurves>& curves,
                   const SurvivalReportOptions& options,
                   FitReport& report);

}  // namespace tcert
