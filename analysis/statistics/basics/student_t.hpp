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

/// What a cluster-robust standard error says by t with clusters - 1 degrees of freedom, which
/// few clusters need more than the normal distribution that R's robust variances are read by
/// (Cameron and Miller 2015, section VI).
struct ClusterT {
  std::optional<double> p_value;     ///< Two-sided.
  std::optional<Interval> interval;  ///< estimate -+ t SE.
};

/// Empty without an estimate, without a standard error above 0, and for fewer than 2 clusters.
/// `statistic` is estimate / standard error; without one there is no p.
[[nodiscard]] ClusterT by_cluster_t(const std::optional<double>& estimate,
                                    const std::optional<double>& standard_error,
                                    const std::optional<double>& statistic,
                                    std::size_t clusters,
                                    double level);

}  // namespace tcert::statistics
