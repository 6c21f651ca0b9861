#include <statistics/clusters/cluster_variance.hpp>

#include <cmath>
#include <statistics/basics/linalg.hpp>

namespace tcert::statistics {
namespace {

/// (I - share)^(-1/2); 0 along directions that the cluster alone determines.
Eigen::MatrixXd bell_mccaffrey(const Eigen::MatrixXd& share) {
  constexpr double kNothingLeft = 1e-12;
  const Eigensystem system = eigensystem_of(share);
  Eigen::VectorXd factor(system.values.size());
  for (Eigen::Index j = 0; j < factor.size(); ++j) {
    const double left = 1.0 - system.values(j);
    factor(j) = left > kNothingLeft ? 1.0 / std::sqrt(left) : 0.0;
  }
  return system.vectors * factor.asDiagonal() * system.vectors.transpose();
}

Eigen::MatrixXd products_of(const SandwichParts& parts, const Eigen::MatrixXd& scores) {
  const Eigen::MatrixXd changes = parts.functionals.transpose() * scores;
  return changes * changes.transpose();
}

}  // namespace

Eigen::MatrixXd sandwich_cr0(const SandwichParts& parts) {
  return products_of(parts, parts.scores);
}

Eigen::MatrixXd sandwich_cr2(const SandwichParts& parts) {
  Eigen::MatrixXd scores = parts.scores;
  for (std::size_t g = 0; g < parts.clusters(); ++g) {
    const auto column = static_cast<Eigen::Index>(g);
    scores.col(column) = bell_mccaffrey(parts.shares[g]) * parts.scores.col(column);
  }
  return products_of(parts, scores);
}

Eigen::VectorXd satterthwaite_df(const SandwichParts& parts) {
  // The variance is the sum of (h_g' z)^2 with h_g' h_k = d_g [g = k] - b_g' b_k.
  const Eigen::Index r = parts.functionals.rows();
  const Eigen::Index p = parts.functionals.cols();
  Eigen::VectorXd trace = Eigen::VectorXd::Zero(p);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(p);
  std::vector<Eigen::MatrixXd> outer(static_cast<std::size_t>(p), Eigen::MatrixXd::Zero(r, r));
  for (const Eigen::MatrixXd& share : parts.shares) {
    const Eigen::MatrixXd a = bell_mccaffrey(share) * parts.functionals;
    const Eigen::MatrixXd b = share * a;
    for (Eigen::Index j = 0; j < p; ++j) {
      const double d = a.col(j).dot(b.col(j));
      const double own = b.col(j).squaredNorm();
      trace(j) += d - own;
      squares(j) += d * d - 2.0 * d * own;
      outer[static_cast<std::size_t>(j)] += b.col(j) * b.col(j).transpose();
    }
  }
  for (Eigen::Index j = 0; j < p; ++j) {
    squares(j) += outer[static_cast<std::size_t>(j)].squaredNorm();
  }
  return trace.cwiseProduct(trace).cwiseQuotient(squares);
}

}  // namespace tcert::statistics
