#include <statistics/glmm/glmm.hpp>

#include <fmt/format.h>

#include <cmath>
#include <statistics/glmm/glmm_parts.hpp>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/glmm_solve.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

void add_likelihoods(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit) {
  const double constant = problem.fixed.log_coefficients;
  fit.log_likelihood = maximum.at.value + constant;
  fit.fixed_log_likelihood = problem.plain.at.log_likelihood + constant;
  fit.laplace_log_likelihood = fit.log_likelihood;
  if (fit.quadrature > 1) {
    LikelihoodPoint point;
    const bool possible =
        problem.likelihood(1)->evaluate(maximum.parameters, Derivatives::none, point);
    fit.laplace_log_likelihood = possible ? std::optional(point.value + constant) : std::nullopt;
  }
  const auto parameters = static_cast<double>(fit.parameters);
  fit.aic = 2.0 * parameters - 2.0 * *fit.log_likelihood;
  fit.bic = std::log(static_cast<double>(fit.rows)) * parameters - 2.0 * *fit.log_likelihood;
}

/// The term with the largest standard deviation.
const TermRows& widest_term(const GlmmProblem& problem, const Eigen::VectorXd& parameters) {
  const TermRows* widest = &problem.terms.front();
  double largest = 0.0;
  Eigen::Index at = 0;
  for (const TermRows& term : problem.terms) {
    const double size = parameters.segment(at, term.thetas()).cwiseAbs().maxCoeff();
    if (size > largest) {
      largest = size;
      widest = &term;
    }
    at += term.thetas();
  }
  return *widest;
}

void add_no_convergence(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit) {
  constexpr double kDiverged = 25.0;
  const double largest = maximum.parameters.head(problem.thetas()).cwiseAbs().maxCoeff();
  if (largest > kDiverged) {
    fit.termination = GlmmTermination::diverging;
    fit.conditions.push_back({ConditionKind::infinite_variance,
                              ConditionSeverity::error,
                              widest_term(problem, maximum.parameters).group,
                              fmt::format("the standard deviation had passed {:.3g} after {} "
                                          "iterations",
                                          largest,
                                          fit.iterations)});
    return;
  }
  fit.conditions.push_back({ConditionKind::not_converged,
                            ConditionSeverity::error,
                            "",
                            fmt::format("{} after {} iterations, largest gradient {:.2g}, last "
                                        "step {:.2g} standard errors",
                                        to_string(fit.termination),
                                        fit.iterations,
                                        fit.gradient_norm,
                                        fit.last_step)});
}

GlmmFit empty_fit(const GlmmInput& input, const GlmmOptions& options) {
  GlmmFit fit;
  fit.options = options;
  fit.quadrature = options.quadrature.value_or(is_single_intercept(input) ? kDefaultQuadrature : 1);
  for (const std::string& column : input.fixed.columns) {
    fit.coefficients.emplace_back();
    fit.coefficients.back().column = column;
  }
  const Eigen::Index columns = input.fixed.design.cols();
  fit.covariance.setConstant(columns, columns, table::kNaN);
  return fit;
}

}  // namespace

GlmmFit fit_glmm(const GlmmInput& input, const GlmmOptions& options) {
  if (!(options.level > 0.0 && options.level < 1.0)) {
    throw std::invalid_argument("mixed model: level must be in (0, 1)");
  }
  GlmmFit fit = empty_fit(input, options);
  const std::optional<GlmmProblem> problem = glmm_problem(input, options, fit.conditions);
  if (!problem) {
    return fit;
  }
  fit.rows = static_cast<std::size_t>(problem->fixed.size());
  fit.rank = static_cast<std::size_t>(problem->fixed.space.rank());
  fit.parameters = static_cast<std::size_t>(problem->size());
  for (const std::size_t j : problem->fixed.space.dropped) {
    fit.coefficients[j].kind = CoefficientKind::not_estimable;
  }
  const GlmmMaximum maximum = solve(*problem, fit.quadrature, options);
  fit.termination = maximum.termination;
  fit.iterations = maximum.iterations;
  fit.evaluations = maximum.evaluations;
  fit.last_step = maximum.last_step;
  fit.gradient_norm =
      maximum.at.gradient.size() > 0 ? maximum.at.gradient.cwiseAbs().maxCoeff() : table::kNaN;
  if (!maximum.converged()) {
    add_no_convergence(*problem, maximum, fit);
    return fit;
  }
  add_fixed_effects(input, *problem, maximum, fit);
  add_random_effects(*problem, maximum, fit);
  add_likelihoods(*problem, maximum, fit);
  add_explained(*problem, maximum, fit);
  if (options.test_terms) {
    add_boundary_tests(input, fit);
  }
  add_singular_conditions(fit.random, fit.conditions);
  return fit;
}

}  // namespace tcert::statistics
