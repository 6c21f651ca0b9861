#include <statistics/clusters/cluster_inference.hpp>

#include <cmath>
#include <statistics/basics/student_t.hpp>
#include <statistics/clusters/cluster_variance.hpp>

namespace tcert::statistics {
namespace {

struct Spread {
  Eigen::VectorXd variance;
  Eigen::VectorXd df;
};

Spread spread_of(const ClusteredFit& fit, ClusterInference inference) {
  const auto groups = static_cast<double>(fit.parts.clusters());
  const Eigen::Index p = fit.parts.estimates.size();
  Spread spread{{}, Eigen::VectorXd::Constant(p, groups - 1.0)};
  switch (inference) {
    case ClusterInference::cr1:
    case ClusterInference::wild:
      spread.variance = groups / (groups - 1.0) * sandwich_cr0(fit.parts).diagonal();
      break;
    case ClusterInference::cr2:
      spread.variance = sandwich_cr2(fit.parts).diagonal();
      spread.df = satterthwaite_df(fit.parts);
      break;
    case ClusterInference::jackknife: {
      const Eigen::MatrixXd left_out = fit.left_out();
      spread.variance.resize(p);
      for (Eigen::Index j = 0; j < p; ++j) {
        spread.variance(j) = jackknife_variance(fit.parts.estimates(j), left_out.row(j));
      }
      break;
    }
  }
  return spread;
}

void by_wild_bootstrap(const ClusteredFit& fit,
                       std::size_t k,
                       const WildOptions& options,
                       ClusterEstimate& estimate) {
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

ClusterEstimate by_t(double estimate, double standard_error, double df, double level) {
  ClusterEstimate result;
  if (!std::isfinite(estimate) || !(standard_error > 0.0) || !std::isfinite(standard_error) ||
      !(df > 0.0)) {
    return result;
  }
  const double half = t_factor(level, df) * standard_error;
  result.standard_error = standard_error;
  result.df = df;
  result.p_value = t_p_value(estimate / standard_error, df, Alternative::two_sided);
  result.interval = Interval{estimate - half, estimate + half, level};
  return result;
}

double jackknife_variance(double estimate, const Eigen::VectorXd& left_out) {
  const auto groups = static_cast<double>(left_out.size());
  return (groups - 1.0) / groups * (left_out.array() - estimate).square().sum();
}

std::vector<ClusterEstimate> cluster_estimates(const ClusteredFit& fit,
                                               ClusterInference inference,
                                               const WildOptions& options) {
  std::vector<ClusterEstimate> estimates(static_cast<std::size_t>(fit.parts.estimates.size()));
  if (fit.parts.clusters() < 2) {
    return estimates;
  }
  const Spread spread = spread_of(fit, inference);
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    estimates[k] =
        by_t(fit.parts.estimates(at), std::sqrt(spread.variance(at)), spread.df(at), options.level);
    if (inference == ClusterInference::wild && std::isfinite(fit.parts.estimates(at))) {
      by_wild_bootstrap(fit, k, options, estimates[k]);
    }
  }
  return estimates;
}

}  // namespace tcert::statistics
