#pragma once
/// \file
/// Logistic mixed models by maximum likelihood: Laplace's approximation, or adaptive Gauss-Hermite
/// quadrature for a single random intercept. Checked against `lme4::glmer`, and against its
/// reference optima where lme4 stops short of them.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/logistic/binomial_newton.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// What is fitted: logit Pr(success) = design * beta + offset + sum over terms of z' b, where b of
/// each level of a term's group is normal with mean 0 and the term's covariance.
struct GlmmInput {
  LogisticInput fixed;  ///< `cluster` is not used.
  std::vector<RandomEffects> random;
};

/// As `logistic_input`, with the random terms of the formula. \throws std::invalid_argument for a
/// survival outcome.
[[nodiscard]] GlmmInput glmm_input(const ModelFrame& frame);

inline constexpr int kDefaultQuadrature = 15;
inline constexpr int kMostQuadrature = 100;

struct GlmmOptions {
  /// Points per group: 1 is Laplace, more only for a single random intercept. Empty: 15 there, 1
  /// for other models.
  std::optional<int> quadrature;
  double level = 0.95;
  int max_iterations = 200;  ///< Of the search, and of the Newton steps that end it.
  /// Converged when a Newton step, by the exact gradient, is shorter than this in standard errors;
  /// that step is still taken.
  double step_tolerance = 1e-7;
  bool test_terms = true;  ///< Fit the model without each random effect too.
};

/// Whether a random effect can be left out: the last column of its term against the model without
/// it, whose variance is then on the boundary, so that the statistic is half chi-squared with `df`
/// - 1 and half with `df` degrees of freedom (Stram and Lee, 1994); df is 1 for an intercept.
struct BoundaryTest {
  std::string column;        ///< The effect that is left out.
  double chi_squared = 0.0;  ///< Twice the drop of the log-likelihood, at least 0.
  std::size_t df = 1;
  double p_value = 1.0;  ///< 1 at a statistic of 0.
};

/// One random term. With q columns, b = factor * u for u standard normal.
struct GlmmRandomTerm {
  std::string group;
  std::vector<std::string> columns;  ///< q.
  std::vector<std::string> levels;   ///< Those with rows of weight.
  Eigen::MatrixXd factor;       ///< q x q, lower, diagonal at least 0: lme4's theta by columns.
  Eigen::MatrixXd covariance;   ///< q x q.
  std::vector<double> sd;       ///< q.
  Eigen::MatrixXd correlation;  ///< q x q; NaN beside an sd of 0.
  bool singular = false;        ///< The covariance lacks rank.
  std::optional<BoundaryTest> test;
  Eigen::MatrixXd modes;     ///< levels x q: b at the mode of its posterior density.
  Eigen::MatrixXd mode_sds;  ///< levels x q: from the curvature there.
};

enum class GlmmTermination : std::uint8_t {
  converged,
  not_started,  ///< The data do not allow a fit: see the conditions.
  iteration_limit,
  no_ascent,  ///< No step raises the log-likelihood, but the gradient is not 0.
  diverging,  ///< A variance or a coefficient runs to infinity.
};

/// "converged", "not started", "iteration limit", "no ascent", "diverging".
[[nodiscard]] std::string_view to_string(GlmmTermination termination) noexcept;

/// Empty numbers, NaN matrices and empty terms without an estimate.
struct GlmmFit {
  std::size_t rows = 0;        ///< With trials and a weight above 0.
  std::size_t rank = 0;        ///< Of the fixed part.
  std::size_t parameters = 0;  ///< rank + elements of the factors.
  int quadrature = 1;          ///< Used.
  std::vector<LogisticCoefficient> coefficients;
  /// Of the fixed effects: from the inverse of the exact Hessian of the deviance by the factors and
  /// the coefficients together.
  Eigen::MatrixXd covariance;
  std::vector<GlmmRandomTerm> random;

  /// Of the approximation used; binomial coefficients of counts included, whatever the number of
  /// points, so that it, AIC and BIC compare with those of a model without random effects.
  std::optional<double> log_likelihood;
  std::optional<double> laplace_log_likelihood;  ///< By Laplace at the same parameters.
  std::optional<double> fixed_log_likelihood;    ///< Of the model without random effects.
  std::optional<double> aic;
  std::optional<double> bic;  ///< With log(rows), as R.

  /// Latent scale (Nakagawa, Johnson and Schielzeth, 2017): residual pi^2 / 3; the variance of a
  /// term with slopes is the mean over rows of z' Sigma z (Johnson, 2014).
  std::optional<double> icc;
  std::optional<double> r2_marginal;     ///< var(X beta), with n - 1, over the whole.
  std::optional<double> r2_conditional;  ///< That and the random terms over the whole.

  bool singular = false;
  GlmmTermination termination = GlmmTermination::not_started;
  int iterations = 0;          ///< Of the search and Newton's method together.
  int evaluations = 0;         ///< Of the likelihood.
  double gradient_norm = 0.0;  ///< Largest element, by factors and along the orthonormal basis.
  double last_step = 0.0;      ///< In standard errors, before the last iteration.
  GlmmOptions options;
  Conditions conditions;
};

/// Conditions: those of `fit_logistic` on the fixed part (separation is an error here and named
/// with its column), no_random_effects, one_group (an error), singleton_groups (a warning),
/// singular_fit (a note with the boundary p), infinite_variance, not_converged. No estimate is
/// given without convergence. \throws std::invalid_argument if lengths differ, or quadrature is not
/// in [1, 100] or above 1 for a model that is not one random intercept. O(rows (columns^2 +
/// quadrature columns)) an evaluation for a single intercept.
[[nodiscard]] GlmmFit fit_glmm(const GlmmInput& input, const GlmmOptions& options = {});

/// True for one term with an intercept alone.
[[nodiscard]] bool is_single_intercept(const GlmmInput& input) noexcept;

}  // namespace tcert::statistics
