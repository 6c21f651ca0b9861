#pragma once
/// \file
/// Success of the same units under two conditions.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/interval.hpp>

namespace tcert::statistics {

/// Two-sided exact p of McNemar's test (1947) that losing and winning are as likely: of the pairs
/// that differ each is a fair coin. R: `binom.test(lost, lost + won)$p.value`. 1 if none differs.
[[nodiscard]] double mcnemar_exact_p(std::size_t lost, std::size_t won);

/// The mean of differences of pairs that come in clusters.
struct ClusteredMean {
  double value = 0.0;
  std::size_t clusters = 0;
  /// Of the sums by cluster, times G / (G - 1); empty for fewer than 2 clusters.
  std::optional<double> standard_error;
  /// By t with G - 1 degrees of freedom; empty if nothing varies. R: `sandwich::vcovCL(type =
  /// "HC0")` of `lm(difference ~ 1)`.
  std::optional<Interval> interval;
};

/// `clusters` holds a code from 0 on for each difference. Empty without differences.
/// \throws std::invalid_argument if the lengths differ or `level` is not in (0, 1).
[[nodiscard]] std::optional<ClusteredMean> clustered_mean(std::span<const double> differences,
                                                          std::span<const std::uint32_t> clusters,
                                                          double level = 0.95);

/// How many independent pairs show with probability `power`, one-sided at `alpha`, that no more than
/// `margin` of the successes is lost, if none is and a share `discordant` of the pairs differs:
/// (z_alpha + z_power)^2 discordant / margin^2, rounded up (Lu and Bean 1995). Empty if no pair
/// differs, for then nothing is known of how many would.
/// \throws std::invalid_argument for a share or margin outside (0, 1], or an alpha or power outside
/// (0, 1).
[[nodiscard]] std::optional<std::size_t> pairs_for_non_inferiority(double discordant,
                                                                   double margin,
                                                                   double alpha = 0.05,
                                                                   double power = 0.8);

}  // namespace tcert::statistics
