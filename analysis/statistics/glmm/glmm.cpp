#include <statistics/glmm/glmm.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/linalg.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/glmm/glmm_solve.hpp>
#include <statistics/logistic/near_separation.hpp>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

constexpr double kResidualVariance = std::numbers::pi * std::numbers::pi / 3.0;

/// The inverse of a positive semidefinite matrix; directions without curvature count as known.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& information) {
  const Cholesky cholesky(information);
  if (cholesky.succeeded()) {
    return cholesky.inverse();
  }
  const Eigensystem system = eigensystem_of(information);
  const double least = 1e-10 * system.values.maxCoeff();
  const Eigen::VectorXd inverse =
      system.values.unaryExpr([least](double value) { return value > least ? 1.0 / value : 0.0; });
  return system.vectors * inverse.asDiagonal() * system.vectors.transpose();
}

void set_estimate(LogisticCoefficient& coefficient,
                  double estimate,
                  double variance,
                  double level) {
  coefficient.kind = CoefficientKind::finite;
  coefficient.estimate = estimate;
  if (!(variance > 0.0)) {
    return;
  }
  const double error = std::sqrt(variance);
  coefficient.standard_error = error;
  coefficient.z = estimate / error;
  coefficient.p_value = normal_p_value(*coefficient.z, Alternative::two_sided);
  const double half = normal_factor(level) * error;
  coefficient.interval = Interval{estimate - half, estimate + half, level};
}

/// Per kept coefficient: see `ran_away()`, at the fixed part's linear predictors.
std::vector<bool> runaways(const GlmmInput& input,
                           const GlmmProblem& problem,
                           const GlmmMaximum& maximum,
                           const Eigen::MatrixXd& back,
                           const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd along = maximum.parameters.tail(back.cols());
  Eigen::VectorXd eta = problem.fixed.space.basis * along;
  if (problem.fixed.rows.offset.size() > 0) {
    eta += problem.fixed.rows.offset;
  }
  std::vector<std::size_t> names(input.fixed.columns.size());
  std::iota(names.begin(), names.end(), 0U);
  const Eigen::VectorXd estimates = back * along;
  const Eigen::VectorXd variances = covariance.diagonal();
  const Eigen::VectorXd units = Eigen::VectorXd::Ones(back.rows());
  return ran_away(input.fixed,
                  problem.fixed,
                  names,
                  {back, estimates, variances, units},
                  eta.size() > 0 ? eta.cwiseAbs().maxCoeff() : 0.0);
}

void withhold(double estimate,
              double variance,
              LogisticCoefficient& coefficient,
              Conditions& conditions) {
  coefficient.kind = CoefficientKind::ran_away;
  conditions.push_back({ConditionKind::near_separation,
                        ConditionSeverity::warning,
                        coefficient.column,
                        fmt::format("a log odds ratio of {:.3g} with a standard error of {:.3g}",
                                    estimate,
                                    std::sqrt(variance))});
}

void add_coefficients(const GlmmInput& input,
                      const GlmmProblem& problem,
                      const GlmmMaximum& maximum,
                      GlmmFit& fit) {
  const Eigen::Index rank = problem.fixed.space.rank();
  const Eigen::MatrixXd back = inverse_triangle(problem.fixed.space);
  const Eigen::VectorXd estimates = back * maximum.parameters.tail(rank);
  const Eigen::MatrixXd joint = inverse_of(-maximum.at.hessian);
  const Eigen::MatrixXd covariance = back * joint.bottomRightCorner(rank, rank) * back.transpose();
  const std::vector<std::size_t>& kept = problem.fixed.space.kept;
  const std::vector<bool> away = runaways(input, problem, maximum, back, covariance);
  for (std::size_t a = 0; a < kept.size(); ++a) {
    const auto row = static_cast<Eigen::Index>(a);
    if (away[a]) {
      withhold(estimates[row], covariance(row, row), fit.coefficients[kept[a]], fit.conditions);
      continue;
    }
    set_estimate(
        fit.coefficients[kept[a]], estimates[row], covariance(row, row), fit.options.level);
    for (std::size_t b = 0; b < kept.size(); ++b) {
      if (!away[b]) {
        fit.covariance(static_cast<Eigen::Index>(kept[a]), static_cast<Eigen::Index>(kept[b])) =
            covariance(row, static_cast<Eigen::Index>(b));
      }
    }
  }
}

GlmmRandomTerm random_term(const TermRows& rows, const Eigen::Ref<const Eigen::VectorXd>& thetas) {
  GlmmRandomTerm term;
  term.group = rows.group;
  term.columns = rows.columns;
  term.levels = rows.levels;
  term.factor = factor_of(rows, thetas);
  term.covariance = term.factor * term.factor.transpose();
  const Eigen::Index q = term.factor.rows();
  term.correlation.setConstant(q, q, table::kNaN);
  term.singular = (term.factor.diagonal().array() == 0.0).any();
  for (Eigen::Index a = 0; a < q; ++a) {
    term.sd.push_back(std::sqrt(term.covariance(a, a)));
    for (Eigen::Index b = 0; b <= a; ++b) {
      const double scale = std::sqrt(term.covariance(a, a) * term.covariance(b, b));
      if (scale > 0.0) {
        term.correlation(a, b) = a == b ? 1.0 : term.covariance(a, b) / scale;
        term.correlation(b, a) = term.correlation(a, b);
      }
    }
  }
  return term;
}

void add_random(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit) {
  const std::unique_ptr<MixedLikelihood> likelihood = problem.likelihood(fit.quadrature);
  std::vector<TermModes> modes = likelihood->modes(maximum.parameters);
  Eigen::Index at = 0;
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    const TermRows& rows = problem.terms[t];
    fit.random.push_back(random_term(rows, maximum.parameters.segment(at, rows.thetas())));
    fit.random.back().modes = std::move(modes[t].modes);
    fit.random.back().mode_sds = std::move(modes[t].sds);
    fit.singular = fit.singular || fit.random.back().singular;
    at += rows.thetas();
  }
}

/// Mean over rows of z' Sigma z.
double mean_variance(const TermRows& rows, const GlmmRandomTerm& term) {
  if (rows.design.size() == 0) {
    return term.covariance(0, 0);
  }
  const RowMajorMatrix z = rows.design * rows.scale.asDiagonal();
  const Eigen::MatrixXd products = z.transpose() * z;
  return products.cwiseProduct(term.covariance).sum() / static_cast<double>(z.rows());
}

void add_explained(const GlmmProblem& problem, const GlmmMaximum& maximum, GlmmFit& fit) {
  const Eigen::VectorXd fixed =
      problem.fixed.space.basis * maximum.parameters.tail(problem.fixed.space.rank());
  const double of_fixed =
      (fixed.array() - fixed.mean()).square().sum() / (static_cast<double>(fixed.size()) - 1.0);
  double of_random = 0.0;
  for (std::size_t t = 0; t < problem.terms.size(); ++t) {
    of_random += mean_variance(problem.terms[t], fit.random[t]);
  }
  const double whole = of_fixed + of_random + kResidualVariance;
  fit.icc = of_random / (of_random + kResidualVariance);
  fit.r2_marginal = of_fixed / whole;
  fit.r2_conditional = (of_fixed + of_random) / whole;
}

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

/// The input without the last effect of a term.
GlmmInput without_last(const GlmmInput& input, std::size_t term) {
  GlmmInput reduced = input;
  RandomEffects& random = reduced.random[term];
  random.columns.pop_back();
  if (random.columns.empty()) {
    reduced.random.erase(reduced.random.begin() + static_cast<std::ptrdiff_t>(term));
  } else {
    random.design = Eigen::MatrixXd(random.design.leftCols(random.design.cols() - 1));
  }
  return reduced;
}

/// The largest log-likelihood without the last effect of a term; empty if it was not found.
std::optional<double> log_likelihood_without(const GlmmInput& input,
                                             std::size_t term,
                                             const GlmmFit& fit) {
  const GlmmInput reduced = without_last(input, term);
  if (reduced.random.empty()) {
    return fit.fixed_log_likelihood;
  }
  GlmmOptions options = fit.options;
  options.quadrature = 1;
  Conditions conditions;
  const std::optional<GlmmProblem> problem = glmm_problem(reduced, options, conditions);
  if (!problem) {
    return std::nullopt;
  }
  const GlmmMaximum maximum = solve(*problem, 1, options);
  return maximum.converged() ? std::optional(maximum.at.value + problem->fixed.log_coefficients)
                             : std::nullopt;
}

void add_boundary_tests(const GlmmInput& input, GlmmFit& fit) {
  for (std::size_t t = 0; t < fit.random.size(); ++t) {
    GlmmRandomTerm& term = fit.random[t];
    // Without an intercept the last of several columns is a level like the others.
    if (term.columns.size() > 1 && term.columns.front() != "(Intercept)") {
      continue;
    }
    const std::optional<double> without = log_likelihood_without(input, t, fit);
    if (!without) {
      continue;
    }
    BoundaryTest test;
    test.column = term.columns.back();
    test.df = term.columns.size();
    const double drop = 2.0 * (*fit.log_likelihood - *without);
    // Below this it is the rounding of two sums.
    const double rounding = 1e-10 * (1.0 + std::abs(*fit.log_likelihood));
    test.chi_squared = drop > rounding ? drop : 0.0;
    if (test.chi_squared > 0.0) {
      const double lower = test.df > 1 ? chi_square_tail(test.chi_squared, test.df - 1) : 0.0;
      test.p_value = 0.5 * (lower + chi_square_tail(test.chi_squared, test.df));
    }
    term.test = test;
  }
}

std::string singular_words(const GlmmRandomTerm& term) {
  std::string words;
  for (std::size_t k = 0; k < term.columns.size(); ++k) {
    if (term.factor(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) != 0.0) {
      continue;
    }
    words += words.empty() ? "" : ", ";
    words += term.sd[k] == 0.0
                 ? fmt::format("the standard deviation of {} is 0", term.columns[k])
                 : fmt::format("{} is a combination of the effects before it", term.columns[k]);
  }
  if (term.test) {
    words += fmt::format(
        ", boundary p = {:.3g} for leaving out {}", term.test->p_value, term.test->column);
  }
  return words;
}

void add_singular_conditions(GlmmFit& fit) {
  for (const GlmmRandomTerm& term : fit.random) {
    if (term.singular) {
      fit.conditions.push_back(
          {ConditionKind::singular_fit, ConditionSeverity::note, term.group, singular_words(term)});
    }
  }
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
  constexpr double kRunaway = 25.0;
  const double largest = maximum.parameters.head(problem.thetas()).cwiseAbs().maxCoeff();
  if (largest > kRunaway) {
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
  add_coefficients(input, *problem, maximum, fit);
  add_random(*problem, maximum, fit);
  add_likelihoods(*problem, maximum, fit);
  add_explained(*problem, maximum, fit);
  if (options.test_terms) {
    add_boundary_tests(input, fit);
  }
  add_singular_conditions(fit);
  return fit;
}

}  // namespace tcert::statistics
