#pragma once
/// \file
/// Linear mixed models by restricted or full maximum likelihood: y normal about design * beta +
/// offset + sum over terms of z' b, residuals of one variance. Checked against `lme4::lmer`,
/// degrees of freedom against `lmerTest`, R2 against its formula.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/glmm/glmm.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// One row each in `design`, `y`, the designs of `random` and what is not empty of the rest.
struct LmmInput {
  Eigen::MatrixXd design;
  std::vector<std::string> columns;  ///< Names of the columns of `design`.
  std::string response = "y";
  Eigen::VectorXd y;
  Eigen::VectorXd weights;  ///< Above 0: the residual variance is divided by it. Empty: 1 each.
  Eigen::VectorXd offset;   ///< Empty: 0 each.
  std::vector<RandomEffects> random;
  Conditions conditions;  ///< What is known of the rows already; an error ends the fit.
};

/// \throws FormulaError for counts or a survival outcome.
[[nodiscard]] LmmInput lmm_input(const ModelFrame& frame);

struct LmmOptions {
  bool restricted = true;  ///< REML; else ML, by which models of other fixed effects compare.
  double level = 0.95;
  bool test_terms = true;  ///< Fit the model without each random effect too.
};

/// Numbers are empty unless `kind` is finite.
struct LmmCoefficient : WaldEstimate {
  std::string column;
  CoefficientKind kind = CoefficientKind::unknown;
  std::optional<double> df;  ///< Satterthwaite's.
  std::optional<double> t;
  std::optional<double> p_value;  ///< Two-sided, by t.
};

/// Empty numbers, NaN matrices and empty terms without an estimate.
struct LmmFit {
  std::size_t rows = 0;
  std::size_t rank = 0;        ///< Of the fixed part.
  std::size_t parameters = 0;  ///< rank + elements of the factors + the residual's.
  std::vector<LmmCoefficient> coefficients;
  Eigen::MatrixXd covariance;  ///< columns x columns, of the fixed effects.
  std::vector<GlmmRandomTerm> random;
  double residual_sd = 0.0;
  /// Restricted if the options say so, its constant that of lme4.
  std::optional<double> log_likelihood;
  std::optional<double> aic;
  std::optional<double> bic;  ///< With log(rows).

  /// Nakagawa and Schielzeth (2013); a term with slopes by its mean variance (Johnson, 2014).
  std::optional<double> icc;
  std::optional<double> r2_marginal;     ///< var(X beta), with n - 1, over the whole.
  std::optional<double> r2_conditional;  ///< That and the random terms over the whole.

  bool singular = false;
  GlmmTermination termination = GlmmTermination::not_started;
  int iterations = 0;
  int evaluations = 0;
  double gradient_norm = 0.0;  ///< Of half the profiled deviance, by the factors' elements.
  double last_step = 0.0;      ///< In standard errors.
  LmmOptions options;
  Conditions conditions;

  /// How the covariance moves with each element of the factors and with the residual's deviation,
  /// and the covariance of these: what Satterthwaite's degrees of freedom are made of.
  std::vector<Eigen::MatrixXd> covariance_slopes;
  Eigen::MatrixXd parameter_covariance;
};

/// Conditions: constant_column and collinear_column (warnings), no_random_effects, one_group,
/// singleton_groups (errors), singular_fit (a note with the boundary p), not_converged,
/// too_few_rows. \throws std::invalid_argument if lengths differ or the level is not in (0, 1). An
/// evaluation of the deviance takes O(rows (columns + effects of a row)^2) beside the sparse
/// Cholesky factor of the effects.
[[nodiscard]] LmmFit fit_lmm(const LmmInput& input, const LmmOptions& options = {});

/// What the fit says of the sum of its coefficients times `weights` (as many as columns), by t with
/// Satterthwaite's degrees of freedom. Empty where a coefficient that counts has no estimate.
[[nodiscard]] ClusterT lmm_contrast(const LmmFit& fit, const Eigen::VectorXd& weights);

}  // namespace tcert::statistics
