#include <statistics/clusters/one_step.hpp>

#include <Eigen/Cholesky>
#include <table/not_a_number.hpp>

namespace tcert::statistics {

Eigen::MatrixXd one_step_changes(const SandwichParts& parts) {
  const Eigen::Index r = parts.scores.rows();
  Eigen::MatrixXd changes(r, parts.scores.cols());
  for (Eigen::Index g = 0; g < changes.cols(); ++g) {
    const Eigen::MatrixXd rest =
        Eigen::MatrixXd::Identity(r, r) - parts.shares[static_cast<std::size_t>(g)];
    const Eigen::LLT<Eigen::MatrixXd> root(rest);
    if (root.info() == Eigen::Success) {
      changes.col(g) = -root.solve(parts.scores.col(g));
    } else {
      changes.col(g).setConstant(table::kNaN);
    }
  }
  return changes;
}

}  // namespace tcert::statistics
