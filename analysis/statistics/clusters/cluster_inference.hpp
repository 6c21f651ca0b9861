#pragma once
/// \file
/// Which correction for few clusters a p and an interval are by.

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/clusters/sandwich_parts.hpp>
#include <statistics/clusters/wild_bootstrap.hpp>
#include <string_view>
#include <vector>

namespace tcert::statistics {

enum class ClusterInference : std::uint8_t {
  cr1,        ///< Sandwich times G/(G - 1), Student's t with G - 1 degrees of freedom.
  cr2,        ///< Bell and McCaffrey's sandwich, t with Satterthwaite's degrees of freedom.
  jackknife,  ///< Whole clusters left out (CV3), t with G - 1 degrees of freedom.
  wild,       ///< Wild bootstrap of the clusters' scores; the interval inverts the test.
};
constexpr ClusterInference row_last(ClusterInference /*any*/) noexcept {
  return ClusterInference::wild;
}

/// "cr1", "cr2", "jackknife", "wild".
[[nodiscard]] std::string_view to_string(ClusterInference inference) noexcept;

/// Of one coefficient; empty where there is none.
struct ClusterEstimate {
  std::optional<double> standard_error;  ///< Of wild: that of CR1, which scales its search.
  std::optional<double> df;              ///< Empty for wild.
  std::optional<double> p_value;         ///< Two-sided, of 0.
  std::optional<Interval> interval;
};

/// A fit as inference asks for it.
struct ClusteredFit {
  SandwichParts parts;  ///< At the estimates.
  PartsAt parts_at;
  /// The coefficients (p) without each cluster in turn, NaN where there is none: p x G.
  std::function<Eigen::MatrixXd()> left_out;
};

/// t with `df` degrees of freedom; empty without an estimate, a standard error above 0 and df above
/// 0.
[[nodiscard]] ClusterEstimate by_t(double estimate, double standard_error, double df, double level);

/// (G - 1) / G times the sum of squared distances of `left_out` from `estimate`: CV3 (MacKinnon,
/// Nielsen and Webb 2023). NaN if one is.
[[nodiscard]] double jackknife_variance(double estimate, const Eigen::VectorXd& left_out);

/// One for each coefficient; all empty with fewer than 2 clusters.
[[nodiscard]] std::vector<ClusterEstimate> cluster_estimates(const ClusteredFit& fit,
                                                             ClusterInference inference,
                                                             const WildOptions& options);

}  // namespace tcert::statistics
