#include <statistics/logistic/orthonormal_basis.hpp>

namespace tcert::statistics {

OrthonormalBasis orthonormal_basis(const Eigen::MatrixXd& design, double tolerance) {
  OrthonormalBasis result;
  const Eigen::Index columns = design.cols();
  const Eigen::Index most = std::min(columns, design.rows());
  result.basis.resize(design.rows(), most);
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(most, columns);
  Eigen::Index rank = 0;
  for (Eigen::Index j = 0; j < columns; ++j) {
    // Dividing by the largest cell first keeps squares of extreme columns representable.
    const double largest = design.rows() > 0 ? design.col(j).cwiseAbs().maxCoeff() : 0.0;
    Eigen::VectorXd rest = largest > 0.0 ? Eigen::VectorXd(design.col(j) / largest) : design.col(j);
    const double norm = rest.norm();
    Eigen::VectorXd along = Eigen::VectorXd::Zero(rank);
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd part = result.basis.leftCols(rank).transpose() * rest;
      rest.noalias() -= result.basis.leftCols(rank) * part;
      along += part;
    }
    triangle.col(j).head(rank) = along * largest;
    const double remains = rest.norm();
    if (rank == most || !(remains > tolerance * norm)) {
      result.dropped.push_back(static_cast<std::size_t>(j));
      continue;
    }
    result.basis.col(rank) = rest / remains;
    triangle(rank, j) = remains * largest;
    result.kept.push_back(static_cast<std::size_t>(j));
    ++rank;
  }
  result.basis.conservativeResize(Eigen::NoChange, rank);
  result.triangle.resize(rank, rank);
  for (Eigen::Index k = 0; k < rank; ++k) {
    const auto j = static_cast<Eigen::Index>(result.kept[static_cast<std::size_t>(k)]);
    result.triangle.col(k) = triangle.col(j).head(rank);
  }
  const auto dropped = static_cast<Eigen::Index>(result.dropped.size());
  result.combination.resize(rank, dropped);
  for (Eigen::Index k = 0; k < dropped; ++k) {
    const auto j = static_cast<Eigen::Index>(result.dropped[static_cast<std::size_t>(k)]);
    result.combination.col(k) = triangle.col(j).head(rank);
  }
  if (rank > 0 && dropped > 0) {
    result.triangle.triangularView<Eigen::Upper>().solveInPlace(result.combination);
  }
  return result;
}

}  // namespace tcert::statistics
