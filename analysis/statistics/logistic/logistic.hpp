#pragma once
/// \file
/// Logistic regression of successes out of trials by maximum likelihood. Checked against R's
/// `glm(family = binomial)` at a tight tolerance; separation is always looked for and named.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/wald_estimate.hpp>
#include <statistics/logistic/binomial_newton.hpp>
#include <statistics/logistic/separation.hpp>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// What is fitted. One row each in `design`, `successes`, `trials` and what is not empty of the
/// rest.
struct LogisticInput {
  Eigen::MatrixXd design;
  std::vector<std::string> columns;  ///< Names of the columns of `design`.
  std::vector<std::size_t> term_of;  ///< Per column: index into `terms` + 1; 0 is the intercept.
  std::vector<std::string> terms;
  std::string response = "y";
  Eigen::VectorXd successes;
  Eigen::VectorXd trials;   ///< Empty: 1 each.
  Eigen::VectorXd weights;  ///< Of cases, at least 0; 0 leaves the row out. Empty: 1 each.
  Eigen::VectorXd offset;   ///< Empty: 0 each.
  std::optional<table::Factor> cluster;  ///< For the robust variance.
  Conditions conditions;  ///< What is known of the rows already; an error ends the fit.
  /// Per column, if any: its values in the units that words about it are to have, where the design
  /// holds a scaled column. Empty, or of another length than the design: those of the design.
  std::vector<std::span<const double>> own_units;
};

/// The frame's outcome as successes out of trials; numbers must be 0 or 1 (condition `not_binary`,
/// an error, names the first that is not). \throws std::invalid_argument for a survival outcome.
[[nodiscard]] LogisticInput logistic_input(const ModelFrame& frame);

enum class CoefficientVariance : std::uint8_t {
  model,   ///< The inverse of the information.
  robust,  ///< Sandwich over clusters (each row its own without `cluster`), no small-sample factor,
           ///< as `rms::robcov`.
};

struct LogisticOptions {
  double level = 0.95;
  CoefficientVariance variance = CoefficientVariance::model;
  NewtonOptions newton;
};

/// Where the estimate of a coefficient lies.
enum class CoefficientKind : std::uint8_t {
  finite,
  not_estimable,   ///< Its column is constant or determined by the ones before it.
  plus_infinity,   ///< By separation.
  minus_infinity,  ///< By separation.
  diverging,       ///< By separation, in a direction that the likelihood leaves open.
  ran_away,        ///< Finite by a hair: see `ran_away()`.
  unknown,         ///< The fit ended without an estimate.
};

/// Numbers are empty unless `kind` is finite.
struct LogisticCoefficient : WaldEstimate {
  std::string column;
  CoefficientKind kind = CoefficientKind::unknown;
  std::optional<double> z;
  std::optional<double> p_value;  ///< Two-sided, normal.
};

struct LogisticFit {
  std::size_t rows = 0;         ///< With trials and a weight above 0.
  std::size_t rank = 0;         ///< Of the design on those rows.
  std::size_t df_residual = 0;  ///< rows - rank.
  std::vector<LogisticCoefficient> coefficients;
  Eigen::MatrixXd covariance;  ///< columns x columns; NaN for coefficients that are not finite.
  /// With the binomial coefficients of the counts. Under separation the supremum, like `deviance`.
  std::optional<double> log_likelihood;
  std::optional<double> deviance;
  std::optional<double> null_deviance;  ///< Intercept (if there is one) and offset alone.
  std::optional<double> aic;            ///< Empty under separation.
  std::optional<double> bic;            ///< With log(rows), as R. Empty under separation.
  Eigen::VectorXd fitted;  ///< Pr(success) of each input row; under separation its limit, NaN where
                           ///< that is not determined. Empty without an estimate.

  Separation separation = Separation::none;
  CoefficientVariance variance = CoefficientVariance::model;
  std::size_t clusters = 0;  ///< Of the robust variance; the rows where none are named.
  bool clustered = false;    ///< They are named.

  Termination termination = Termination::converged;
  int iterations = 0;
  double gradient_norm = 0.0;  ///< Along the orthonormal basis of the design, in successes.
  double last_step = 0.0;      ///< In standard errors, before the last iteration.
  LogisticOptions options;
  Conditions conditions;
};

/// Under separation the rows that are told apart without error get their limits 0 and 1, the others
/// are fitted alone, and a coefficient stays finite if they determine it: the maximum likelihood
/// estimate in the completion of the model (Geyer, 2009). No estimate is given without convergence.
///
/// Conditions: no_rows, too_few_rows, one_class, constant_column, collinear_column,
/// complete_separation, quasi_separation, near_separation, not_converged, infinite_value,
/// bad_weight, few_clusters, one_cluster. \throws std::invalid_argument if lengths differ,
/// successes lie outside [0, trials], or the level outside (0, 1). O(rows columns^2) an iteration.
[[nodiscard]] LogisticFit fit_logistic(const LogisticInput& input,
                                       const LogisticOptions& options = {});

}  // namespace tcert::statistics
