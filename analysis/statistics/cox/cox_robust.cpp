#include <statistics/cox/cox_robust.hpp>

#include <statistics/cox/cox_hazard_steps.hpp>

namespace tcert::statistics {

ClusterScores cluster_scores(const CoxRows& rows,
                             const Eigen::VectorXd& beta,
                             Ties ties,
                             const table::Factor* cluster) {
  const HazardSteps steps = hazard_steps(rows, beta, ties);
  const auto p = static_cast<Eigen::Index>(rows.columns);
  ClusterScores scores;
  scores.products = Eigen::MatrixXd::Zero(p, p);
  scores.total = Eigen::VectorXd::Zero(p);
  Eigen::MatrixXd& sums = scores.sums;
  sums = Eigen::MatrixXd::Zero(
      p, cluster == nullptr ? 0 : static_cast<Eigen::Index>(cluster->levels.size()));
  Eigen::VectorXd residual(p);
  const auto add_product = [&](const Eigen::VectorXd& sum) {
    for (Eigen::Index b = 0; b < p; ++b) {
      for (Eigen::Index a = b; a < p; ++a) {
        scores.products(a, b) += sum(a) * sum(b);
      }
    }
  };
  for (std::size_t place = 0; place < rows.rows(); ++place) {
    score_residual(rows, steps, place, residual.data());
    residual *= rows.weight_of(place);
    scores.total += residual;
    if (cluster == nullptr) {
      add_product(residual);
    } else {
      sums.col(static_cast<Eigen::Index>(cluster->codes[rows.sets.order[place]])) += residual;
    }
  }
  for (Eigen::Index c = 0; c < sums.cols(); ++c) {
    add_product(sums.col(c));
  }
  scores.products = Eigen::MatrixXd(scores.products.selfadjointView<Eigen::Lower>());
  return scores;
}

}  // namespace tcert::statistics
