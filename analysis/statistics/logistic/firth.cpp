#include <statistics/logistic/firth.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <statistics/basics/linalg.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/logistic/firth_newton.hpp>
#include <statistics/logistic/likelihood_profile.hpp>
#include <statistics/logistic/logistic_checks.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <statistics/logistic/separation_words.hpp>
#include <statistics/model/droppable_terms.hpp>

namespace tcert::statistics {
namespace {

ProfilePoint point_of(const FirthNewtonResult& newton) {
  // Away from the maximum the Hessian need not be definite; the information always is.
  return {newton.coefficients, newton.at.value, newton.at.gradient, newton.at.information};
}

/// A problem with its maximum, and tests of linear functionals of its coefficients.
class FirthMaximum {
 public:
  FirthMaximum(const LogisticProblem& problem, const NewtonOptions& options)
      : problem_(problem),
        options_(options),
        back_(inverse_triangle(problem.space)),
        newton_(maximise_firth(
            problem.space.basis, problem.rows, starting_point(problem), std::nullopt, options)) {}

  [[nodiscard]] const FirthNewtonResult& newton() const noexcept { return newton_; }
  /// Row k: what the k-th kept coefficient is of those along the basis.
  [[nodiscard]] const Eigen::MatrixXd& back() const noexcept { return back_; }

  /// Likelihood ratio against the kept coefficients `kept` all at 0.
  [[nodiscard]] std::optional<ChiSquareTest> test(const std::vector<Eigen::Index>& kept) const {
    if (kept.empty()) {
      return std::nullopt;
    }
    const Eigen::MatrixXd functionals = back_(kept, Eigen::all).transpose();
    const Eigen::MatrixXd lines = Cholesky(newton_.at.information).solve(functionals);
    const Eigen::MatrixXd products = functionals.transpose() * lines;
    const Eigen::VectorXd start =
        newton_.coefficients -
        lines * solve_symmetric(products, functionals.transpose() * newton_.coefficients);
    const auto at_zero = maximise(start, orthogonal_complement(functionals));
    if (!at_zero) {
      return std::nullopt;
    }
    return chi_square_test(2.0 * (newton_.at.value - at_zero->value), kept.size());
  }

  [[nodiscard]] std::optional<Interval> profile(Eigen::Index kept, double level) const {
    return profile_interval(
        point_of(newton_),
        back_.row(kept).transpose(),
        [this](const Eigen::VectorXd& start, const Eigen::MatrixXd& subspace) {
          return maximise(start, subspace);
        },
        level);
  }

 private:
  /// Far from the estimate the penalised likelihood can have several maxima on start +
  /// span(subspace), so it is climbed from three points: there, and where the other directions are
  /// 0 or those of the estimate.
  [[nodiscard]] std::optional<ProfilePoint> maximise(const Eigen::VectorXd& start,
                                                     const Eigen::MatrixXd& subspace) const {
    const Eigen::VectorXd fixed = start - subspace * (subspace.transpose() * start);
    const Eigen::VectorXd as_estimated =
        fixed + subspace * (subspace.transpose() * newton_.coefficients);
    std::optional<ProfilePoint> best;
    for (const Eigen::VectorXd& from : {start, fixed, as_estimated}) {
      const FirthNewtonResult result =
          maximise_firth(problem_.space.basis, problem_.rows, from, subspace, options_);
      if (result.converged() && (!best || result.at.value > best->value)) {
        best = point_of(result);
      }
    }
    return best;
  }

  const LogisticProblem& problem_;
  const NewtonOptions& options_;
  Eigen::MatrixXd back_;
  FirthNewtonResult newton_;
};

void add_outcome_conditions(const LogisticInput& input,
                            const LogisticProblem& problem,
                            Conditions& conditions) {
  if (problem.size() == 0) {
    conditions.push_back({ConditionKind::no_rows, ConditionSeverity::error, "", ""});
    return;
  }
  if (problem.space.rank() == problem.size() && !problem.space.dropped.empty()) {
    conditions.push_back(
        {ConditionKind::too_few_rows,
         ConditionSeverity::error,
         "",
         fmt::format("{} for {} coefficients", problem.size(), input.columns.size())});
  }
  const double successes = problem.rows.successes.sum();
  if (successes == 0.0 || successes == problem.rows.trials.sum()) {
    conditions.push_back({ConditionKind::one_class,
                          ConditionSeverity::note,
                          input.response,
                          fmt::format("{} of {} are successes, the estimates are the penalty's",
                                      successes,
                                      problem.rows.trials.sum())});
  }
}

/// Names the columns that only the penalty keeps finite.
void add_separation(const LogisticInput& input, const LogisticProblem& problem, FirthFit& fit) {
  if (has(fit.conditions, ConditionKind::one_class)) {
    return;
  }
  const BinomialRows& rows = problem.rows;
  fit.separation = find_separation(problem.space.basis, rows.successes, rows.trials).kind;
  if (fit.separation == Separation::none) {
    return;
  }
  const Eigen::MatrixXd functionals = inverse_triangle(problem.space).transpose();
  const std::vector<Signs> signs =
      recession_signs(problem.space.basis, rows.successes, rows.trials, functionals);
  for (std::size_t k = 0; k < signs.size(); ++k) {
    if (signs[k].positive || signs[k].negative) {
      const std::size_t column = problem.space.kept[k];
      fit.conditions.push_back(
          {ConditionKind::penalised_separation,
           ConditionSeverity::note,
           input.columns[column],
           separation_words(input, problem.used, column),
           fit.options.profiles ? "" : "the Wald interval misleads; ask for the profile's"});
    }
  }
}

void add_coefficients(const LogisticProblem& problem, const FirthMaximum& maximum, FirthFit& fit) {
  const Eigen::Index rank = problem.space.rank();
  const Eigen::MatrixXd inverse = Cholesky(maximum.newton().at.information).inverse();
  const Eigen::MatrixXd covariance = maximum.back() * inverse * maximum.back().transpose();
  const Eigen::VectorXd estimates = maximum.back() * maximum.newton().coefficients;
  const double factor = normal_factor(fit.options.level);
  for (Eigen::Index k = 0; k < rank; ++k) {
    const std::size_t column = problem.space.kept[static_cast<std::size_t>(k)];
    FirthCoefficient& one = fit.coefficients[column];
    const double error = std::sqrt(covariance(k, k));
    one.kind = CoefficientKind::finite;
    one.estimate = estimates[k];
    one.standard_error = error;
    one.interval =
        Interval{estimates[k] - factor * error, estimates[k] + factor * error, fit.options.level};
    one.test = maximum.test({k});
    if (fit.options.profiles) {
      one.profile = maximum.profile(k, fit.options.level);
    }
    if (fit.options.advance) {
      fit.options.advance();
    }
    for (Eigen::Index other = 0; other < rank; ++other) {
      fit.covariance(
          static_cast<Eigen::Index>(column),
          static_cast<Eigen::Index>(problem.space.kept[static_cast<std::size_t>(other)])) =
          covariance(k, other);
    }
  }
}

/// Kept columns of which `belongs(term)` holds; term 0 is the intercept.
template <class Belongs>
std::vector<Eigen::Index> kept_columns(const LogisticInput& input,
                                       const LogisticProblem& problem,
                                       const Belongs& belongs) {
  std::vector<Eigen::Index> columns;
  for (std::size_t k = 0; k < problem.space.kept.size(); ++k) {
    if (belongs(input.term_of[problem.space.kept[k]])) {
      columns.push_back(static_cast<Eigen::Index>(k));
    }
  }
  return columns;
}

void add_tests(const LogisticInput& input,
               const LogisticProblem& problem,
               const FirthMaximum& maximum,
               FirthFit& fit) {
  fit.likelihood_ratio =
      maximum.test(kept_columns(input, problem, [](std::size_t term) { return term != 0; }));
  for (const std::size_t t : droppable_terms(input.terms)) {
    const auto columns =
        kept_columns(input, problem, [t](std::size_t term) { return term == t + 1; });
    fit.terms.push_back({input.terms[t], columns.size(), maximum.test(columns)});
  }
}

void add_solution(const LogisticInput& input, const LogisticProblem& problem, FirthFit& fit) {
  const FirthMaximum maximum(problem, fit.options.newton);
  const FirthNewtonResult& newton = maximum.newton();
  fit.termination = newton.termination;
  fit.iterations = newton.iterations;
  fit.last_step = newton.last_step;
  fit.gradient_norm = newton.at.gradient.norm();
  if (!newton.converged()) {
    fit.conditions.push_back({ConditionKind::not_converged,
                              ConditionSeverity::error,
                              "",
                              fmt::format("{} after {} iterations, gradient {:.2g}",
                                          to_string(newton.termination),
                                          newton.iterations,
                                          fit.gradient_norm)});
    return;
  }
  add_separation(input, problem, fit);
  add_coefficients(problem, maximum, fit);
  add_tests(input, problem, maximum, fit);
  fit.log_likelihood = newton.at.log_likelihood + problem.log_coefficients;
  // The determinant is that of the design's own columns, not of its basis.
  fit.penalised_log_likelihood = newton.at.value + problem.log_coefficients +
                                 problem.space.triangle.diagonal().array().log().sum();
  Eigen::VectorXd all = Eigen::VectorXd::Zero(input.design.cols());
  for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
    all[static_cast<Eigen::Index>(j)] = fit.coefficients[j].estimate.value_or(0.0);
  }
  Eigen::VectorXd eta = input.design * all;
  if (input.offset.size() > 0) {
    eta += input.offset;
  }
  fit.fitted = eta.unaryExpr([](double value) { return inverse_logit(value); });
}

}  // namespace

FirthFit fit_firth(const LogisticInput& input, const FirthOptions& options) {
  FirthFit fit;
  fit.options = options;
  if (const auto problem = begin_fit(input, add_outcome_conditions, fit)) {
    add_solution(input, *problem, fit);
  }
  return fit;
}

}  // namespace tcert::statistics
