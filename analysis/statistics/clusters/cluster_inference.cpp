#include <statistics/clusters/cluster_inference.hpp>

#include <cmath>
#include <statistics/clusters/cluster_variance.hpp>

namespace tcert::statistics {
namespace {

struct Spread {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd df;
};

Spread spread_of(const ClusteredFit& fit, ClusterInference inference) {
  const auto groups = static_cast<double>(fit.parts.clusters());
  const Eigen::Index p = fit.parts.estimates.size();
  Spread spread{{}, Eigen::VectorXd::Constant(p, groups - 1.0)};
  switch (inference) {
    case ClusterInference::cr1:
    case ClusterInference::wild:
      spread.covariance = groups / (groups - 1.0) * sandwich_cr0(fit.parts);
      break;
    case ClusterInference::cr2:
      spread.covariance = sandwich_cr2(fit.parts);
      spread.df = satterthwaite_df(fit.parts);
      break;
    case ClusterInference::jackknife:
      spread.covariance = jackknife_covariance(fit.parts.estimates, fit.left_out());
      break;
  }
  return spread;
}

void by_wild_bootstrap(const ClusteredFit& fit,
                       std::size_t k,
                       const WildOptions& options,
                       ClusterT& estimate) {
  estimate.df.reset();
  estimate.p_value.reset();
  estimate.interval.reset();
  const auto null = fit.parts_at(k, 0.0);
  estimate.p_value = null ? wild_p_value(*null, k, options) : std::nullopt;
  if (estimate.standard_error) {
    estimate.interval = wild_interval(fit.parts_at,
                                      k,
                                      fit.parts.estimates(static_cast<Eigen::Index>(k)),
                                      *estimate.standard_error,
                                      options);
  }
}

}  // namespace

std::string_view to_string(ClusterInference inference) noexcept {
  switch (inference) {
    case ClusterInference::cr1:
      return "cr1";
    case ClusterInference::cr2:
      return "cr2";
    case ClusterInference::jackknife:
      return "jackknife";
    case ClusterInference::wild:
      return "wild";
  }
  return "";
}

double jackknife_variance(double estimate, const Eigen::VectorXd& left_out) {
  const auto groups = static_cast<double>(left_out.size());
  return (groups - 1.0) / groups * (left_out.array() - estimate).square().sum();
}

Eigen::MatrixXd jackknife_covariance(const Eigen::VectorXd& estimates,
                                     const Eigen::MatrixXd& left_out) {
  const auto groups = static_cast<double>(left_out.cols());
  const Eigen::MatrixXd changes = left_out.colwise() - estimates;
  return (groups - 1.0) / groups * changes * changes.transpose();
}

ClusterT jackknife_estimate(double estimate, std::span<const double> left_out, double level) {
  const Eigen::Map<const Eigen::VectorXd> values(left_out.data(),
                                                 static_cast<Eigen::Index>(left_out.size()));
  return by_student_t(estimate,
                      std::sqrt(jackknife_variance(estimate, values)),
                      static_cast<double>(left_out.size()) - 1.0,
                      level);
}

ClusterT cr1_estimate(const std::optional<double>& estimate,
                      const std::optional<double>& robust_error,
                      std::size_t clusters,
                      double level) {
  if (!estimate || !robust_error || clusters < 2) {
    return {};
  }
  const auto groups = static_cast<double>(clusters);
  return by_student_t(
      *estimate, *robust_error * std::sqrt(groups / (groups - 1.0)), groups - 1.0, level);
}

ClusterInference default_inference(std::size_t clusters) noexcept {
  return clusters > kMostJackknifeClusters ? ClusterInference::cr1 : ClusterInference::jackknife;
}

ClusterInferences cluster_inferences(const ClusteredFit& fit,
                                     std::optional<ClusterInference> inference,
                                     const WildOptions& options) {
  ClusterInferences all;
  all.by = inference.value_or(default_inference(fit.parts.clusters()));
  all.of.resize(static_cast<std::size_t>(fit.parts.estimates.size()));
  if (fit.parts.clusters() < 2) {
    return all;
  }
  const Spread spread = spread_of(fit, all.by);
  all.covariance = spread.covariance;
  for (std::size_t k = 0; k < all.of.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    all.of[k] = by_student_t(
        fit.parts.estimates(at), std::sqrt(all.covariance(at, at)), spread.df(at), options.level);
    if (all.by == ClusterInference::wild && std::isfinite(fit.parts.estimates(at))) {
      by_wild_bootstrap(fit, k, options, all.of[k]);
    }
  }
  return all;
}

}  // namespace tcert::statistics
