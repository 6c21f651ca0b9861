#pragma once
/// \file
/// The Lipschitz constant: of a terrain that is known, and estimated from measurements.

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

/// Confidence of the `number`-th estimate (from 1) of a run, such that all of them together hold at
/// `confidence`: the k-th takes 2^-k of the risk.
[[nodiscard]] double confidence_of_estimate(double confidence, int number) noexcept;

struct LipschitzEstimate {
  double constant = 0.0;     ///< Upper bound at the stated confidence; infinite without a patch.
  double gradient_sd = 0.0;  ///< Of one component, estimated.
  int patches = 0;           ///< Places whose gradients were taken as independent.
};

/// Upper confidence bound of the Lipschitz constant, if the terrain is a stationary Gaussian field
/// with this length scale. A place with three measurements or more, not on a line, within half a
/// length scale gives a gradient (least-squares plane). Such places count once they are three
/// length scales apart, in the order of the measurements: nearer ones have much the same gradient.
/// The squared norms bound the gradients' variance from above (chi-square, half of the risk), and
/// steepest_factor takes the other half. Never below the steepest slope measured. O(n (patches +
/// n)). \pre 0 < confidence < 1
[[nodiscard]] LipschitzEstimate estimate_lipschitz(const Grid& grid,
                                                   std::span<const Measurement> measurements,
                                                   double length_scale,
                                                   double noise_bound,
                                                   double confidence);

}  // namespace tcert::terrain
