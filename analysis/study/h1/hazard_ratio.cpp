#include "analysis/study/h1/hazard_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/standard_deviation.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <string>

namespace tcert::study {
namespace {

/// The rows whose stratum is known, with their strata.
statistics::CoxData in_strata(const statistics::CoxData& cox,
                              const H1Data& data,
                              statistics::Conditions& conditions) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    if (data.strata->codes[i] != table::Factor::kMissing) {
      rows.push_back(i);
    }
  }
  statistics::CoxData kept = cox;
  kept.strata = data.strata;
  if (rows.size() == data.rows()) {
    return kept;
  }
  conditions.push_back(
      {statistics::ConditionKind::missing_rows,
       statistics::ConditionSeverity::note,
       data.strata_name,
       std::to_string(data.rows() - rows.size()) + " of the stratified hazard ratio"});
  return statistics::on_rows(kept, rows);
}

}  // namespace

Eigen::VectorXd per_sd(const H1Data& data, std::size_t k) {
  const std::vector<double>& values = data.predictors[k];
  const double sign = data.higher[k] == statistics::HigherMeans::success ? 1.0 : -1.0;
  const Eigen::Map<const Eigen::VectorXd> x(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  const double sd = statistics::standard_deviation(values);
  return x * (sd > 0.0 ? sign / sd : sign);
}

void take_ratio(const std::optional<double>& ratio,
                const statistics::ClusterT& by_clusters,
                H1HazardRatio& result) {
  result.ratio = ratio;
  result.p_value = by_clusters.p_value;
  if (const auto& log_ratio = by_clusters.interval) {
    result.interval =
        statistics::Interval{std::exp(log_ratio->low), std::exp(log_ratio->high), log_ratio->level};
  }
}

H1HazardRatio hazard_ratio(statistics::CoxData cox,
                           const H1Data& data,
                           double level,
                           bool stratified,
                           statistics::Conditions& conditions) {
  cox.cluster = data.cluster;
  if (stratified) {
    cox = in_strata(cox, data, conditions);
  }
  statistics::CoxOptions cox_options;
  cox_options.level = level;
  const statistics::CoxFit fit = statistics::fit_cox(cox, cox_options);
  H1HazardRatio result;
  const statistics::CoxCoefficient& coefficient = fit.coefficients.front();
  statistics::WildOptions wild;
  wild.level = level;
  take_ratio(coefficient.hazard_ratio,
             statistics::cluster_inferences(cox, fit, {}, wild).of.front(),
             result);
  for (const statistics::Condition& condition : fit.conditions) {
    const bool known =
        std::find(conditions.begin(), conditions.end(), condition) != conditions.end();
    if (condition.kind != statistics::ConditionKind::few_clusters && !known) {
      conditions.push_back(condition);
    }
  }
  return result;
}

}  // namespace tcert::study
