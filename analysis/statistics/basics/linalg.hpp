#pragma once
/// \file
/// Decompositions of small dense matrices. Eigen's templates for them take seconds to compile, so
/// that they are compiled here, once.

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace tcert::statistics {

/// L L' of a symmetric positive definite matrix. O(size^3).
class Cholesky {
 public:
  explicit Cholesky(const Eigen::MatrixXd& matrix);

  /// False if the matrix is not positive definite; nothing else may then be asked.
  [[nodiscard]] bool succeeded() const;
  /// The diagonal of L.
  [[nodiscard]] Eigen::VectorXd pivots() const;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  [[nodiscard]] Eigen::MatrixXd inverse() const;
  /// L^-1 right.
  [[nodiscard]] Eigen::VectorXd whiten(const Eigen::VectorXd& right) const;
  [[nodiscard]] Eigen::MatrixXd whiten(const Eigen::MatrixXd& right) const;

 private:
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// matrix^-1 right, by L D L' with pivots: of a symmetric matrix that need not be definite.
[[nodiscard]] Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix,
                                              const Eigen::VectorXd& right);
[[nodiscard]] Eigen::MatrixXd inverse_symmetric(const Eigen::MatrixXd& matrix);

/// Of a symmetric matrix: values in ascending order, and their vectors as columns.
struct Eigensystem {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

[[nodiscard]] Eigensystem eigensystem_of(const Eigen::MatrixXd& symmetric);
[[nodiscard]] Eigen::VectorXd eigenvalues_of(const Eigen::MatrixXd& symmetric);

/// Of the symmetric matrix with these entries on the diagonal and beside it.
[[nodiscard]] Eigen::VectorXd eigenvalues_of_tridiagonal(const Eigen::VectorXd& diagonal,
                                                         const Eigen::VectorXd& beside);

}  // namespace tcert::statistics
