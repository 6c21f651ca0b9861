#include "analysis/study/terrain/sparse_field.hpp"

#include <algorithm>
#include <cmath>

namespace tcert::terrain {

SparseField::SparseField(const Grid& grid, const GpPrior& prior, double spacing)
    : grid_(grid), prior_(prior) {
  double x = 0.0;
  while (x < grid.rows + spacing) {
    double y = 0.0;
    while (y < grid.columns + spacing) {
      inducing_.emplace_back(x, y);
      y += spacing;
    }
    x += spacing;
  }
  const auto m = static_cast<Eigen::Index>(inducing_.size());
  k_mm_.resize(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    k_mm_.col(i) = row(inducing_[static_cast<std::size_t>(i)]);
    k_mm_(i, i) += 1e-8 * prior_.variance;
  }
  precision_ = k_mm_;
  moment_ = Eigen::VectorXd::Zero(m);
  prior_factor_.compute(k_mm_);
}

void SparseField::add(const Measurement& measurement) {
  const Eigen::VectorXd k = row(measurement.at);
  precision_ += k * k.transpose() / prior_.noise_variance;
  moment_ += k * ((measurement.value - prior_.mean) / prior_.noise_variance);
}

void SparseField::update() {
  const Eigen::LLT<Eigen::MatrixXd> factor(precision_);
  const Eigen::VectorXd weights = factor.solve(moment_);
  const int rows = grid_.rows / kStep + 2;
  columns_ = grid_.columns / kStep + 2;
  mean_.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns_));
  deviation_.resize(mean_.size());
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns_; ++j) {
      const Eigen::VectorXd k =
          row({static_cast<double>(i * kStep), static_cast<double>(j * kStep)});
      const std::size_t at = place(i, j);
      mean_[at] = prior_.mean + k.dot(weights);
      const double variance = prior_.variance - prior_factor_.matrixL().solve(k).squaredNorm() +
                              factor.matrixL().solve(k).squaredNorm();
      deviation_[at] = std::sqrt(std::max(variance, 0.0));
    }
  }
}

Eigen::VectorXd SparseField::row(const Position& p) const {
  Eigen::VectorXd k(static_cast<Eigen::Index>(inducing_.size()));
  const double scale = -0.5 / (prior_.length_scale * prior_.length_scale);
  for (Eigen::Index i = 0; i < k.size(); ++i) {
    const double d2 = (p - inducing_[static_cast<std::size_t>(i)]).squaredNorm();
    k(i) = prior_.variance * std::exp(scale * d2);
  }
  return k;
}

double SparseField::read(const std::vector<double>& values, const Position& p) const {
  const double x = std::clamp(p.x(), 0.0, grid_.rows - 1.0) / kStep;
  const double y = std::clamp(p.y(), 0.0, grid_.columns - 1.0) / kStep;
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const double u = x - i;
  const double v = y - j;
  const auto at = [&](int a, int b) { return values[place(a, b)]; };
  return (1 - u) * ((1 - v) * at(i, j) + v * at(i, j + 1)) +
         u * ((1 - v) * at(i + 1, j) + v * at(i + 1, j + 1));
}

}  // namespace tcert::terrain
