#include <statistics/logistic/logistic.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <statistics/basics/few_clusters.hpp>
#include <statistics/logistic/logistic_checks.hpp>
#include <statistics/logistic/logistic_estimates.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <statistics/logistic/separation_words.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

void add_outcome_errors(const LogisticInput& input,
                        const LogisticProblem& problem,
                        Conditions& conditions) {
  const double successes = problem.rows.successes.sum();
  const bool none = (problem.rows.successes.array() == 0.0).all();
  const bool all = (problem.rows.successes.array() == problem.rows.trials.array()).all();
  if (problem.size() == 0) {
    conditions.push_back(error_of(ConditionKind::no_rows, "", ""));
  } else if (none || all) {
    conditions.push_back(
        error_of(ConditionKind::one_class,
                 input.response,
                 fmt::format("{} of {} are successes", successes, problem.rows.trials.sum())));
  } else if (problem.space.rank() == problem.size() && !problem.space.dropped.empty()) {
    conditions.push_back(
        error_of(ConditionKind::too_few_rows,
                 "",
                 fmt::format("{} for {} coefficients", problem.size(), input.columns.size())));
  }
}

/// Of the model of the intercept and the offset alone; empty if that does not converge.
std::optional<double> null_log_likelihood(const LogisticInput& input,
                                          const LogisticProblem& problem,
                                          const NewtonOptions& options) {
  const Eigen::Index columns = has_intercept(input) ? 1 : 0;
  const double height = 1.0 / std::sqrt(static_cast<double>(problem.size()));
  const Eigen::MatrixXd design = Eigen::MatrixXd::Constant(problem.size(), columns, height);
  Eigen::VectorXd start = Eigen::VectorXd::Zero(columns);
  if (columns > 0 && problem.rows.offset.size() == 0) {
    const double successes = problem.rows.successes.sum();
    start[0] = std::log(successes / (problem.rows.trials.sum() - successes)) / height;
  }
  const NewtonResult result = maximise_binomial(design, problem.rows, start, std::nullopt, options);
  return result.converged() ? std::optional(result.at.log_likelihood) : std::nullopt;
}

void add_separation(const LogisticInput& input, const LogisticProblem& problem, LogisticFit& fit) {
  const Eigen::MatrixXd back = inverse_triangle(problem.space);
  const std::vector<Signs> signs = recession_signs(
      problem.space.basis, problem.rows.successes, problem.rows.trials, back.transpose());
  const bool complete = fit.separation == Separation::complete;
  for (std::size_t k = 0; k < problem.space.kept.size(); ++k) {
    LogisticCoefficient& coefficient = fit.coefficients[problem.space.kept[k]];
    if (coefficient.kind == CoefficientKind::finite ||
        coefficient.kind == CoefficientKind::ran_away) {
      continue;
    }
    const bool both = signs[k].positive == signs[k].negative;
    coefficient.kind = both                ? CoefficientKind::diverging
                       : signs[k].positive ? CoefficientKind::plus_infinity
                                           : CoefficientKind::minus_infinity;
    fit.conditions.push_back(
        {complete ? ConditionKind::complete_separation : ConditionKind::quasi_separation,
         complete ? ConditionSeverity::error : ConditionSeverity::warning,
         coefficient.column,
         fmt::format("the estimate {}, {}",
                     both                ? "is not finite"
                     : signs[k].positive ? "is +infinity"
                                         : "is -infinity",
                     separation_words(input, problem.used, problem.space.kept[k]))});
  }
}

/// Fitted probabilities of every input row from coefficients that determine all of them.
Eigen::VectorXd fitted_of(const LogisticInput& input,
                          const LogisticProblem& problem,
                          const NewtonResult& newton,
                          const std::vector<std::size_t>& names) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(input.design.cols());
  const Eigen::VectorXd estimates = inverse_triangle(problem.space) * newton.coefficients;
  for (std::size_t k = 0; k < problem.space.kept.size(); ++k) {
    all[static_cast<Eigen::Index>(names[problem.space.kept[k]])] =
        estimates[static_cast<Eigen::Index>(k)];
  }
  Eigen::VectorXd eta = input.design * all;
  if (input.offset.size() > 0) {
    eta += input.offset;
  }
  return eta.unaryExpr([](double value) { return inverse_logit(value); });
}

/// The limits of the rows that are told apart; rows outside the problem are not determined.
void set_limits(const LogisticProblem& problem,
                const std::vector<bool>& overlaps,
                Eigen::VectorXd& fitted) {
  const Eigen::VectorXd finite = fitted;
  fitted.setConstant(table::kNaN);
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const Eigen::Index row = problem.used[i];
    const bool success = problem.rows.successes[static_cast<Eigen::Index>(i)] > 0.0;
    fitted[row] = overlaps[i] ? finite[row] : (success ? 1.0 : 0.0);
  }
}

void add_likelihoods(const LogisticInput& input,
                     const LogisticProblem& problem,
                     double log_likelihood,
                     LogisticFit& fit) {
  fit.log_likelihood = log_likelihood + problem.log_coefficients;
  fit.deviance = 2.0 * (problem.saturated - log_likelihood);
  if (const auto null = null_log_likelihood(input, problem, fit.options.newton)) {
    fit.null_deviance = 2.0 * (problem.saturated - *null);
  }
  if (fit.separation == Separation::none) {
    const auto parameters = static_cast<double>(fit.rank);
    fit.aic = -2.0 * *fit.log_likelihood + 2.0 * parameters;
    fit.bic = -2.0 * *fit.log_likelihood + std::log(static_cast<double>(fit.rows)) * parameters;
  }
}

void add_solution(const LogisticInput& input, const LogisticProblem& problem, LogisticFit& fit) {
  const LogisticMaximum maximum = maximum_of(input, problem, fit.options.newton);
  const NewtonResult& newton = maximum.newton;
  const LogisticProblem& solved = maximum.solved(problem);
  fit.separation = maximum.separation.kind;
  fit.termination = newton.termination;
  fit.iterations = newton.iterations;
  fit.last_step = newton.last_step;
  fit.gradient_norm = newton.at.gradient.norm();
  if (!newton.converged()) {
    fit.conditions.push_back(error_of(ConditionKind::not_converged,
                                      "",
                                      fmt::format("{} after {} iterations, gradient {:.2g}",
                                                  to_string(newton.termination),
                                                  newton.iterations,
                                                  fit.gradient_norm)));
    return;
  }
  const bool separated = fit.separation != Separation::none;
  std::vector<std::size_t> names = problem.space.kept;
  if (!separated) {
    names.resize(input.columns.size());
    std::iota(names.begin(), names.end(), 0U);
  }
  add_estimates(input, solved, newton, names, fit);
  add_likelihoods(input, problem, newton.at.log_likelihood, fit);
  fit.fitted = fitted_of(input, solved, newton, names);
  if (separated) {
    set_limits(problem, maximum.separation.overlaps, fit.fitted);
    add_separation(input, problem, fit);
  }
  if (fit.clustered) {
    add_cluster_conditions(
        fit.clusters, "no robust variance", fit.conditions, fit.rank, "", kTooFewClusters);
  }
}

}  // namespace

LogisticFit fit_logistic(const LogisticInput& input, const LogisticOptions& options) {
  LogisticFit fit;
  fit.options = options;
  fit.variance = options.variance;
  fit.clustered = input.cluster && options.variance == CoefficientVariance::robust;
  fit.rows = static_cast<std::size_t>(input.design.rows());
  if (const auto problem = begin_fit(input, add_outcome_errors, fit)) {
    add_solution(input, *problem, fit);
  }
  return fit;
}

}  // namespace tcert::statistics
