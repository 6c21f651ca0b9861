#include <fmt/format.h>

#include <cmath>
#include <statistics/basics/chi_square.hpp>
#include <statistics/glmm/glmm_parts.hpp>
#include <statistics/glmm/glmm_solve.hpp>

namespace tcert::statistics {
namespace {

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

}  // namespace

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
    term.test = boundary_test(term, 2.0 * (*fit.log_likelihood - *without), *fit.log_likelihood);
  }
}

BoundaryTest boundary_test(const GlmmRandomTerm& term, double drop, double log_likelihood) {
  BoundaryTest test;
  test.column = term.columns.back();
  test.df = term.columns.size();
  // Below this it is the rounding of two sums.
  const double rounding = 1e-10 * (1.0 + std::abs(log_likelihood));
  test.chi_squared = drop > rounding ? drop : 0.0;
  if (test.chi_squared > 0.0) {
    const double lower = test.df > 1 ? chi_square_tail(test.chi_squared, test.df - 1) : 0.0;
    test.p_value = 0.5 * (lower + chi_square_tail(test.chi_squared, test.df));
  }
  return test;
}

void add_singular_conditions(const std::vector<GlmmRandomTerm>& random, Conditions& conditions) {
  for (const GlmmRandomTerm& term : random) {
    if (term.singular) {
      conditions.push_back(
          {ConditionKind::singular_fit, ConditionSeverity::note, term.group, singular_words(term)});
    }
  }
}

}  // namespace tcert::statistics
