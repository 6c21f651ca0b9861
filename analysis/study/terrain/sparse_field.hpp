#pragma once
/// \file
/// The sparse Gaussian process of a baseline.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <terrain/explore.hpp>
#include <vector>

namespace tcert::terrain {

/// Posterior of a process with inducing points on a lattice (deterministic training conditional),
/// on a coarse lattice of its own and read between its points.
class SparseField {
 public:
  /// Inducing points are `spacing` cells apart.
  SparseField(const Grid& grid, const GpPrior& prior, double spacing);

  /// Counts from the next update on.
  void add(const Measurement& measurement);
  void update();

  /// \pre update() was called.
  [[nodiscard]] double mean(const Position& p) const { return read(mean_, p); }
  [[nodiscard]] double deviation(const Position& p) const { return read(deviation_, p); }

 private:
  static constexpr int kStep = 8;

  /// Of point (i, j) of the coarse lattice.
  [[nodiscard]] std::size_t place(int i, int j) const noexcept {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(j);
  }
  [[nodiscard]] Eigen::VectorXd row(const Position& p) const;
  [[nodiscard]] double read(const std::vector<double>& values, const Position& p) const;

  Grid grid_;
  GpPrior prior_;
  int columns_ = 0;
  std::vector<Position> inducing_;
  Eigen::MatrixXd k_mm_;
  Eigen::MatrixXd precision_;
  Eigen::VectorXd moment_;
  Eigen::LLT<Eigen::MatrixXd> prior_factor_;
  std::vector<double> mean_;
  std::vector<double> deviation_;
};

}  // namespace tcert::terrain
