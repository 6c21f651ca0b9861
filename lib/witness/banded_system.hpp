#pragma once
/// \file
/// Symmetric positive definite equations of a band.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tcert::witness {

/// The normal equations of least squares whose residuals depend on six neighbouring unknowns each.
class BandedSystem {
 public:
  static constexpr std::size_t kBand = 6;

  explicit BandedSystem(std::size_t unknowns) : matrix_(unknowns), right_(unknowns) {}

  void clear() {
    matrix_.assign(matrix_.size(), {});
    right_.assign(right_.size(), 0.0);
  }

  /// Adds a residual with its derivatives by the unknowns from `first` on; those beyond the last
  /// unknown must be 0.
  void add(std::size_t first, const std::array<double, kBand>& derivatives, double residual) {
    for (std::size_t i = 0; i < kBand && first + i < right_.size(); ++i) {
      right_[first + i] -= derivatives[i] * residual;
      for (std::size_t j = 0; j <= i; ++j) {
        matrix_[first + i][i - j] += derivatives[i] * derivatives[j];
      }
    }
  }

  /// The step that solves (J^T J + damping I) step = -J^T r, by Cholesky. \pre damping > 0.
  [[nodiscard]] std::vector<double> solved(double damping) const;

 private:
  std::vector<std::array<double, kBand>> matrix_;  // row i: the entries (i, i), (i, i - 1), ...
  std::vector<double> right_;
};

}  // namespace tcert::witness
