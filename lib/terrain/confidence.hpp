#pragma once
/// \file
/// What is known of the value at every cell: an interval that shrinks.

#include <cstddef>
#include <limits>
#include <span>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// C_t(x) = [lower, upper] of every cell.
struct Intervals {
  std::vector<double> lower;
  std::vector<double> upper;

  explicit Intervals(std::size_t cells) : lower(cells, -kUnbounded), upper(cells, kUnbounded) {}
  [[nodiscard]] double width(std::size_t i) const noexcept { return upper[i] - lower[i]; }
};

/// The band mean +- k sd, with variances floored at 1e-15. O(cells).
void set_to_band(Intervals& intervals,
                 std::span<const double> mean,
                 std::span<const double> variance,
                 double k);

/// C <- C intersected with the band, at the cells of `where` (everywhere if null). O(cells).
/// Intervals may become empty (lower > upper); their number is returned.
std::size_t intersect_with_band(Intervals& intervals,
                                std::span<const double> mean,
                                std::span<const double> variance,
                                double k,
                                const CellSet* where);

/// What one measurement y at c, with |y - f(c)| <= noise_bound, says of every cell if f is
/// L-Lipschitz: C <- C intersected with [y - noise - L d, y + noise + L d]. O(cells).
void intersect_with_cone(
    Intervals& intervals, const Grid& grid, Cell c, double y, double noise_bound, double lipschitz);

}  // namespace tcert::terrain
