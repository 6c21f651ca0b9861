#pragma once
/// \file
/// Placement values of two samples: what the AUC and its variance are made of.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

/// Which outcome a larger value of a predictor speaks for. Fixed beforehand, never from the data.
enum class HigherMeans { success, failure };

/// Success i against all failures, failure j against all successes; a tie counts one half.
/// These are V10 and V01 of DeLong, DeLong & Clarke-Pearson (1988), read off midranks as in
/// Sun & Xu (2014).
struct Placements {
  std::vector<double> successes;  ///< Share of failures that a success outranks; in row order.
  std::vector<double> failures;   ///< Share of successes that outrank a failure; in row order.
  double auc = 0.0;               ///< Pr(success outranks failure): the mean of either vector.
  std::size_t distinct = 0;       ///< Distinct scores.
};

/// "Outranks" means larger if `higher` is success, smaller if failure. O(n log n).
/// \pre `success` holds as many values, at least one 0 and one that is not.
/// \throws std::invalid_argument if a score is NaN.
[[nodiscard]] Placements placements(std::span<const double> score,
                                    std::span<const std::uint8_t> success,
                                    HigherMeans higher);

}  // namespace tcert::statistics
