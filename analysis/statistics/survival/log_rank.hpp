#pragma once
/// \file
/// Log-rank and Peto-Peto tests of equal survival in k groups. Checked against
/// `survival::survdiff`.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

struct LogRankGroup {
  std::string group;
  std::size_t rows = 0;
  double observed = 0.0;  ///< Events, each weighted by S(t-)^rho.
  double expected = 0.0;  ///< The same under equal survival.
};

struct LogRankTest {
  double rho = 0.0;
  std::vector<LogRankGroup> groups;
  Eigen::MatrixXd covariance;  ///< Of observed - expected, groups x groups.
  std::optional<double> chi_squared;
  std::size_t df = 0;  ///< Groups with an expected event, less one.
  std::optional<double> p_value;
  Conditions conditions;
};

/// The G-rho family: rho = 0 is the log-rank test, rho = 1 Peto and Peto's, weighted by the pooled
/// Kaplan-Meier curve of the stratum. Left-truncated rows are taken as well, by their risk sets.
/// `outcome` has rounded times; `strata` may be null. O(n log n + k^2 times).
/// \throws std::invalid_argument if lengths differ, a factor has missing codes, or a time or event
/// is out of range, or `rho` is not finite.
[[nodiscard]] LogRankTest log_rank_test(const SurvivalOutcome& outcome,
                                        const table::Factor& groups,
                                        const table::Factor* strata = nullptr,
                                        double rho = 0.0);

}  // namespace tcert::statistics
