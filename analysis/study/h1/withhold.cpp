#include "analysis/study/h1/withhold.hpp"

#include <algorithm>
#include <limits>
#include <statistics/basics/few_clusters.hpp>

namespace tcert::study {
namespace {

std::string fewer_than(std::size_t count, const std::string& what, std::size_t least) {
  return std::to_string(count) + " " + what + ", fewer than " + std::to_string(least);
}

void withhold(H1OddsRatio& ratio) { ratio.interval.reset(); }

void withhold(statistics::WaldEstimate& coefficient) {
  coefficient.standard_error.reset();
  coefficient.interval.reset();
}

void withhold(H1Row& row) {
  for (H1Score* const score : {&row.auc,
                               &row.auc_gain,
                               &row.c,
                               &row.c_gain,
                               &row.c_at_limit,
                               &row.within.auc,
                               &row.within.auc_gain,
                               &row.within.auc_gain_between,
                               &row.within.c,
                               &row.within.c_gain,
                               &row.within.c_gain_between}) {
    withhold(*score);
  }
  for (std::optional<double>* const p : {&row.auc_p,
                                         &row.auc_lr_p,
                                         &row.auc_holm,
                                         &row.c_p,
                                         &row.c_lr_p,
                                         &row.c_holm,
                                         &row.within.auc_gain_p,
                                         &row.within.c_gain_p,
                                         &row.mixed.p_value,
                                         &row.mixed.lr_p_value,
                                         &row.log_time.r2_gain_p,
                                         &row.log_time.p_value}) {
    p->reset();
  }
  withhold(row.censored);
  withhold(row.at_limit);
  withhold(row.stratified);
  withhold(row.mixed.per_sd);
  withhold(row.mixed.per_cm);
  row.log_time.r2_gain_interval.reset();
  row.log_time.interval.reset();
}

void withhold(H1CaseRow& row) {
  withhold(row.auc);
  withhold(row.c);
  row.auc_gain_p.reset();
  row.c_gain_p.reset();
}

void withhold(statistics::IncidenceCurves& curves) {
  const auto none = [](statistics::IncidenceCurve& curve) {
    std::fill(
        curve.std_error.begin(), curve.std_error.end(), std::numeric_limits<double>::quiet_NaN());
  };
  std::for_each(curves.causes.begin(), curves.causes.end(), none);
  none(curves.event_free);
}

}  // namespace

std::string too_few(const std::string& cluster,
                    std::size_t clusters,
                    std::size_t successes,
                    std::size_t failures,
                    std::size_t least_clusters) {
  if (clusters < least_clusters) {
    return fewer_than(
        clusters, cluster.empty() ? "trials" : "clusters of '" + cluster + "'", least_clusters);
  }
  if (std::min(successes, failures) < kTooFewOutcomes) {
    return failures < successes ? fewer_than(failures, "failures", kTooFewOutcomes)
                                : fewer_than(successes, "successes", kTooFewOutcomes);
  }
  return "";
}

statistics::Condition withheld(const std::string& reason) {
  return {statistics::ConditionKind::withheld, statistics::ConditionSeverity::warning, "", reason};
}

void erase_resampling_conditions(statistics::Conditions& conditions) {
  std::erase_if(conditions, [](const statistics::Condition& condition) {
    return condition.kind == statistics::ConditionKind::endpoint_out_of_range ||
           condition.kind == statistics::ConditionKind::failed_replicates ||
           condition.kind == statistics::ConditionKind::constant_replicates ||
           condition.kind == statistics::ConditionKind::infinite_bias ||
           condition.kind == statistics::ConditionKind::no_acceleration;
  });
}

void withhold(H1Score& score) {
  score.interval.reset();
  score.intervals = {};
  score.closed_form.reset();
  score.std_error.reset();
  score.p_value.reset();
}

void withhold(H1HazardRatio& ratio) {
  ratio.interval.reset();
  ratio.p_value.reset();
}

void withhold_if_few(const H1Options& options, H1Panel& panel) {
  panel.withheld = too_few(
      panel.has_clusters ? options.cluster : "", panel.clusters, panel.successes, panel.failures);
  if (panel.withheld.empty()) {
    return;
  }
  panel.conditions.push_back(withheld(panel.withheld));
  for (H1Row& row : panel.rows) {
    withhold(row);
    erase_resampling_conditions(row.conditions);
  }
  for (H1CaseRow& row : panel.case_level) {
    withhold(row);
  }
  for (statistics::IncidenceCurves& curves : panel.incidence) {
    withhold(curves);
  }
  for (H1Calibration& one : panel.calibration) {
    withhold(one.calibration.slope);
    withhold(one.calibration.intercept);
    withhold(one.calibration.in_the_large);
    for (statistics::CalibrationBin& bin : one.calibration.bins) {
      bin.wilson.reset();  // It takes trials as independent.
    }
  }
}

}  // namespace tcert::study
