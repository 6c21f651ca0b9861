#pragma once
/// \file
/// H = I + A' W A of the random effects, which is sparse: its factor, and the elements of its
/// inverse where it is not 0. Internal to sparse_likelihood.cpp.

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <statistics/glmm/glmm_problem.hpp>
#include <vector>

namespace tcert::statistics {

class SparseCurvature {
 public:
  /// Lays out H for these terms on so many rows.
  SparseCurvature(const std::vector<TermRows>& terms, Eigen::Index rows);

  [[nodiscard]] Eigen::Index effects() const noexcept { return effects_; }  ///< Elements of u.
  /// Elements of a row of A that are not 0.
  [[nodiscard]] Eigen::Index per_row() const noexcept { return per_row_; }
  /// The places in u of a row's elements, ascending.
  [[nodiscard]] const Eigen::Index* places(Eigen::Index row) const noexcept {
    return of_.data() + row * per_row_;
  }

  /// `values` are those of A, rows x per_row; `weight` is the diagonal of W. False if H is not
  /// positive definite.
  [[nodiscard]] bool factorise(const RowMajorMatrix& values, const Eigen::VectorXd& weight);

  // Of what was factorised last.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return cholesky_.solve(right);
  }
  [[nodiscard]] double half_log_determinant() const;
  /// Sets the elements of the inverse.
  void invert();
  /// That of the elements a and b of a row.
  [[nodiscard]] double inverse(Eigen::Index row, Eigen::Index a, Eigen::Index b) const noexcept {
    const auto pair =
        static_cast<std::size_t>(row * pairs_ + pair_index(std::min(a, b), std::max(a, b)));
    return inverse_[static_cast<std::size_t>(pair_[pair])];
  }
  /// That of the effects at `place` and `below` later, both of one level.
  [[nodiscard]] double inverse_of_level(Eigen::Index place, Eigen::Index below) const noexcept {
    // Effects of one level stand together, so that these follow the diagonal in H's column.
    return inverse_[diagonal_[static_cast<std::size_t>(place)] + static_cast<std::size_t>(below)];
  }

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Place of (a, b), a <= b, among the pairs of a row.
  [[nodiscard]] static Eigen::Index pair_index(Eigen::Index a, Eigen::Index b) noexcept {
    return b * (b + 1) / 2 + a;
  }
  void find_inverse_places();

  Eigen::Index effects_ = 0;
  Eigen::Index per_row_ = 0;
  Eigen::Index pairs_ = 0;        ///< Of the elements of a row.
  std::vector<Eigen::Index> of_;  ///< rows x per_row: their places in u.
  /// rows x pairs of them, the first no later in u than the second: places in the values of H.
  std::vector<std::int32_t> pair_;
  std::vector<std::size_t> diagonal_;      ///< Places of H's diagonal.
  std::vector<std::size_t> inverse_from_;  ///< Per element of H: place in the factor's inverse.
  Matrix h_;                               ///< Lower triangle.
  Eigen::SimplicialLLT<Matrix> cholesky_;

  std::vector<double> inverse_;  ///< Per element of H.
};

}  // namespace tcert::statistics
