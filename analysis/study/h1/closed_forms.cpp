#include "analysis/study/h1/closed_forms.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/standard_deviation.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/concordance/concordance.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/model/variable.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/roc.hpp>

#include "analysis/study/h1/hazard_ratio.hpp"
#include "analysis/study/h1/nested_models.hpp"

namespace tcert::study {
namespace {

std::vector<double> as_numbers(const std::vector<std::uint8_t>& success) {
  return {success.begin(), success.end()};
}

statistics::JointAuc aucs(const H1Data& data, const H1Options& options, bool clustered) {
  statistics::AucOptions auc_options;
  auc_options.level = options.level;
  if (clustered) {
    auc_options.cluster = data.cluster.codes;
  }
  return statistics::joint_auc(data.scores(), as_numbers(data.success), auc_options);
}

statistics::ConcordanceResult concordances(const H1Data& data,
                                           const H1Options& options,
                                           bool clustered) {
  std::vector<statistics::Predictor> predictors;
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    predictors.push_back(data.timed(k));
  }
  statistics::ConcordanceOptions concordance_options;
  concordance_options.level = options.level;
  if (clustered) {
    concordance_options.cluster = &data.cluster;
  }
  return statistics::concordance(*data.censored, predictors, concordance_options);
}

std::optional<double> root(const std::optional<double>& variance) {
  return variance ? std::optional(std::sqrt(*variance)) : std::nullopt;
}

/// The difference between the predictor under test and rival `k`.
const statistics::ConcordanceDifference& gain_of(const statistics::ConcordanceResult& result,
                                                 std::size_t k) {
  return result.differences[k - 1];
}

void add_clustered(const H1Data& data, const H1Options& options, H1Panel& panel) {
  const statistics::JointAuc joint = aucs(data, options, true);
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    H1Row& row = panel.rows[k];
    row.auc.closed_form = joint.markers[k].interval;
    row.auc.std_error = root(joint.markers[k].variance);
    if (k > 0) {
      const statistics::AucDifference gain = statistics::auc_contrast(joint, 0, k);
      row.auc_gain.closed_form = gain.interval;
      row.auc_gain.std_error = root(gain.variance);
    }
  }
  if (!data.censored) {
    return;
  }
  const statistics::ConcordanceResult result = concordances(data, options, true);
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    H1Row& row = panel.rows[k];
    row.c.closed_form = result.estimates[k].interval;
    row.c.std_error = result.estimates[k].std_error;
    if (k > 0) {
      row.c_gain.closed_form = gain_of(result, k).interval;
      row.c_gain.std_error = gain_of(result, k).std_error;
    }
  }
}

void add_case_level(const H1Data& data, const H1Options& options, H1Panel& panel) {
  const statistics::JointAuc joint = aucs(data, options, false);
  std::optional<statistics::ConcordanceResult> result;
  if (data.censored) {
    result = concordances(data, options, false);
  }
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    H1CaseRow row;
    row.name = data.names[k];
    row.auc = {joint.markers[k].auc,
               {},
               {},
               joint.markers[k].interval,
               root(joint.markers[k].variance),
               {}};
    if (k > 0) {
      row.auc_gain_p = statistics::auc_contrast(joint, 0, k).p_value;
    }
    if (result) {
      const statistics::ConcordanceEstimate& c = result->estimates[k];
      row.c = {c.c, {}, {}, c.interval, c.std_error, {}};
      if (k > 0) {
        row.c_gain_p = gain_of(*result, k).p_value;
      }
    }
    panel.case_level.push_back(std::move(row));
  }
}

/// `others` are predictors that the model holds besides `k`, which comes first.
statistics::CoxData cox_of(const statistics::SurvivalOutcome& outcome,
                           const H1Data& data,
                           std::size_t k,
                           const std::vector<std::size_t>& others) {
  statistics::CoxData cox;
  cox.outcome = outcome;
  cox.design.resize(static_cast<Eigen::Index>(data.rows()),
                    static_cast<Eigen::Index>(others.size()) + 1);
  cox.design.col(0) = per_sd(data, k);
  cox.columns = {data.names[k]};
  cox.terms = {data.names[k]};
  cox.term_of = {0};
  for (const std::size_t other : others) {
    const auto column = static_cast<Eigen::Index>(cox.columns.size());
    cox.design.col(column) = per_sd(data, other);
    cox.columns.push_back(data.names[other]);
    cox.terms.push_back(data.names[other]);
    cox.term_of.push_back(cox.term_of.size());
  }
  return cox;
}

void add_spreads(const H1Data& data, H1Panel& panel) {
  for (std::size_t r = 0; r < panel.rows.size(); ++r) {
    H1Row& row = panel.rows[r];
    if (row.kind != H1RowKind::together) {
      row.sd =
          statistics::standard_deviation(data.predictors[row.kind == H1RowKind::added ? 0 : r]);
    }
  }
}

void add_hazard_ratios(const H1Data& data, const H1Options& options, H1Panel& panel) {
  if (!data.censored) {
    return;
  }
  std::vector<std::size_t> rivals;
  for (std::size_t k = 1; k < data.predictors.size(); ++k) {
    rivals.push_back(k);
  }
  for (std::size_t r = 0; r < panel.rows.size(); ++r) {
    H1Row& row = panel.rows[r];
    if (row.kind == H1RowKind::together) {
      continue;  // No single ratio.
    }
    const bool added = row.kind == H1RowKind::added;
    const std::size_t k = added ? 0 : r;
    const auto& others = added ? rivals : std::vector<std::size_t>{};
    const statistics::CoxData censored = cox_of(*data.censored, data, k, others);
    row.censored = hazard_ratio(censored, data, options.level, false, row.conditions);
    row.at_limit = hazard_ratio(
        cox_of(*data.at_limit, data, k, others), data, options.level, false, row.conditions);
    if (data.strata) {
      row.stratified = hazard_ratio(censored, data, options.level, true, row.conditions);
    }
  }
}

/// Failures take longer than everyone who arrives, as they do to the trial limit.
void add_c_at_limit(const H1Data& data, double level, H1Panel& panel) {
  if (!data.at_limit) {
    return;
  }
  std::vector<statistics::Predictor> predictors;
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    predictors.push_back(data.timed(k));
  }
  const statistics::Statistic c = statistics::concordance_statistic(*data.at_limit, predictors);
  std::vector<double> values(c.values);
  c.make_kernel()(std::vector<std::uint32_t>(data.rows(), 1), values);
  const auto left_out =
      statistics::leave_one_out(c, statistics::ResamplingPlan::of_clusters(data.cluster.codes));
  for (std::size_t k = 0; k < predictors.size(); ++k) {
    const statistics::ClusterT spread =
        statistics::jackknife_estimate(values[k], left_out[k], level);
    H1Score& score = panel.rows[k].c_at_limit;
    score.value = std::isnan(values[k]) ? std::nullopt : std::optional(values[k]);
    score.std_error = spread.standard_error;
    score.interval = spread.interval;
    if (score.interval) {
      score.interval->low = std::max(0.0, score.interval->low);
      score.interval->high = std::min(1.0, score.interval->high);
    }
  }
}

}  // namespace

void add_closed_forms(const H1Data& data,
                      const H1Models& models,
                      const H1Options& options,
                      H1Panel& panel) {
  add_clustered(data, options, panel);
  add_case_level(data, options, panel);
  add_spreads(data, panel);
  add_hazard_ratios(data, options, panel);
  add_c_at_limit(data, options.level, panel);
  add_nested_tests(data, models, panel);
}

}  // namespace tcert::study
