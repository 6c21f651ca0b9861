#pragma once
/// \file
/// The Lipschitz constant: of a terrain that is known, of measurements, of a random field.

#include <span>
#include <terrain/planner.hpp>
#include <vector>

namespace tcert::terrain {

/// A Lipschitz constant of the values for all pairs of cells: the steepest gradient of the bilinear
/// interpolant, bounded cell by cell. Within a few per cent of the smallest where the terrain is
/// smooth on the scale of a cell. O(cells).
[[nodiscard]] double lipschitz_bound(const Grid& grid, std::span<const double> values);

/// Steepest slope between two measurements, noise allowed for. O(n^2).
[[nodiscard]] double steepest_measured(std::span<const Measurement> measurements,
                                       double noise_bound);

/// k such that the gradient of a stationary Gaussian field with the kernel of GpPrior exceeds k
/// times the standard deviation of one component, anywhere on the grid, with probability at most
/// about `risk`: the expected Euler characteristic of the excursion set of a chi-square field with
/// 2 degrees of freedom (Worsley 1994), with the larger of the spectral moments, 3 /
/// length_scale^2.
[[nodiscard]] double steepest_factor(const Grid& grid, double length_scale, double risk);

/// Of a field whose steepest gradient on the grid is as often below as above `lipschitz`.
[[nodiscard]] double variance_of(const Grid& grid, double lipschitz, double length_scale);

}  // namespace tcert::terrain
