#include <statistics/clusters/one_step.hpp>

#include <statistics/basics/linalg.hpp>
#include <table/not_a_number.hpp>

namespace tcert::statistics {

Eigen::MatrixXd one_step_changes(const SandwichParts& parts) {
  // Where a cluster holds all of a direction, rounding leaves of I - share 1e-16 of either sign.
  constexpr double kNothingLeft = 1e-9;
  Eigen::MatrixXd changes(parts.scores.rows(), parts.scores.cols());
  for (Eigen::Index g = 0; g < changes.cols(); ++g) {
    const Eigensystem system = eigensystem_of(parts.shares[static_cast<std::size_t>(g)]);
    const Eigen::ArrayXd left = 1.0 - system.values.array();
    if ((left > kNothingLeft).all()) {
      const Eigen::ArrayXd along = (system.vectors.transpose() * parts.scores.col(g)).array();
      changes.col(g) = -(system.vectors * (along / left).matrix());
    } else {
      changes.col(g).setConstant(table::kNaN);
    }
  }
  return changes;
}

}  // namespace tcert::statistics
