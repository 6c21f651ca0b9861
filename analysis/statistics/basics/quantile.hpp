#pragma once
/// \file
/// Sample quantiles, Hyndman & Fan (1996) type 7: R's `quantile()` and `median()`.

#include <optional>
#include <span>

namespace tcert::statistics {

/// Quantile `p` of a sample, linear between the order statistics at 1 + (n - 1) p.
/// Empty for an empty sample and for one that holds a NaN: what is missing is the caller's to leave
/// out. Infinities are ordinary values; between -infinity and +infinity there is no value, so that
/// is empty too. O(n).
/// \throws std::invalid_argument unless 0 <= p <= 1.
[[nodiscard]] std::optional<double> quantile(std::span<const double> sample, double p);

/// The same without a copy: reorders `sample`.
[[nodiscard]] std::optional<double> quantile_in_place(std::span<double> sample, double p);

[[nodiscard]] std::optional<double> median(std::span<const double> sample);

}  // namespace tcert::statistics
