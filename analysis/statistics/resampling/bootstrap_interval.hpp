#pragma once
/// \file
/// Confidence intervals from bootstrap replicates, as R's `boot::boot.ci` has them, and expanded
/// percentiles.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <string_view>
#include <vector>

namespace tcert::statistics {

struct BootstrapDistribution {
  double observed = 0.0;       ///< The statistic of the data, t0.
  std::vector<double> sorted;  ///< Finite replicates, rising.
  std::size_t failed = 0;      ///< Replicates that are not finite, left out.
  std::size_t below = 0;       ///< Replicates strictly less than t0, compared exactly as boot does.
  std::size_t equal = 0;       ///< Replicates equal to t0.
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< n - 1 in the denominator; NaN for fewer than two.
};

/// O(R log R).
[[nodiscard]] BootstrapDistribution bootstrap_distribution(std::span<const double> replicates,
                                                           double observed);

enum class BootstrapMethod : std::uint8_t {
  normal,      ///< t0 - bias -+ z SD.
  basic,       ///< 2 t0 - the percentile endpoints, exchanged.
  percentile,  ///< Quantiles of the replicates.
  expanded,    ///< Quantiles at levels that make up for few units (Hesterberg 2015).
  bca,         ///< Quantiles at bias-corrected and accelerated levels (Efron 1987).
};

struct BootstrapInterval {
  std::optional<Interval> interval;
  double low_rank = 0.0;   ///< Rank (R + 1) alpha of the order statistic that ends it; NaN: normal.
  double high_rank = 0.0;  ///< The same at the other end.
  /// failed_replicates; constant_replicates, infinite_bias, no_acceleration: no interval.
  /// endpoint_out_of_range: an end is the extreme replicate, as in boot, and too close.
  Conditions conditions;
};

/// `units` is how many rows or clusters were drawn in a replicate.
/// Quantiles lie at rank (R + 1) alpha, between order statistics interpolated on the scale of
/// normal quantiles (Davison & Hinkley 1997, eq. 5.8; `norm.inter`). BCa: w = qnorm(below / R),
/// alpha' = pnorm(w + (w + z) / (1 - a (w + z))). `acceleration` is of use to BCa alone.
/// Expanded: with G `units` the tail alpha / 2 is pnorm(-sqrt(G / (G - 1)) qt(1 - alpha / 2, G -
/// 1)) instead, as the bootstrap's spread is that of n and not of n - 1, and normal where it should
/// be Student's (Hesterberg 2015, The American Statistician 69:371). \throws std::invalid_argument
/// if `level` is not in (0, 1), or for expanded percentiles of fewer than two units. O(1).
[[nodiscard]] BootstrapInterval bootstrap_interval(const BootstrapDistribution& distribution,
                                                   BootstrapMethod method,
                                                   std::optional<double> acceleration = {},
                                                   double level = 0.95,
                                                   std::size_t units = 0);

/// The tail below the lower end of an expanded percentile interval; that above the upper one is as
/// large. \pre units > 1, level in (0, 1).
[[nodiscard]] double expanded_tail(double level, std::size_t units);

/// "BCa", "expanded", "percentile", "basic", "normal": as headings have it.
[[nodiscard]] std::string_view to_string(BootstrapMethod method) noexcept;

}  // namespace tcert::statistics
