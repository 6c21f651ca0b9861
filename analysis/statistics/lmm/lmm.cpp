#include <statistics/lmm/lmm.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <statistics/basics/chi_square.hpp>
#include <statistics/glmm/glmm_parts.hpp>
#include <statistics/lmm/lmm_maximum.hpp>
#include <statistics/lmm/lmm_spread.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

/// The rows made ready, and the least squares fit of the fixed part, which is taken off y.
struct LmmProblem {
  OrthonormalBasis space;
  Eigen::VectorXd root_weights;  ///< Empty: 1 each.
  Eigen::VectorXd plain;         ///< Along the basis.
  Eigen::VectorXd left;          ///< What it leaves of y.
  std::vector<TermRows> terms;

  [[nodiscard]] LmmLikelihood likelihood(bool restricted) const {
    return {space.basis, left, terms, root_weights, restricted};
  }
};

void check(const LmmInput& input, const LmmOptions& options) {
  const Eigen::Index rows = input.design.rows();
  bool fits = input.y.size() == rows &&
              input.design.cols() == static_cast<Eigen::Index>(input.columns.size()) &&
              (input.weights.size() == 0 || input.weights.size() == rows) &&
              (input.offset.size() == 0 || input.offset.size() == rows);
  for (const RandomEffects& random : input.random) {
    fits = fits && random.design.rows() == rows && !random.columns.empty() &&
           random.levels.rows() == static_cast<std::size_t>(rows);
  }
  if (!fits) {
    throw std::invalid_argument("linear mixed model: lengths differ");
  }
  if (!(options.level > 0.0 && options.level < 1.0)) {
    throw std::invalid_argument("linear mixed model: level must be in (0, 1)");
  }
}

void add_dropped_conditions(const LmmInput& input, const LmmProblem& problem, LmmFit& fit) {
  for (const std::size_t j : problem.space.dropped) {
    const auto column = input.design.col(static_cast<Eigen::Index>(j));
    const bool constant = (column.array() == column[0]).all();
    fit.coefficients[j].kind = CoefficientKind::not_estimable;
    fit.conditions.push_back(
        {constant ? ConditionKind::constant_column : ConditionKind::collinear_column,
         ConditionSeverity::warning,
         input.columns[j],
         constant ? fmt::format("it is {} in every row", column[0]) : ""});
  }
}

/// An error among the conditions leaves none.
std::optional<LmmProblem> problem_of(const LmmInput& input, LmmFit& fit) {
  if (input.random.empty()) {
    fit.conditions.push_back(
        error_of(ConditionKind::no_random_effects, "", "", "write + (1 | group)"));
  }
  add_duplicate_conditions(input.random, fit.conditions);
  if (has_error(fit.conditions)) {
    return std::nullopt;
  }
  LmmProblem problem;
  Eigen::MatrixXd design = input.design;
  problem.left = input.offset.size() > 0 ? Eigen::VectorXd(input.y - input.offset) : input.y;
  if (input.weights.size() > 0) {
    problem.root_weights = input.weights.cwiseSqrt();
    design.array().colwise() *= problem.root_weights.array();
    problem.left.array() *= problem.root_weights.array();
  }
  problem.space = orthonormal_basis(design);
  const double size = problem.left.norm();
  problem.plain = problem.space.basis.transpose() * problem.left;
  problem.left -= problem.space.basis * problem.plain;
  add_dropped_conditions(input, problem, fit);
  fit.rank = static_cast<std::size_t>(problem.space.rank());
  if (fit.rows <= fit.rank + 1) {
    fit.conditions.push_back(error_of(ConditionKind::too_few_rows,
                                      "",
                                      fmt::format("{} rows, {} coefficients", fit.rows, fit.rank)));
  } else if (problem.left.norm() <= 1e-12 * size) {
    fit.conditions.push_back(error_of(
        ConditionKind::constant_column, input.response, "the fixed part leaves nothing of it"));
  }
  std::vector<Eigen::Index> rows(fit.rows);
  std::iota(rows.begin(), rows.end(), 0);
  for (const RandomEffects& random : input.random) {
    problem.terms.push_back(term_rows(random, rows, true));
    add_term_conditions(random, problem.terms.back(), true, fit.conditions);
  }
  for (Condition& condition : fit.conditions) {
    if (condition.kind == ConditionKind::singleton_groups) {
      condition.severity = ConditionSeverity::error;  // It is the residual once more.
    }
  }
  return has_error(fit.conditions) ? std::nullopt : std::optional(std::move(problem));
}

/// Of the criterion at its maximum: with what the weights and, if restricted, the basis add.
double log_likelihood_of(const LmmProblem& problem, double value, bool restricted) {
  const double of_weights = problem.root_weights.array().log().sum();
  const double of_basis = restricted ? problem.space.triangle.diagonal().array().log().sum() : 0.0;
  return value + of_weights - of_basis;
}

void add_random(const LmmProblem& problem,
                LmmLikelihood& likelihood,
                const GlmmMaximum& maximum,
                LmmFit& fit) {
  std::vector<TermModes> modes = likelihood.modes(maximum.parameters);
  Eigen::Index at = 0;
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    const TermRows& rows = problem.terms[t];
    GlmmRandomTerm term = random_term(rows, maximum.parameters.segment(at, rows.thetas()));
    term.factor *= fit.residual_sd;
    term.covariance *= fit.residual_sd * fit.residual_sd;
    for (double& sd : term.sd) {
      sd *= fit.residual_sd;
    }
    term.modes = std::move(modes[t].modes);
    term.mode_sds = std::move(modes[t].sds);
    fit.singular = fit.singular || term.singular;
    fit.random.push_back(std::move(term));
    at += rows.thetas();
  }
}

void add_coefficients(const LmmProblem& problem,
                      const Eigen::VectorXd& along,
                      const Eigen::MatrixXd& back,
                      LmmFit& fit) {
  const Eigen::VectorXd estimates = back * along;
  for (std::size_t k = 0; k < problem.space.kept.size(); ++k) {
    LmmCoefficient& one = fit.coefficients[problem.space.kept[k]];
    one.kind = CoefficientKind::finite;
    one.estimate = estimates[static_cast<Eigen::Index>(k)];
  }
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    LmmCoefficient& one = fit.coefficients[k];
    const ClusterT by_t = lmm_contrast(
        fit, Eigen::VectorXd::Unit(fit.covariance.cols(), static_cast<Eigen::Index>(k)));
    one.standard_error = by_t.standard_error;
    one.df = by_t.df;
    one.p_value = by_t.p_value;
    one.interval = by_t.interval;
    if (one.estimate && one.standard_error) {
      one.t = *one.estimate / *one.standard_error;
    }
  }
}

void add_shares(const LmmInput& input, const LmmProblem& problem, LmmFit& fit) {
  Eigen::VectorXd fixed = Eigen::VectorXd::Zero(input.design.rows());
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
    fixed +=
        fit.coefficients[k].estimate.value_or(0.0) * input.design.col(static_cast<Eigen::Index>(k));
  }
  const double of_fixed =
      (fixed.array() - fixed.mean()).square().sum() / (static_cast<double>(fixed.size()) - 1.0);
  double of_random = 0.0;
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    of_random += mean_variance(problem.terms[t], fit.random[t]);
  }
  const double residual = fit.residual_sd * fit.residual_sd;
  fit.icc = of_random / (of_random + residual);
  fit.r2_marginal = of_fixed / (of_fixed + of_random + residual);
  fit.r2_conditional = (of_fixed + of_random) / (of_fixed + of_random + residual);
}

void add_boundary(const LmmProblem& problem,
                  LmmLikelihood& likelihood,
                  const GlmmMaximum& maximum,
                  LmmFit& fit) {
  for (std::size_t t = 0; t < fit.random.size(); ++t) {
    GlmmRandomTerm& term = fit.random[t];
    if (term.columns.size() > 1 && term.columns.front() != "(Intercept)") {
      continue;
    }
    const GlmmMaximum without =
        lmm_maximum_without(likelihood, problem.terms, t, maximum.parameters);
    if (without.converged()) {
      term.test =
          boundary_test(term, 2.0 * (maximum.at.value - without.at.value), maximum.at.value);
    }
  }
}

}  // namespace

LmmFit fit_lmm(const LmmInput& input, const LmmOptions& options) {
  check(input, options);
  LmmFit fit;
  fit.options = options;
  fit.conditions = input.conditions;
  fit.rows = static_cast<std::size_t>(input.design.rows());
  for (const std::string& column : input.columns) {
    fit.coefficients.emplace_back();
    fit.coefficients.back().column = column;
  }
  fit.covariance.setConstant(input.design.cols(), input.design.cols(), table::kNaN);
  if (has_error(fit.conditions)) {
    return fit;
  }
  const std::optional<LmmProblem> problem = problem_of(input, fit);
  if (!problem) {
    return fit;
  }
  LmmLikelihood likelihood = problem->likelihood(options.restricted);
  const GlmmMaximum maximum = lmm_maximum(likelihood, problem->terms);
  fit.parameters = fit.rank + static_cast<std::size_t>(likelihood.thetas()) + 1;
  fit.termination = maximum.termination;
  fit.iterations = maximum.iterations;
  fit.evaluations = maximum.evaluations;
  fit.last_step = maximum.last_step;
  LmmPoint at;
  if (!maximum.converged() || !likelihood.parts_at(maximum.parameters, false, at)) {
    fit.conditions.push_back(error_of(
        ConditionKind::not_converged,
        "",
        fmt::format("{} after {} iterations", to_string(fit.termination), fit.iterations)));
    return fit;
  }
  fit.gradient_norm = maximum.at.gradient.cwiseAbs().maxCoeff();
  fit.residual_sd = std::sqrt(at.residual / likelihood.df());
  const Eigen::MatrixXd back = inverse_triangle(problem->space);
  add_spread(likelihood, maximum.parameters, back, problem->space.kept, fit);
  add_random(*problem, likelihood, maximum, fit);
  add_coefficients(*problem, problem->plain + at.fixed, back, fit);
  add_shares(input, *problem, fit);
  fit.log_likelihood = log_likelihood_of(*problem, maximum.at.value, options.restricted);
  const auto parameters = static_cast<double>(fit.parameters);
  fit.aic = 2.0 * parameters - 2.0 * *fit.log_likelihood;
  fit.bic = std::log(static_cast<double>(fit.rows)) * parameters - 2.0 * *fit.log_likelihood;
  if (options.test_terms) {
    add_boundary(*problem, likelihood, maximum, fit);
  }
  add_singular_conditions(fit.random, fit.conditions);
  return fit;
}

}  // namespace tcert::statistics
