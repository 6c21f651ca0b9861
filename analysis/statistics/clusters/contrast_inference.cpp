#include <statistics/clusters/contrast_inference.hpp>

#include <statistics/clusters/cluster_variance.hpp>

namespace tcert::statistics {
namespace {

/// `parts` as if the sums were the coefficients; what has no weight does not count, also if NaN.
SandwichParts parts_of_sums(const SandwichParts& parts, const Eigen::MatrixXd& weights) {
  SandwichParts sums = parts;
  sums.functionals.setZero(parts.functionals.rows(), weights.rows());
  sums.estimates.setZero(weights.rows());
  for (Eigen::Index k = 0; k < weights.rows(); ++k) {
    for (Eigen::Index j = 0; j < weights.cols(); ++j) {
      if (weights(k, j) != 0.0) {
        sums.functionals.col(k) += weights(k, j) * parts.functionals.col(j);
        sums.estimates(k) += weights(k, j) * parts.estimates(j);
      }
    }
  }
  return sums;
}

}  // namespace

std::vector<CoefficientSum> cluster_sums(const std::optional<ClusteredFit>& fit,
                                         const ClusterInferences& of,
                                         std::span<const std::optional<double>> coefficients,
                                         std::size_t clusters,
                                         const Eigen::MatrixXd& weights) {
  const bool has_spread = clusters > 1 && of.by != ClusterInference::wild;
  std::vector<CoefficientSum> sums =
      sums_by_covariance(coefficients,
                         has_spread ? of.covariance : Eigen::MatrixXd(),
                         static_cast<double>(clusters) - 1.0,
                         weights);
  if (of.by == ClusterInference::cr2 && has_spread && fit) {
    const Eigen::VectorXd df = satterthwaite_df(parts_of_sums(fit->parts, weights));
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k].df =
          sums[k].standard_error ? std::optional(df(static_cast<Eigen::Index>(k))) : std::nullopt;
    }
  }
  return sums;
}

}  // namespace tcert::statistics
