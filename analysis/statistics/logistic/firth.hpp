#pragma once
/// \file
/// Firth's (1993) penalised logistic regression: finite estimates under separation too, less biased
/// in small samples. Coefficients checked against R's `brglm2` (AS_mean), profile penalised
/// likelihood intervals and tests as package `logistf` (Heinze and Schemper 2002) defines them.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/wald_estimate.hpp>
#include <statistics/logistic/logistic.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

struct FirthOptions {
  double level = 0.95;
  bool profiles = true;  ///< False leaves out the profile intervals.
  NewtonOptions newton;
  std::function<void()> advance{};  ///< Called after each coefficient.
};

/// Numbers are empty unless `kind` is finite; a test or an end that was not found is empty too. The
/// standard error is that of the inverse information at the estimate.
struct FirthCoefficient : WaldEstimate {
  std::string column;
  CoefficientKind kind = CoefficientKind::unknown;
  std::optional<ChiSquareTest> test;  ///< Penalised likelihood ratio against 0.
  std::optional<Interval> profile;    ///< Profile penalised likelihood: the one to read.
};

/// A term tested as a whole: all its columns at 0.
struct FirthTerm {
  std::string term;
  std::size_t df = 0;
  std::optional<ChiSquareTest> test;
};

struct FirthFit {
  std::size_t rows = 0;         ///< With trials and a weight above 0.
  std::size_t rank = 0;         ///< Of the design on those rows.
  std::size_t df_residual = 0;  ///< rows - rank.
  std::vector<FirthCoefficient> coefficients;
  Eigen::MatrixXd covariance;  ///< columns x columns; NaN for columns that are not estimable.
  std::vector<FirthTerm> terms;
  /// log-likelihood + log det(X' W X) / 2 on the columns that were kept, with the binomial
  /// coefficients of the counts.
  std::optional<double> penalised_log_likelihood;
  std::optional<double> log_likelihood;           ///< At the same estimate, without the penalty.
  std::optional<ChiSquareTest> likelihood_ratio;  ///< Against all but the intercept at 0.
  Eigen::VectorXd fitted;                         ///< Pr(success) of each input row.

  Separation separation = Separation::none;  ///< What the plain fit would have met.
  Termination termination = Termination::converged;
  int iterations = 0;
  double gradient_norm = 0.0;  ///< Of the penalised score along the orthonormal basis.
  double last_step = 0.0;      ///< In standard errors, before the last iteration.
  FirthOptions options;
  Conditions conditions;
};

/// Tests and profiles hold coefficients fixed under the penalty of the whole model, as `logistf`
/// does. Terms that another one contains are not tested. Without convergence there is no estimate.
///
/// Conditions: no_rows, too_few_rows, not_converged, infinite_value, bad_weight (errors);
/// constant_column, collinear_column; one_class and penalised_separation (notes: the estimates are
/// finite by the penalty). The clusters of `input` are not used. \throws std::invalid_argument as
/// `fit_logistic`. O(rows columns^3) an iteration, some 10 fits a coefficient.
[[nodiscard]] FirthFit fit_firth(const LogisticInput& input, const FirthOptions& options = {});

}  // namespace tcert::statistics
