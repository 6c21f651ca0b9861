#pragma once
/// \file
/// The wild cluster bootstrap of scores, with the null hypothesis imposed.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/clusters/sandwich_parts.hpp>

namespace tcert::statistics {

/// Below so many clusters the signs of Rademacher's weights have too few patterns; Webb's six-point
/// weights are drawn instead.
inline constexpr std::size_t kFewForRademacher = 12;

struct WildOptions {
  std::size_t replicates = 1999;
  std::uint64_t seed = 1;
  std::uint32_t analysis = 0;
  double level = 0.95;
};

/// t^2 of coefficient `k` when the score of each cluster is multiplied by its weight (G): the model
/// is linearised at the fit of `parts`, the estimate taken out of the scores, and the variance made
/// of what is left (MacKinnon, Nielsen and Webb 2025). NaN without a spread. O(G r).
[[nodiscard]] double wild_t_squared(const SandwichParts& parts,
                                    std::size_t k,
                                    const Eigen::VectorXd& weights);

/// p of the hypothesis that coefficient `k` has the value that `parts` was fitted under: scores of
/// whole clusters are multiplied by random weights, the model linearised at the restricted fit
/// gives each replicate's estimate and residual scores, and |t| is compared with theirs, (1 + as
/// large) / (1 + replicates) (MacKinnon, Nielsen and Webb 2025 for the logit; Kline and Santos
/// 2012). Empty without a spread. O(replicates G r).
[[nodiscard]] std::optional<double> wild_p_value(const SandwichParts& parts,
                                                 std::size_t k,
                                                 const WildOptions& options);

/// The values of coefficient `k` with p > 1 - level, between the first on each side of `estimate`
/// that are rejected, to 1e-3 of `standard_error`; an end is infinite where nothing within 30 of
/// them is rejected. Empty where a fit is missing on the way.
[[nodiscard]] std::optional<Interval> wild_interval(const PartsAt& parts_at,
                                                    std::size_t k,
                                                    double estimate,
                                                    double standard_error,
                                                    const WildOptions& options);

}  // namespace tcert::statistics
