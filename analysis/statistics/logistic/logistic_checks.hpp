#pragma once
/// \file
/// What the logistic fits ask of their input before they start.

#include <optional>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {

/// \throws std::invalid_argument if lengths differ, successes lie outside [0, trials] or `level`
/// outside (0, 1).
void check_lengths(const LogisticInput& input, double level);

/// Values that no arithmetic can use: infinite_value, bad_weight, errors.
void add_value_conditions(const LogisticInput& input, Conditions& conditions);

/// constant_column or collinear_column, warnings, for each column that the basis left out.
void add_rank_conditions(const LogisticInput& input,
                         const LogisticProblem& problem,
                         Conditions& conditions);

[[nodiscard]] bool has_intercept(const LogisticInput& input);

/// What every logistic fit begins with: its coefficients' names, a covariance of NA, the conditions
/// of the input, and the problem, if the data leave one that can be solved. `outcome_conditions` is
/// called with the input, the problem and the fit's conditions. \throws as check_lengths().
template <class Fit, class OutcomeConditions>
[[nodiscard]] std::optional<LogisticProblem> begin_fit(const LogisticInput& input,
                                                       const OutcomeConditions& outcome_conditions,
                                                       Fit& fit) {
  fit.conditions = input.conditions;
  fit.coefficients.resize(input.columns.size());
  for (std::size_t j = 0; j < input.columns.size(); ++j) {
    fit.coefficients[j].column = input.columns[j];
  }
  const Eigen::Index columns = input.design.cols();
  fit.covariance = Eigen::MatrixXd::Constant(columns, columns, table::kNaN);
  if (has_error(fit.conditions)) {
    return std::nullopt;
  }
  check_lengths(input, fit.options.level);
  add_value_conditions(input, fit.conditions);
  if (has_error(fit.conditions)) {
    return std::nullopt;
  }
  LogisticProblem problem = logistic_problem(input);
  fit.rows = static_cast<std::size_t>(problem.size());
  fit.rank = static_cast<std::size_t>(problem.space.rank());
  fit.df_residual = fit.rows - fit.rank;
  outcome_conditions(input, problem, fit.conditions);
  if (problem.size() > 0) {
    add_rank_conditions(input, problem, fit.conditions);
    for (const std::size_t j : problem.space.dropped) {
      fit.coefficients[j].kind = CoefficientKind::not_estimable;
    }
  }
  return has_error(fit.conditions) ? std::nullopt : std::optional(std::move(problem));
}

}  // namespace tcert::statistics
