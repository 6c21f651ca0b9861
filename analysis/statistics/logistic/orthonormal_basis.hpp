#pragma once
/// \file
/// The column space of a design matrix as an orthonormal basis, and which columns the ones before
/// them determine.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace tcert::statistics {

/// X(:, kept) = basis * triangle; X(:, dropped) is a combination of the kept columns.
struct OrthonormalBasis {
  Eigen::MatrixXd basis;     ///< rows x rank, orthonormal columns.
  Eigen::MatrixXd triangle;  ///< rank x rank, upper, with a positive diagonal.
  std::vector<std::size_t> kept;
  std::vector<std::size_t> dropped;
  Eigen::MatrixXd combination;  ///< rank x dropped: coefficients of the kept columns.

  [[nodiscard]] Eigen::Index rank() const noexcept { return basis.cols(); }
};

/// R's `glm` at its default control: a column is dropped if less than this share of its norm is
/// new.
inline constexpr double kRankTolerance = 1e-11;

/// Gram–Schmidt with one reorthogonalisation, columns in their order, so that a column is dropped
/// for what precedes it, as LINPACK's dqrdc2 in R does. Scales of columns do not matter.
/// \pre `design` is finite. O(rows columns^2).
[[nodiscard]] OrthonormalBasis orthonormal_basis(const Eigen::MatrixXd& design,
                                                 double tolerance = kRankTolerance);

}  // namespace tcert::statistics
