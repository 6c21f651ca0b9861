#include "analysis/study/h1/mixed_effects.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/chi_square.hpp>

#include "analysis/study/h1/hazard_ratio.hpp"
#include "analysis/study/trials/feature_table.hpp"

namespace tcert::study {
namespace {

constexpr double kCentimetre = 0.01;

bool is_in_metres(const std::string& column) {
  const auto columns = feature_columns();
  return std::any_of(columns.begin(), columns.end(), [&](const FeatureColumn& one) {
    return one.name == column && one.unit == "m";
  });
}

/// exp(scale * x), whose ends swap if the scale is negative.
H1OddsRatio odds_ratio(const statistics::LogisticCoefficient& one, double scale, double level) {
  H1OddsRatio result;
  if (one.estimate) {
    result.ratio = std::exp(scale * *one.estimate);
  }
  if (one.interval) {
    const double a = std::exp(scale * one.interval->low);
    const double b = std::exp(scale * one.interval->high);
    result.interval = statistics::Interval{std::min(a, b), std::max(a, b), level};
  }
  return result;
}

statistics::GlmmFit fit_of(const H1Data& data,
                           const H1Options& options,
                           const std::vector<std::size_t>& predictors) {
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(data.rows()),
                          static_cast<Eigen::Index>(predictors.size()));
  std::vector<std::string> names;
  std::vector<std::span<const double>> own_units;
  for (const std::size_t k : predictors) {
    columns.col(static_cast<Eigen::Index>(names.size())) = per_sd(data, k);
    names.push_back(data.names[k]);
    own_units.emplace_back(data.predictors[k]);
  }
  statistics::GlmmOptions glmm;
  glmm.level = options.level;
  glmm.test_terms = false;
  return statistics::fit_glmm(mixed_input(data, columns, names, own_units, options.cluster), glmm);
}

void take(const statistics::GlmmFit& fit, H1Row& row) {
  row.mixed.log_likelihood = fit.log_likelihood;
  row.mixed.icc = fit.icc;
  row.mixed.r2_marginal = fit.r2_marginal;
  row.mixed.r2_conditional = fit.r2_conditional;
  if (!fit.random.empty() && !fit.random.front().sd.empty()) {
    row.mixed.sd_cluster = fit.random.front().sd.front();
  }
  for (statistics::Condition condition : fit.conditions) {
    if (condition.kind == statistics::ConditionKind::few_clusters) {
      continue;
    }
    // One model of many: its error costs its own row.
    condition.severity = std::min(condition.severity, statistics::ConditionSeverity::warning);
    condition.detail = "mixed model" + (condition.detail.empty() ? "" : ": " + condition.detail);
    row.conditions.push_back(std::move(condition));
  }
}

/// The odds ratio of the first column, predictor `k`.
void take_ratio(
    const statistics::GlmmFit& fit, const H1Data& data, std::size_t k, double level, H1Row& row) {
  if (fit.coefficients.size() < 2) {
    return;
  }
  const statistics::LogisticCoefficient& one = fit.coefficients[1];
  row.mixed.p_value = one.p_value;
  row.mixed.per_sd = odds_ratio(one, 1.0, level);
  const double sd = row.sd.value_or(0.0);
  if (is_in_metres(data.names[k]) && sd > 0.0) {
    row.mixed.per_cm = odds_ratio(one, kCentimetre / sd, level);
  }
}

}  // namespace

statistics::GlmmInput mixed_input(const H1Data& data,
                                  const Eigen::MatrixXd& columns,
                                  const std::vector<std::string>& names,
                                  const std::vector<std::span<const double>>& own_units,
                                  const std::string& cluster) {
  const Eigen::Index rows = columns.rows();
  statistics::GlmmInput input;
  statistics::LogisticInput& fixed = input.fixed;
  fixed.design.resize(rows, columns.cols() + 1);
  fixed.design << Eigen::VectorXd::Ones(rows), columns;
  fixed.columns = {"(Intercept)"};
  fixed.term_of = {0};
  for (const std::string& name : names) {
    fixed.columns.push_back(name);
    fixed.terms.push_back(name);
    fixed.term_of.push_back(fixed.terms.size());
  }
  fixed.own_units = {{}};
  fixed.own_units.insert(fixed.own_units.end(), own_units.begin(), own_units.end());
  fixed.response = "success";
  fixed.successes.resize(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    fixed.successes[row] = data.success[static_cast<std::size_t>(row)];
  }
  input.random = {{cluster, data.cluster, Eigen::MatrixXd::Ones(rows, 1), {"(Intercept)"}}};
  return input;
}

void add_mixed_effects(const H1Data& data, const H1Options& options, H1Panel& panel) {
  if (!panel.has_clusters || panel.clusters == data.rows()) {
    return;
  }
  std::vector<std::size_t> rivals;
  for (std::size_t k = 1; k < data.predictors.size(); ++k) {
    rivals.push_back(k);
  }
  std::optional<statistics::GlmmFit> smaller;
  for (std::size_t r = 0; r < panel.rows.size(); ++r) {
    H1Row& row = panel.rows[r];
    std::vector<std::size_t> predictors{r};
    if (row.kind == H1RowKind::together || row.kind == H1RowKind::added) {
      predictors = rivals;
      if (row.kind == H1RowKind::added) {
        predictors.insert(predictors.begin(), 0);
      }
    }
    const statistics::GlmmFit fit = fit_of(data, options, predictors);
    take(fit, row);
    if (row.kind == H1RowKind::together) {
      smaller = fit;
      continue;  // No single ratio.
    }
    const bool added = row.kind == H1RowKind::added;
    take_ratio(fit, data, added ? 0 : r, options.level, row);
    if (added && smaller && smaller->log_likelihood && fit.log_likelihood &&
        fit.rank > smaller->rank) {
      row.mixed.lr_p_value =
          statistics::chi_square_test(2.0 * (*fit.log_likelihood - *smaller->log_likelihood),
                                      fit.rank - smaller->rank)
              .p_value;
    }
  }
}

}  // namespace tcert::study
