#include "analysis/h1/hazard_ratio.hpp"

#include <cmath>

namespace tcert {

double standard_deviation(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> x(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(values.size() - 1));
}

Eigen::VectorXd per_sd(const H1Data& data, std::size_t k) {
  const std::vector<double>& values = data.predictors[k];
  const double sign = data.higher[k] == HigherMeans::success ? 1.0 : -1.0;
  const Eigen::Map<const Eigen::VectorXd> x(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  return x * (sign / standard_deviation(values));
}

H1HazardRatio hazard_ratio(
    CoxData cox, const H1Data& data, double level, bool stratified, Conditions& conditions) {
  cox.cluster = data.cluster;
  if (stratified) {
    cox.strata = data.strata;
  }
  CoxOptions cox_options;
  cox_options.level = level;
  const CoxFit fit = fit_cox(cox, cox_options);
  H1HazardRatio result;
  const CoxCoefficient& coefficient = fit.coefficients.front();
  result.ratio = coefficient.hazard_ratio;
  result.p_value = coefficient.p_value;
  if (coefficient.interval) {
    result.interval =
        Interval{std::exp(coefficient.interval->low), std::exp(coefficient.interval->high), level};
  }
  for (const Condition& condition : fit.conditions) {
    if (condition.kind != ConditionKind::few_clusters) {
      conditions.push_back(condition);
    }
  }
  return result;
}

}  // namespace tcert
