#pragma once
/// \file
/// Isotonic regression: the monotone function nearest to the data by least squares. Rising fits are
/// those of R's `isoreg`.

#include <cstddef>
#include <span>
#include <vector>

namespace tcert::statistics {

enum class Trend { rising, falling };

/// Rows, neighbours in x, that have one fitted value: the mean of their y.
struct IsotonicBlock {
  double first_x = 0.0;
  double last_x = 0.0;
  double mean_x = 0.0;
  double value = 0.0;
  std::size_t rows = 0;
};

struct IsotonicFit {
  Trend trend = Trend::rising;
  std::vector<IsotonicBlock> blocks;  ///< In order of x; values strictly monotone.
  double squares = 0.0;               ///< Sum of the squared residuals.

  /// The fitted value of the block that x is in; between two blocks on the line between their ends,
  /// outside of all that of the nearest. O(log blocks). \pre there is a block.
  [[nodiscard]] double at(double x) const noexcept;
};

/// Pools adjacent violators. Rows of equal x have one value, that of their mean. Empty without
/// rows. \throws std::invalid_argument if lengths differ or a number is not finite. O(n log n).
[[nodiscard]] IsotonicFit isotonic_fit(std::span<const double> x,
                                       std::span<const double> y,
                                       Trend trend);

/// In the direction that leaves the smaller sum of squares; falling if both leave the same.
[[nodiscard]] IsotonicFit isotonic_fit(std::span<const double> x, std::span<const double> y);

}  // namespace tcert::statistics
