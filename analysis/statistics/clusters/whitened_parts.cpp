#include <statistics/clusters/whitened_parts.hpp>

#include <statistics/basics/linalg.hpp>

namespace tcert::statistics {

std::optional<SandwichParts> whitened_parts(const Eigen::MatrixXd& information,
                                            const Eigen::MatrixXd& scores,
                                            const std::vector<Eigen::MatrixXd>& by_cluster,
                                            const Eigen::MatrixXd& functionals) {
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(information.rows(), information.cols());
  for (const Eigen::MatrixXd& one : by_cluster) {
    total += one;
  }
  const Cholesky root(information);
  const Cholesky share_root(total);
  if (!root.succeeded() || !share_root.succeeded()) {
    return std::nullopt;
  }
  SandwichParts parts;
  parts.scores = root.whiten(scores);
  parts.functionals = root.whiten(functionals);
  for (const Eigen::MatrixXd& one : by_cluster) {
    const Eigen::MatrixXd half = share_root.whiten(one).transpose();
    const Eigen::MatrixXd share = share_root.whiten(half);
    parts.shares.emplace_back(0.5 * (share + share.transpose()));
  }
  return parts;
}

}  // namespace tcert::statistics
