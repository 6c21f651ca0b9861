#include "analysis/study/h2/group_models.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/wald_chi_squared.hpp>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/equivalence/scores_by_group.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_sandwich.hpp>
#include <statistics/model/factor_levels.hpp>
#include <utility>

#include "analysis/study/h1/hazard_ratio.hpp"
#include "analysis/study/h1/mixed_effects.hpp"

namespace tcert::study {
namespace {

std::vector<Eigen::Index> indices(const std::vector<std::size_t>& rows) {
  return {rows.begin(), rows.end()};
}

Eigen::VectorXd outcome_of(const H1Data& data) {
  Eigen::VectorXd outcome(static_cast<Eigen::Index>(data.rows()));
  for (std::size_t row = 0; row < data.rows(); ++row) {
    outcome[static_cast<Eigen::Index>(row)] = data.success[row];
  }
  return outcome;
}

void add_conditions(const statistics::Conditions& more, statistics::Conditions& conditions) {
  for (const statistics::Condition& condition : more) {
    if (condition.kind != statistics::ConditionKind::few_clusters) {
      conditions.push_back(condition);
    }
  }
}

/// The groups' part of the panel, for what fits it by itself.
H1Data part_of(const H1Data& data, const std::vector<std::size_t>& rows) {
  H1Data part;
  for (const std::size_t row : rows) {
    part.success.push_back(data.success[row]);
  }
  part.cluster = statistics::on_rows(data.cluster, rows);
  if (data.strata) {
    part.strata = statistics::on_rows(*data.strata, rows);
  }
  if (data.censored) {
    part.censored = statistics::on_rows(*data.censored, rows);
    part.at_limit = statistics::on_rows(*data.at_limit, rows);
  }
  return part;
}

/// `own_units` is the predictor as it was, `x` in standard deviations.
H1HazardRatio odds_ratio(const H1Data& part,
                         const std::string& name,
                         const Eigen::VectorXd& x,
                         const std::vector<double>& own_units,
                         double level,
                         statistics::Conditions& conditions) {
  statistics::LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(x.size(), 2);
  input.design.col(1) = x;
  input.columns = {"(Intercept)", name};
  input.terms = {name};
  input.term_of = {0, 1};
  input.own_units = {{}, own_units};
  input.response = "success";
  input.successes = outcome_of(part);
  input.cluster = part.cluster;
  statistics::LogisticOptions options;
  options.level = level;
  options.variance = statistics::CoefficientVariance::robust;
  const statistics::LogisticFit fit = statistics::fit_logistic(input, options);
  add_conditions(fit.conditions, conditions);
  const statistics::LogisticCoefficient& one = fit.coefficients[1];
  H1HazardRatio result;
  statistics::WildOptions wild;
  wild.level = level;
  take_ratio(one.estimate ? std::optional(std::exp(*one.estimate)) : std::nullopt,
             statistics::cluster_inferences(input, fit, {}, wild).of[1],
             result);
  return result;
}

statistics::CoxData cox_of(const statistics::SurvivalOutcome& outcome,
                           Eigen::MatrixXd design,
                           const std::string& name) {
  statistics::CoxData cox;
  cox.outcome = outcome;
  cox.design = std::move(design);
  for (Eigen::Index column = 0; column < cox.design.cols(); ++column) {
    cox.columns.push_back(column == 0 ? name : name + " " + std::to_string(column));
    cox.term_of.push_back(cox.terms.size());
    cox.terms.push_back(cox.columns.back());
  }
  return cox;
}

/// Predictor, dummies of all groups but the first, and their products.
struct Interaction {
  Eigen::MatrixXd design;
  std::vector<std::string> columns;
  Eigen::Index products = 0;             ///< The last so many columns.
  std::vector<std::vector<double>> raw;  ///< The columns with the predictor in its own units.

  [[nodiscard]] std::vector<std::span<const double>> own_units(std::size_t count) const {
    return {raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(count)};
  }
};

Interaction interaction_of(const H1Data& data) {
  const table::Factor& group = *data.group;
  const Eigen::VectorXd x = per_sd(data, 0);
  const auto others = static_cast<Eigen::Index>(group.levels.size()) - 1;
  Interaction result;
  result.products = others;
  result.design = Eigen::MatrixXd::Zero(x.size(), 1 + 2 * others);
  result.design.col(0) = x;
  for (Eigen::Index row = 0; row < x.size(); ++row) {
    const auto code = static_cast<Eigen::Index>(group.codes[static_cast<std::size_t>(row)]);
    if (code > 0) {
      result.design(row, code) = 1.0;
      result.design(row, others + code) = x[row];
    }
  }
  const std::vector<double>& own = data.predictors[0];
  for (Eigen::Index column = 0; column < result.design.cols(); ++column) {
    result.raw.emplace_back(own.size());
    for (std::size_t row = 0; row < own.size(); ++row) {
      const double cell = result.design(static_cast<Eigen::Index>(row), column);
      const bool of_predictor = column == 0 || column > others;
      result.raw.back()[row] = of_predictor && cell != 0.0 ? own[row] : cell;
    }
  }
  result.columns = {data.names[0]};
  for (const char* const prefix : {"", ":"}) {
    for (std::size_t g = 1; g < group.levels.size(); ++g) {
      result.columns.push_back((*prefix == ':' ? data.names[0] + ":" : "") + group.levels[g]);
    }
  }
  return result;
}

/// Hotelling's test of the last coefficients by the jackknife of whole clusters.
std::optional<statistics::ChiSquareTest> test_of_last(
    const std::optional<statistics::ClusteredFit>& fit, Eigen::Index count) {
  if (!fit) {
    return std::nullopt;
  }
  const Eigen::VectorXd estimates = fit->parts.estimates.tail(count);
  return statistics::hotelling_test(
      estimates,
      statistics::jackknife_covariance(estimates, fit->left_out().values.bottomRows(count)),
      fit->parts.clusters());
}

H2Interaction logistic_interaction(const H1Data& data, const Interaction& terms) {
  statistics::LogisticInput input;
  input.design.resize(terms.design.rows(), terms.design.cols() + 1);
  input.design << Eigen::VectorXd::Ones(terms.design.rows()), terms.design;
  input.columns = {"(Intercept)"};
  input.term_of = {0};
  for (const std::string& column : terms.columns) {
    input.columns.push_back(column);
    input.terms.push_back(column);
    input.term_of.push_back(input.terms.size());
  }
  input.own_units = terms.own_units(terms.raw.size());
  input.own_units.insert(input.own_units.begin(), std::span<const double>{});
  input.response = "success";
  input.successes = outcome_of(data);
  input.cluster = data.cluster;
  statistics::LogisticOptions options;
  options.variance = statistics::CoefficientVariance::robust;
  const statistics::LogisticFit fit = statistics::fit_logistic(input, options);
  H2Interaction result{
      "logistic", test_of_last(statistics::clustered_fit(input, fit), terms.products), {}};
  add_conditions(fit.conditions, result.conditions);
  return result;
}

H2Interaction cox_interaction(const H1Data& data, const Interaction& terms, bool stratified) {
  statistics::CoxData cox = cox_of(*data.censored, terms.design, data.names[0]);
  cox.columns = terms.columns;
  cox.terms = terms.columns;
  cox.cluster = data.cluster;
  if (stratified) {
    cox.strata = data.strata;
  }
  const statistics::CoxFit fit = statistics::fit_cox(cox);
  H2Interaction result{stratified ? "Cox, stratified" : "Cox",
                       test_of_last(statistics::clustered_fit(cox, fit), terms.products),
                       {}};
  add_conditions(fit.conditions, result.conditions);
  return result;
}

/// Likelihood ratio of the products, with a random intercept by cluster.
void add_mixed_interaction(const H1Data& data,
                           const Interaction& terms,
                           const std::string& cluster,
                           H2Panel& panel) {
  if (!panel.trials.has_clusters || panel.trials.clusters == data.rows()) {
    return;
  }
  statistics::GlmmOptions options;
  options.test_terms = false;
  const statistics::GlmmFit with = statistics::fit_glmm(
      mixed_input(
          data, terms.design, terms.columns, terms.own_units(terms.columns.size()), cluster),
      options);
  const Eigen::Index main_columns = terms.design.cols() - terms.products;
  const statistics::GlmmFit without = statistics::fit_glmm(
      mixed_input(data,
                  terms.design.leftCols(main_columns),
                  {terms.columns.begin(), terms.columns.begin() + main_columns},
                  terms.own_units(static_cast<std::size_t>(main_columns)),
                  cluster),
      options);
  H2Interaction result{"logistic, mixed", std::nullopt, {}};
  if (with.log_likelihood && without.log_likelihood && with.rank > without.rank) {
    result.test = statistics::chi_square_test(
        2.0 * (*with.log_likelihood - *without.log_likelihood), with.rank - without.rank);
  }
  add_conditions(with.conditions, result.conditions);
  panel.mixed_interaction = std::move(result);
}

}  // namespace

void add_group_effects(const H1Data& data, double level, H2Panel& panel) {
  const Eigen::VectorXd x = per_sd(data, 0);
  const auto rows_of = statistics::rows_of_levels(*data.group);
  for (std::size_t g = 0; g < rows_of.size(); ++g) {
    H2Level& one = panel.levels[g];
    const H1Data part = part_of(data, rows_of[g]);
    const Eigen::VectorXd own = x(indices(rows_of[g]));
    std::vector<double> own_units;
    for (const std::size_t row : rows_of[g]) {
      own_units.push_back(data.predictors[0][row]);
    }
    one.odds = odds_ratio(part, data.names[0], own, own_units, level, one.conditions);
    if (!part.censored) {
      continue;
    }
    const statistics::CoxData censored = cox_of(*part.censored, own, data.names[0]);
    one.censored = hazard_ratio(censored, part, level, false, one.conditions);
    one.at_limit = hazard_ratio(
        cox_of(*part.at_limit, own, data.names[0]), part, level, false, one.conditions);
    if (part.strata) {
      one.stratified = hazard_ratio(censored, part, level, true, one.conditions);
    }
  }
}

void add_interactions(const H1Data& data, const std::string& cluster, H2Panel& panel) {
  const Interaction terms = interaction_of(data);
  panel.interactions.push_back(logistic_interaction(data, terms));
  if (data.censored) {
    panel.interactions.push_back(cox_interaction(data, terms, false));
    if (data.strata) {
      panel.interactions.push_back(cox_interaction(data, terms, true));
    }
  }
  add_mixed_interaction(data, terms, cluster, panel);
}

}  // namespace tcert::study
