#include <statistics/cox/cox_robust.hpp>

#include <statistics/cox/cox_hazard_steps.hpp>
#include <vector>

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
  // In places, so that the sums that come next can be fetched ahead: they lie all over memory.
  constexpr std::size_t kAhead = 16;
  std::vector<std::uint32_t> cluster_of(cluster == nullptr ? 0 : rows.rows());
  for (std::size_t place = 0; place < cluster_of.size(); ++place) {
    cluster_of[place] = cluster->codes[rows.sets.order[place]];
  }
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
      if (place + kAhead < cluster_of.size()) {
        __builtin_prefetch(scores.sums.data() + p * cluster_of[place + kAhead]);
      }
      add(residual, scores.sums.data() + p * cluster_of[place]);
    }
  });
  for (Eigen::Index c = 0; c < scores.sums.cols(); ++c) {
    add_product(scores.sums.col(c).data());
  }
  scores.products = Eigen::MatrixXd(scores.products.selfadjointView<Eigen::Lower>());
  return scores;
}

}  // namespace tcert::statistics
