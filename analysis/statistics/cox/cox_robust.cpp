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
  scores.sums = Eigen::MatrixXd::Zero(
      p, cluster == nullptr ? 0 : static_cast<Eigen::Index>(cluster->levels.size()));
  const auto add = [p](const double* part, double* sum) {
    for (Eigen::Index j = 0; j < p; ++j) {
      sum[j] += part[j];
    }
  };
  const auto add_product = [&](const double* sum) {
    for (Eigen::Index b = 0; b < p; ++b) {
      for (Eigen::Index a = b; a < p; ++a) {
        scores.products(a, b) += sum[a] * sum[b];
      }
    }
  };
  for_each_score_residual(rows, steps, [&](std::size_t place, double* residual) {
    if (!rows.weight.empty()) {
      for (Eigen::Index j = 0; j < p; ++j) {
        residual[j] *= rows.weight[place];
      }
    }
    add(residual, scores.total.data());
    if (cluster == nullptr) {
      add_product(residual);
    } else {
      add(residual, scores.sums.data() + p * cluster->codes[rows.sets.order[place]]);
    }
  });
  for (Eigen::Index c = 0; c < scores.sums.cols(); ++c) {
    add_product(scores.sums.col(c).data());
  }
  scores.products = Eigen::MatrixXd(scores.products.selfadjointView<Eigen::Lower>());
  return scores;
}

}  // namespace tcert::statistics
