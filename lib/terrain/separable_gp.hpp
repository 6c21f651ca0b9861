#pragma once
/// \file
/// A Gaussian process on the whole grid that takes one measurement after the other, exactly.

#include <Eigen/Dense>
#include <cstddef>
#include <span>
#include <terrain/grid.hpp>
#include <vector>

namespace tcert::terrain {

/// k(p, q) = variance exp(-|p - q|^2 / (2 length_scale^2)), constant prior mean.
struct GpPrior {
  double mean = 0.0;
  double variance = 2.0;       ///< > 0.
  double length_scale = 30.0;  ///< Cells, > 0.
  double noise_variance =
      1.0;  ///< Of a measurement, >= 0; 1e-10 of the variance at least is taken.
  /// The constant mean is not known: a flat prior on it, `mean` being an offset alone (universal
  /// kriging of a constant, Rasmussen and Williams 2006, section 2.7).
  bool unknown_mean = false;
  friend bool operator==(const GpPrior&, const GpPrior&) = default;
};

/// Posterior mean and variance of every cell.
///
/// The kernel is a product of a function of x and one of y, and each of these, on the rows or
/// columns of the grid, spans only a few dozen directions to the last bit (a Gaussian's spectrum
/// falls faster than exponentially). So the forward-substituted row of the Cholesky factor that
/// belongs to a measurement, a function on all cells, is kept as a small matrix G in those
/// directions, U G W'. A measurement costs O(n^2 + n r s + cells s), with r and s the numbers of
/// directions (65 and 48 at 599 x 400 cells and length scale 30), and n r s numbers are kept
/// instead of n times the cells. Nothing is approximated beyond rounding.
class SeparableGp {
 public:
  /// \throws std::invalid_argument for a prior that is none.
  SeparableGp(const Grid& grid, const GpPrior& prior);

  /// The same grid under another prior, without a measurement. The directions are kept if the
  /// length scale is.
  [[nodiscard]] SeparableGp begun_anew(const GpPrior& prior) const;

  /// Conditions on value `y` at `p`, which need not be a cell. \throws std::domain_error if the
  /// covariance is singular to the last bit.
  void add(const Position& p, double y);

  [[nodiscard]] const Grid& grid() const noexcept { return grid_; }
  [[nodiscard]] const GpPrior& prior() const noexcept { return prior_; }
  [[nodiscard]] std::size_t measurements() const noexcept { return positions_.size(); }
  [[nodiscard]] std::span<const double> mean() const noexcept {
    return prior_.unknown_mean ? flat_mean_ : mean_;
  }
  /// Of the noise-free value, >= 0 up to rounding; infinite without a measurement if the mean is
  /// not known.
  [[nodiscard]] std::span<const double> variance() const noexcept {
    return prior_.unknown_mean ? flat_variance_ : variance_;
  }
  /// log p(values | prior) of all measurements.
  [[nodiscard]] double log_likelihood() const noexcept { return log_likelihood_; }
  /// Bytes held for cells, directions and measurements.
  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  SeparableGp(const Grid& grid, const GpPrior& prior, const SeparableGp* like);

  /// Adds what not knowing the mean does to mean and variance. `z` and `z_of_one` are the new
  /// whitened residuals of the value and of a constant 1.
  void allow_for_mean(double z, double z_of_one);

  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Grid grid_;
  GpPrior prior_;
  RowMajor rows_basis_;     // rows x r, orthonormal
  RowMajor columns_basis_;  // columns x s, orthonormal
  std::vector<double> mean_;
  std::vector<double> variance_;
  std::vector<Position> positions_;
  std::vector<std::vector<double>> cholesky_;  // row by row, diagonal last
  std::vector<Eigen::MatrixXd> directions_;    // G of each measurement, r x s
  std::vector<double> whitened_;               // forward-substituted residuals
  std::vector<double> whitened_ones_;          // the same of a constant 1, if the mean is not known
  std::vector<double> ones_;                   // what the measurements say of a constant 1, a cell
  double ones_by_ones_ = 0.0;                  // products of the whitened residuals
  double values_by_ones_ = 0.0;
  std::vector<double> flat_mean_;
  std::vector<double> flat_variance_;
  double log_likelihood_ = 0.0;
  RowMajor cells_;  // scratch
};

struct Measurement {
  Position at{0.0, 0.0};
  double value = 0.0;
};

/// log p(values | prior) without a grid. O(n^3).
[[nodiscard]] double log_likelihood(const GpPrior& prior,
                                    std::span<const Measurement> measurements);

/// The same at that mean and variance of the field at which it is largest, the noise being the
/// prior's share of the variance. O(n^3). \pre two measurements that differ
[[nodiscard]] double profile_log_likelihood(const GpPrior& prior,
                                            std::span<const Measurement> measurements);

}  // namespace tcert::terrain
