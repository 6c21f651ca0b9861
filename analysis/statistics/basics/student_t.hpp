#pragma once
/// \file
/// Student's t distribution, as tests and intervals need it.

#include <cstddef>
#include <optional>
#include <statistics/basics/alternative.hpp>
#include <statistics/basics/interval.hpp>

namespace tcert::statistics {

/// Half width of a two-sided interval in standard errors: `qt((1 + level) / 2, df)`.
/// \pre 0 < level < 1, df > 0.
[[nodiscard]] double t_factor(double level, double df);

/// p-value of a t statistic. \pre df > 0.
[[nodiscard]] double t_p_value(double t, double df, Alternative alternative);

/// What clusters say of an estimate, in a way that few of them do not belie (Cameron and Miller
/// 2015, section VI). Empty where there is none.
struct ClusterT {
  std::optional<double> standard_error;
  std::optional<double> df;          ///< Of Student's t; empty where p is not by it.
  std::optional<double> p_value;     ///< Two-sided, of 0.
  std::optional<Interval> interval;  ///< estimate -+ t SE.
};

/// Empty without an estimate that is finite, a standard error above 0, and df above 0.
[[nodiscard]] ClusterT by_student_t(double estimate,
                                    double standard_error,
                                    double df,
                                    double level);

/// With clusters - 1 degrees of freedom, which a cluster-robust standard error has at most. Empty
/// without an estimate, without a standard error above 0, and for fewer than 2 clusters.
/// `statistic` is estimate / standard error; without one there is no p.
[[nodiscard]] ClusterT by_cluster_t(const std::optional<double>& estimate,
                                    const std::optional<double>& standard_error,
                                    const std::optional<double>& statistic,
                                    std::size_t clusters,
                                    double level);

}  // namespace tcert::statistics
