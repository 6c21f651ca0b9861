#pragma once
/// \file
/// The Cox proportional hazards model: data, options, fit.
/// Checked against R's `survival::coxph` (Therneau and Grambsch 2000), whose definitions it keeps.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/model/model_frame.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>
#include <string_view>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// How events at the same time share the partial likelihood.
enum class Ties : std::uint8_t {
  efron,
  breslow,
  exact,  ///< The conditional likelihood over all sets of as many rows as there are events.
};

/// "efron", "breslow", "exact".
[[nodiscard]] std::string_view to_string(Ties ties) noexcept;

/// What a Cox model is fitted to; n rows, p columns, no intercept.
struct CoxData {
  SurvivalOutcome outcome;                 ///< Times rounded (`round_times`).
  Eigen::MatrixXd design;                  ///< n x p.
  std::vector<std::string> columns;        ///< p names.
  std::vector<std::string> terms;          ///< Of the formula.
  std::vector<std::size_t> term_of;        ///< p indices into `terms`.
  std::optional<Eigen::VectorXd> offset;   ///< n.
  std::optional<Eigen::VectorXd> weights;  ///< n, above 0.
  std::optional<table::Factor> strata;     ///< n codes: each level has its own baseline hazard.
  std::optional<table::Factor> cluster;    ///< n codes: rows of one level are not independent.

  [[nodiscard]] std::size_t rows() const noexcept { return outcome.rows(); }
};

/// The frame without its intercept. \throws std::invalid_argument if its outcome is not Surv().
[[nodiscard]] CoxData cox_data(const ModelFrame& frame);
[[nodiscard]] CoxData cox_data(ModelFrame&& frame);  ///< Without copies.

/// These rows of the data, in their order; a row may stand several times.
[[nodiscard]] CoxData on_rows(const CoxData& data, const std::vector<std::size_t>& rows);

struct CoxOptions {
  Ties ties = Ties::efron;
  double level = 0.95;  ///< Of the intervals.

  /// Robust variance. By default if there are clusters or a weight is not a whole number, as in R.
  std::optional<bool> robust;

  /// False: `beta`, log-likelihoods and linear predictors alone, for refits; `coefficients` is
  /// empty.
  bool inference = true;

  std::size_t iterations = 100;
  double loglik_tolerance = 1e-14;  ///< Relative change of the log-likelihood.
  double step_tolerance =
      1e-8;  ///< Largest next step, relative to 1 + |coefficient|, per scaled column.
  double rank_tolerance = 1.8e-12;  ///< A column whose share of information is below it is NA.
};

enum class CoxTermination : std::uint8_t {
  converged,  ///< Newton's next step is below 1e-5 standard errors.
  monotone,   ///< The log-likelihood converged, a coefficient runs to infinity.
  iteration_limit,
  no_fit,  ///< An error among the conditions.
};

/// "converged", "monotone likelihood", "iteration limit", "no fit".
[[nodiscard]] std::string_view to_string(CoxTermination termination) noexcept;

struct CoxSummary {
  CoxTermination termination = CoxTermination::no_fit;
  std::size_t iterations = 0;
  double gradient_norm = 0.0;  ///< Largest |score| of a scaled column.
  double last_step = 0.0;      ///< What `step_tolerance` bounds.
  double loglik_tolerance = 0.0;
  double step_tolerance = 0.0;
  double rank_tolerance = 0.0;
};

/// Empty where there is no such number: a constant or collinear column, or one that runs to
/// infinity.
struct CoxCoefficient {
  std::string column;
  bool is_infinite = false;  ///< The likelihood rises without end along it.
  std::optional<double> estimate;
  std::optional<double> hazard_ratio;
  std::optional<double> model_se;
  std::optional<double> robust_se;  ///< Empty unless robust.
  std::optional<double> z;          ///< By the robust SE if there is one.
  std::optional<double> p_value;
  std::optional<Interval> interval;  ///< Wald, of `estimate`.
};

struct CoxFit {
  Ties ties = Ties::efron;
  bool robust = false;
  std::size_t rows = 0;
  std::size_t events = 0;
  std::size_t clusters = 0;  ///< Levels among the rows; 0 without clusters.
  double level = 0.95;

  std::vector<CoxCoefficient> coefficients;
  Eigen::VectorXd beta;  ///< p, 0 where the coefficient is NA; a column that runs to infinity
                         ///< holds the last iterate, so predictors order the rows rightly.
  std::vector<bool> estimated;  ///< p: false where the column is constant or collinear, or its
                                ///< coefficient runs to infinity. Empty without a fit.
  Eigen::MatrixXd vcov;         ///< p x p, the robust one if robust; NaN where a coefficient is NA.
  Eigen::MatrixXd model_vcov;   ///< p x p.

  /// The same two without NaN: 0 in rows and columns of coefficients that have no part in the
  /// likelihood, or none in its limit. What residuals, curves and tests of hazards go by.
  Eigen::MatrixXd limit_vcov;
  Eigen::MatrixXd limit_model_vcov;

  /// p, where a coefficient runs to infinity: the direction in which they do; empty otherwise.
  Eigen::VectorXd recession;
  bool at_limit = true;  ///< False: rounding stops a monotone fit before its limit, so there are no
                         ///< numbers beside the infinite coefficients.

  Eigen::VectorXd means;  ///< p, about which coxph centres: 0 for columns of -1, 0 and 1,
                          ///< weighted for right-censored Efron and Breslow.
  Eigen::VectorXd linear_predictors;  ///< n: (x - means) beta + offset - its mean.

  std::size_t df = 0;  ///< Columns of full rank.
  std::optional<double> loglik_null;
  std::optional<double> loglik;
  std::optional<ChiSquareTest> likelihood_ratio;
  std::optional<ChiSquareTest> wald;  ///< Robust if robust.
  std::optional<ChiSquareTest> score;
  std::optional<ChiSquareTest> robust_score;  ///< At beta = 0, with the offset.
  std::optional<double> aic;
  std::optional<double> bic;  ///< By log(events).

  CoxSummary summary;
  Conditions conditions;
};

/// Maximum partial likelihood by Newton's method with step halving.
///
/// Of a monotone likelihood the numbers that have a limit as the coefficients run to infinity are
/// given at it: likelihoods and their tests, the other coefficients and their variances.
///
/// Conditions: no_rows, too_few_rows, no_events, bad_weight, infinite_value, not_converged (errors,
/// without numbers); constant_column, collinear_column, monotone_likelihood, near_separation,
/// one_cluster, no_robust_variance (a number is missing); few_clusters (a note or a warning).
///
/// O(n (log n + p^2)) a step with Efron or Breslow ties, also with robust variance; with exact ties
/// O(m d p^2) for each time with d > 1 events and m rows at risk (Gail, Lubin and Rubinstein 1981).
/// \throws std::invalid_argument if the parts have different numbers of rows or columns, the level
/// is not in (0, 1), or exact ties are joined with weights or robust variance.
[[nodiscard]] CoxFit fit_cox(const CoxData& data, const CoxOptions& options = {});

}  // namespace tcert::statistics
