#pragma once
/// \file
/// How much a terrain varies, bounded from above by what was measured of it.

#include <cstddef>
#include <terrain/grid.hpp>
#include <terrain/separable_gp.hpp>
#include <vector>

namespace tcert::terrain {

/// What earlier ground of the same kind has shown of gradients, declared and not measured here.
struct GradientPrior {
  double sd = 0.0;      ///< Of one component of the gradient, per cell, >= 0.
  double places = 0.0;  ///< So many independent places it is worth, >= 0; 0: there is none.
};

/// What the bound assumes: a Gaussian field of this length scale and an unknown constant mean.
struct FieldAssumptions {
  double length_scale = 30.0;  ///< Cells.
  double noise_sd = 0.0;       ///< Of a measurement's Gaussian error.
  double confidence = 0.95;    ///< Of all bounds of a run together.
  GradientPrior gradient;
};

/// An upper bound of the field's variance that falls as more is measured.
///
/// A measurement joins the *skeleton* if its variance, given the skeleton and relative to the
/// field's, is 1e-4 or more (the mean's uncertainty included): so the policy that chose the places
/// decides little about which innovations are kept. With K the correlations of the skeleton (nugget
/// 1e-6) and n places, Q(v) = min over m of (y - m)' (v K + noise)^-1 (y - m) is chi-square with
/// n - 1 degrees of freedom at the true v, and falls with v: the k-th bound is the v at which Q,
/// and what the gradient prior adds to it, equals the quantile of a k-th share 2^-k of half the
/// risk. The least of them counts, until what is measured later contradicts it: Q there above the
/// quantile of 1 less half the risk. Measurements that are all equal, or that noise alone explains,
/// bound nothing. That the choice of places does not depend on the values is an approximation: how
/// often the bound holds is measured (README), not proven. `noise_sd` must not be overstated: what
/// is put down to noise is missing in the bound.
class FieldScale {
 public:
  /// \throws std::invalid_argument for assumptions that are not within their Limit.
  explicit FieldScale(const FieldAssumptions& assumptions);

  /// O(n^2) for n places of the skeleton.
  void add(const Measurement& measurement);

  /// Bounds anew if the innovations have grown by half since it last did, or contradict the bound;
  /// true if it changed. O(n^3) with noise, else O(1).
  bool renew();

  /// Above 0; infinite before the first bound.
  [[nodiscard]] double variance_bound() const noexcept { return bound_; }
  /// Of the largest gradient anywhere on the grid, with the other half of the risk. Infinite before
  /// the first bound.
  [[nodiscard]] double lipschitz_bound(const Grid& grid) const;
  [[nodiscard]] std::size_t places() const noexcept { return values_.size(); }
  [[nodiscard]] int bounds() const noexcept { return bounds_; }
  [[nodiscard]] const FieldAssumptions& assumptions() const noexcept { return assumptions_; }

 private:
  [[nodiscard]] double correlation(const Position& a, const Position& b) const;
  /// Q(v), with noise.
  [[nodiscard]] double quadratic_form(double variance) const;
  /// v Q(v) without noise; 0 for values that are equal up to rounding.
  [[nodiscard]] double squares() const;
  /// What the prior adds to them.
  [[nodiscard]] double squares_of_prior() const;
  /// Q(v), and what the prior adds to it.
  [[nodiscard]] double form(double variance) const;
  /// n - 1, and the prior's.
  [[nodiscard]] double freedom() const noexcept;
  /// The v at which the form equals `quantile`; infinite if the measurements do not say.
  [[nodiscard]] double bound_at(double quantile) const;

  FieldAssumptions assumptions_;
  std::vector<Position> positions_;
  double origin_ = 0.0;                        // the first value
  std::vector<double> values_;                 // less the origin
  std::vector<std::vector<double>> cholesky_;  // of K, row by row
  std::vector<double> whitened_values_;
  std::vector<double> whitened_ones_;
  double values_by_values_ = 0.0;
  double values_by_ones_ = 0.0;
  double ones_by_ones_ = 0.0;
  double largest_ = 0.0;    // of all values, either way
  std::size_t next_ = 1;    // innovations at which it is bounded next
  std::size_t looked_ = 0;  // innovations when it was last asked
  int bounds_ = 0;
  double bound_;
};

/// Where the distribution function of chi-square with `freedom` > 0 degrees of freedom is `level`.
[[nodiscard]] double chi_square_quantile(double freedom, double level);

}  // namespace tcert::terrain
