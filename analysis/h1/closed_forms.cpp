#include "analysis/h1/closed_forms.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/basics/chi_square.hpp"
#include "analysis/concordance/concordance.hpp"
#include "analysis/cox/cox.hpp"
#include "analysis/model/variable.hpp"
#include "analysis/roc/roc.hpp"

namespace tcert {
namespace {

std::vector<Score> scores_of(const H1Data& data) {
  std::vector<Score> scores;
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    scores.push_back(data.score(k));
  }
  return scores;
}

std::vector<double> as_numbers(const std::vector<std::uint8_t>& success) {
  return {success.begin(), success.end()};
}

JointAuc aucs(const H1Data& data, const H1Options& options, bool clustered) {
  AucOptions auc_options;
  auc_options.level = options.level;
  if (clustered) {
    auc_options.cluster = data.cluster.codes;
  }
  return joint_auc(scores_of(data), as_numbers(data.success), auc_options);
}

ConcordanceResult concordances(const H1Data& data, const H1Options& options, bool clustered) {
  std::vector<Predictor> predictors;
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    predictors.push_back(data.timed(k));
  }
  ConcordanceOptions concordance_options;
  concordance_options.level = options.level;
  if (clustered) {
    concordance_options.cluster = &data.cluster;
  }
  return concordance(*data.censored, predictors, concordance_options);
}

std::optional<double> root(const std::optional<double>& variance) {
  return variance ? std::optional(std::sqrt(*variance)) : std::nullopt;
}

/// The difference between the predictor under test and rival `k`.
const ConcordanceDifference& gain_of(const ConcordanceResult& result, std::size_t k) {
  return result.differences[k - 1];
}

void add_clustered(const H1Data& data, const H1Options& options, H1Panel& panel) {
  const JointAuc joint = aucs(data, options, true);
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    H1Row& row = panel.rows[k];
    row.auc.closed_form = joint.markers[k].interval;
    row.auc.std_error = root(joint.markers[k].variance);
    if (k > 0) {
      const AucDifference gain = auc_contrast(joint, 0, k);
      row.auc_gain.closed_form = gain.interval;
      row.auc_gain.std_error = root(gain.variance);
      row.auc_p = gain.p_value;
    }
  }
  if (!data.censored) {
    return;
  }
  const ConcordanceResult result = concordances(data, options, true);
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    H1Row& row = panel.rows[k];
    row.c.closed_form = result.estimates[k].interval;
    row.c.std_error = result.estimates[k].std_error;
    if (k > 0) {
      row.c_gain.closed_form = gain_of(result, k).interval;
      row.c_gain.std_error = gain_of(result, k).std_error;
      row.c_p = gain_of(result, k).p_value;
    }
  }
}

void add_case_level(const H1Data& data, const H1Options& options, H1Panel& panel) {
  const JointAuc joint = aucs(data, options, false);
  std::optional<ConcordanceResult> result;
  if (data.censored) {
    result = concordances(data, options, false);
  }
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    H1CaseRow row;
    row.name = data.names[k];
    row.auc = {
        joint.markers[k].auc, {}, joint.markers[k].interval, root(joint.markers[k].variance)};
    if (k > 0) {
      row.auc_gain_p = auc_contrast(joint, 0, k).p_value;
    }
    if (result) {
      const ConcordanceEstimate& c = result->estimates[k];
      row.c = {c.c, {}, c.interval, c.std_error};
      if (k > 0) {
        row.c_gain_p = gain_of(*result, k).p_value;
      }
    }
    panel.case_level.push_back(std::move(row));
  }
}

/// One column a standard deviation wide, rising towards the better side; a constant one as it is.
Eigen::VectorXd per_sd(const H1Data& data, std::size_t k) {
  const std::vector<double>& values = data.predictors[k];
  const double sign = data.higher[k] == HigherMeans::success ? 1.0 : -1.0;
  const Eigen::Map<const Eigen::VectorXd> x(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  const double sd = standard_deviation(values);
  return x * (sd > 0.0 ? sign / sd : sign);
}

/// The rows whose stratum is known, with their strata.
CoxData in_strata(const CoxData& cox, const H1Data& data, const H1Options& options, H1Row& row) {
  std::vector<std::size_t> rows;
  std::vector<Eigen::Index> indices;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    if (data.strata->codes[i] != Factor::kMissing) {
      rows.push_back(i);
      indices.push_back(static_cast<Eigen::Index>(i));
    }
  }
  CoxData kept = cox;
  kept.strata = data.strata;
  if (rows.size() == data.rows()) {
    return kept;
  }
  row.conditions.push_back(
      {ConditionKind::missing_rows,
       ConditionSeverity::note,
       options.strata,
       std::to_string(data.rows() - rows.size()) + " of the stratified hazard ratio"});
  kept.outcome = {};
  for (const std::size_t i : rows) {
    kept.outcome.stop.push_back(cox.outcome.stop[i]);
    kept.outcome.event.push_back(cox.outcome.event[i]);
    if (cox.outcome.left_truncated()) {
      kept.outcome.start.push_back(cox.outcome.start[i]);
    }
  }
  kept.design = cox.design(indices, Eigen::all);
  kept.strata = on_rows(*data.strata, rows);
  kept.cluster = on_rows(*cox.cluster, rows);
  return kept;
}

H1HazardRatio hazard_ratio(
    CoxData cox, const H1Data& data, const H1Options& options, bool stratified, H1Row& row) {
  cox.cluster = data.cluster;
  if (stratified) {
    cox = in_strata(cox, data, options, row);
  }
  CoxOptions cox_options;
  cox_options.level = options.level;
  const CoxFit fit = fit_cox(cox, cox_options);
  H1HazardRatio result;
  const CoxCoefficient& coefficient = fit.coefficients.front();
  result.ratio = coefficient.hazard_ratio;
  result.p_value = coefficient.p_value;
  if (coefficient.interval) {
    result.interval = Interval{
        std::exp(coefficient.interval->low), std::exp(coefficient.interval->high), options.level};
  }
  for (const Condition& condition : fit.conditions) {
    const bool known =
        std::find(row.conditions.begin(), row.conditions.end(), condition) != row.conditions.end();
    if (condition.kind != ConditionKind::few_clusters && !known) {
      row.conditions.push_back(condition);
    }
  }
  return result;
}

/// `others` are predictors that the model holds besides `k`, which comes first.
CoxData cox_of(const SurvivalOutcome& outcome,
               const H1Data& data,
               std::size_t k,
               const std::vector<std::size_t>& others) {
  CoxData cox;
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
    const CoxData censored = cox_of(*data.censored, data, k, others);
    row.sd = standard_deviation(data.predictors[k]);
    row.censored = hazard_ratio(censored, data, options, false, row);
    row.at_limit = hazard_ratio(cox_of(*data.at_limit, data, k, others), data, options, false, row);
    if (data.strata) {
      row.stratified = hazard_ratio(censored, data, options, true, row);
    }
  }
}

std::optional<double> likelihood_ratio_p(double smaller, double larger, std::size_t df) {
  return df == 0 ? std::nullopt
                 : std::optional(chi_square_test(2.0 * (larger - smaller), df).p_value);
}

void add_likelihood_ratios(const H1Data& data, const H1Models& models, H1Panel& panel) {
  if (models.models.empty()) {
    return;
  }
  H1Row& added = panel.rows.back();
  const LogisticFit small = fit_logistic(models.models[0].logistic());
  const LogisticFit large = fit_logistic(models.models[1].logistic());
  if (small.log_likelihood && large.log_likelihood) {
    added.auc_p =
        likelihood_ratio_p(*small.log_likelihood, *large.log_likelihood, large.rank - small.rank);
  }
  for (const Condition& condition : large.conditions) {
    added.conditions.push_back(condition);
  }
  if (data.censored) {
    const CoxFit cox_small = fit_cox(models.models[0].cox());
    const CoxFit cox_large = fit_cox(models.models[1].cox());
    if (cox_small.loglik && cox_large.loglik) {
      added.c_p =
          likelihood_ratio_p(*cox_small.loglik, *cox_large.loglik, cox_large.df - cox_small.df);
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
  add_hazard_ratios(data, options, panel);
  add_likelihood_ratios(data, models, panel);
}

}  // namespace tcert
