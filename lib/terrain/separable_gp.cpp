#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <terrain/limits.hpp>
#include <terrain/separable_gp.hpp>

namespace tcert::terrain {
namespace {

/// The Gaussian factor of one axis, centred at `at`, on 0..count-1.
[[nodiscard]] Eigen::VectorXd factor(int count, double at, double length_scale) {
  Eigen::VectorXd values(count);
  for (int i = 0; i < count; ++i) {
    const double d = (i - at) / length_scale;
    values(i) = std::exp(-0.5 * d * d);
  }
  return values;
}

/// Eigenvalues below this share of the largest are the solver's rounding. A factor's part along an
/// eigenvector is at most the eigenvalue, so what is left out is rounding too.
constexpr double kRounding = 2e-15;

/// Orthonormal directions that hold every factor of the axis: eigenvectors of its Gram matrix.
[[nodiscard]] Eigen::MatrixXd basis(int count, double length_scale) {
  Eigen::MatrixXd gram(count, count);
  for (int j = 0; j < count; ++j) {
    gram.col(j) = factor(count, j, length_scale);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  const Eigen::VectorXd& values = solver.eigenvalues();  // ascending
  int kept = 0;
  while (kept < count && values(count - 1 - kept) > kRounding * values(count - 1)) {
    ++kept;
  }
  return solver.eigenvectors().rightCols(kept);
}

/// A smaller share of the kernel's variance is lost in the rounding of a factor of 500 rows.
constexpr double kLeastNoise = 1e-10;

[[nodiscard]] double noise_of(const GpPrior& prior) {
  return std::max(prior.noise_variance, kLeastNoise * prior.variance);
}

void require(bool holds, const char* message) {
  if (!holds) {
    throw std::invalid_argument(message);
  }
}

}  // namespace

SeparableGp::SeparableGp(const Grid& grid, const GpPrior& prior)
    : SeparableGp(grid, prior, nullptr) {}

SeparableGp SeparableGp::begun_anew(const GpPrior& prior) const {
  return {grid_, prior, prior.length_scale == prior_.length_scale ? this : nullptr};
}

SeparableGp::SeparableGp(const Grid& grid, const GpPrior& prior, const SeparableGp* like)
    : grid_(grid), prior_(prior) {
  require(grid.rows > 0 && grid.columns > 0, "the grid needs cells");
  require(grid.rows <= kMostSide && grid.columns <= kMostSide, "the grid is too large");
  require_within("kernel-mean", prior.mean);
  require_within("kernel-variance", prior.variance);
  require_within("kernel-length-scale", prior.length_scale);
  require_within("noise-variance", prior.noise_variance);
  if (like != nullptr) {
    rows_basis_ = like->rows_basis_;
    columns_basis_ = like->columns_basis_;
  } else {
    rows_basis_ = basis(grid.rows, prior.length_scale);
    columns_basis_ = basis(grid.columns, prior.length_scale);
  }
  mean_.assign(grid.size(), prior.mean);
  variance_.assign(grid.size(), prior.variance);
  if (prior.unknown_mean) {
    ones_.assign(grid.size(), 0.0);
    flat_mean_ = mean_;
    flat_variance_.assign(grid.size(), std::numeric_limits<double>::infinity());
  }
}

void SeparableGp::add(const Position& p, double y) {
  const std::size_t n = positions_.size();
  // The new row of the Cholesky factor of K + noise I.
  std::vector<double> row(n + 1);
  double pivot = prior_.variance + noise_of(prior_);
  double residual = y - prior_.mean;
  double residual_of_one = 1.0;
  for (std::size_t j = 0; j < n; ++j) {
    const double d2 = (p - positions_[j]).squaredNorm();
    double sum =
        prior_.variance * std::exp(-0.5 * d2 / (prior_.length_scale * prior_.length_scale));
    const std::vector<double>& other = cholesky_[j];
    for (std::size_t k = 0; k < j; ++k) {
      sum -= row[k] * other[k];
    }
    row[j] = sum / other[j];
    pivot -= row[j] * row[j];
    residual -= row[j] * whitened_[j];
    if (prior_.unknown_mean) {
      residual_of_one -= row[j] * whitened_ones_[j];
    }
  }
  if (!(pivot > 0.0)) {
    throw std::domain_error("measurements coincide: the covariance is singular");
  }
  const double root = std::sqrt(pivot);
  row[n] = root;

  // The same row of the factor for every cell, in directions.
  const Eigen::VectorXd a =
      rows_basis_.transpose() * factor(grid_.rows, p.x(), prior_.length_scale);
  const Eigen::VectorXd b =
      columns_basis_.transpose() * factor(grid_.columns, p.y(), prior_.length_scale);
  Eigen::MatrixXd g = (prior_.variance * a) * b.transpose();
  for (std::size_t j = 0; j < n; ++j) {
    g.noalias() -= row[j] * directions_[j];
  }
  g /= root;

  const double z = residual / root;
  const RowMajor left = rows_basis_ * g;
  cells_.noalias() = left * columns_basis_.transpose();
  const double* v = cells_.data();
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    mean_[i] += z * v[i];
    variance_[i] -= v[i] * v[i];
  }
  if (prior_.unknown_mean) {
    allow_for_mean(z, residual_of_one / root);
  }

  log_likelihood_ -= 0.5 * (z * z + std::log(2.0 * std::numbers::pi * pivot));
  positions_.push_back(p);
  cholesky_.push_back(std::move(row));
  directions_.push_back(std::move(g));
  whitened_.push_back(z);
}

void SeparableGp::allow_for_mean(double z, double z_of_one) {
  const double* v = cells_.data();
  ones_by_ones_ += z_of_one * z_of_one;
  values_by_ones_ += z * z_of_one;
  const double offset = values_by_ones_ / ones_by_ones_;  // of the mean, from prior_.mean
  for (std::size_t i = 0; i < ones_.size(); ++i) {
    ones_[i] += z_of_one * v[i];
    const double rest = 1.0 - ones_[i];
    flat_mean_[i] = mean_[i] + offset * rest;
    flat_variance_[i] = variance_[i] + rest * rest / ones_by_ones_;
  }
  whitened_ones_.push_back(z_of_one);
}

namespace {

/// Of the covariance of the measurements, noise included.
[[nodiscard]] Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> covariance_factor(
    const GpPrior& prior, std::span<const Measurement> measurements) {
  const auto n = static_cast<Eigen::Index>(measurements.size());
  Eigen::MatrixXd k(n, n);
  const double scale = -0.5 / (prior.length_scale * prior.length_scale);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Measurement& a = measurements[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j <= i; ++j) {
      const Measurement& b = measurements[static_cast<std::size_t>(j)];
      k(i, j) = prior.variance * std::exp(scale * (a.at - b.at).squaredNorm());
    }
    k(i, i) += noise_of(prior);
  }
  return Eigen::LLT<Eigen::MatrixXd, Eigen::Lower>(k);
}

[[nodiscard]] Eigen::VectorXd residuals(const GpPrior& prior,
                                        std::span<const Measurement> measurements) {
  Eigen::VectorXd residual(static_cast<Eigen::Index>(measurements.size()));
  for (Eigen::Index i = 0; i < residual.size(); ++i) {
    residual(i) = measurements[static_cast<std::size_t>(i)].value - prior.mean;
  }
  return residual;
}

}  // namespace

double log_likelihood(const GpPrior& prior, std::span<const Measurement> measurements) {
  const auto n = static_cast<Eigen::Index>(measurements.size());
  const auto llt = covariance_factor(prior, measurements);
  const Eigen::VectorXd whitened = llt.matrixL().solve(residuals(prior, measurements));
  const auto logs = llt.matrixLLT().diagonal().array().log().sum();
  return -0.5 *
             (whitened.squaredNorm() + static_cast<double>(n) * std::log(2.0 * std::numbers::pi)) -
         logs;
}

double profile_log_likelihood(const GpPrior& prior, std::span<const Measurement> measurements) {
  const auto n = static_cast<Eigen::Index>(measurements.size());
  const auto llt = covariance_factor(prior, measurements);
  const Eigen::VectorXd y = llt.matrixL().solve(residuals(prior, measurements));
  const Eigen::VectorXd one = llt.matrixL().solve(Eigen::VectorXd::Ones(n));
  const double cross = y.dot(one);
  const double squares = y.squaredNorm() - cross * cross / one.squaredNorm();
  const auto count = static_cast<double>(n);
  return -0.5 * count * (std::log(2.0 * std::numbers::pi * squares / count) + 1.0) -
         llt.matrixLLT().diagonal().array().log().sum();
}

std::size_t SeparableGp::bytes() const noexcept {
  const std::size_t n = positions_.size();
  const auto directions = static_cast<std::size_t>(rows_basis_.cols() * columns_basis_.cols());
  const auto bases = static_cast<std::size_t>(rows_basis_.size() + columns_basis_.size());
  return sizeof(double) * (3 * mean_.size() + bases + n * directions + n * (n + 1) / 2 + 3 * n);
}

}  // namespace tcert::terrain
