#include <statistics/basics/linalg.hpp>

#include <Eigen/Eigenvalues>

namespace tcert::statistics {

Cholesky::Cholesky(const Eigen::MatrixXd& matrix) : factor_(matrix) {}

bool Cholesky::succeeded() const { return factor_.info() == Eigen::Success; }

Eigen::VectorXd Cholesky::pivots() const { return factor_.matrixLLT().diagonal(); }

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& right) const { return factor_.solve(right); }

Eigen::MatrixXd Cholesky::solve(const Eigen::MatrixXd& right) const { return factor_.solve(right); }

Eigen::MatrixXd Cholesky::inverse() const {
  return solve(Eigen::MatrixXd::Identity(factor_.rows(), factor_.cols()).eval());
}

Eigen::VectorXd Cholesky::whiten(const Eigen::VectorXd& right) const {
  return factor_.matrixL().solve(right);
}

Eigen::MatrixXd Cholesky::whiten(const Eigen::MatrixXd& right) const {
  return factor_.matrixL().solve(right);
}

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd inverse_symmetric(const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  return matrix.ldlt().solve(identity);
}

Eigensystem eigensystem_of(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd eigenvalues_of(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
  return solver.eigenvalues();
}

Eigen::VectorXd eigenvalues_of_tridiagonal(const Eigen::VectorXd& diagonal,
                                           const Eigen::VectorXd& beside) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return solver.eigenvalues();
}

}  // namespace tcert::statistics
