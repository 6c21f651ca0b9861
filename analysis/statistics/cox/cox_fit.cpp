#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_inference.hpp>
#include <statistics/cox/cox_newton.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void require(bool holds, const char* message) {
  if (!holds) {
    throw std::invalid_argument(message);
  }
}

void check_shape(const CoxData& data) {
  const std::size_t n = data.rows();
  const auto rows = static_cast<Eigen::Index>(n);
  const SurvivalOutcome& outcome = data.outcome;
  require(outcome.event.size() == n && (outcome.start.empty() || outcome.start.size() == n),
          "Cox model: start, stop and event differ in length");
  require(data.design.rows() == rows, "Cox model: design and outcome differ in rows");
  const auto columns = static_cast<std::size_t>(data.design.cols());
  require(data.columns.size() == columns, "Cox model: as many names as columns");
  require(!data.offset || data.offset->size() == rows, "Cox model: offset differs in rows");
  require(!data.weights || data.weights->size() == rows, "Cox model: weights differ in rows");
  require(!data.strata || data.strata->rows() == n, "Cox model: strata differ in rows");
  require(!data.cluster || data.cluster->rows() == n, "Cox model: clusters differ in rows");
}

bool whole(const Eigen::VectorXd& weights) {
  return (weights.array() == weights.array().floor()).all();
}

bool is_robust(const CoxData& data, const CoxOptions& options) {
  return options.robust.value_or(data.cluster.has_value() ||
                                 (data.weights && !whole(*data.weights)));
}

void check_options(const CoxData& data, const CoxOptions& options) {
  require(options.level > 0.0 && options.level < 1.0, "Cox model: level must be in (0, 1)");
  if (options.ties == Ties::exact) {
    require(!data.weights || (data.weights->array() == 1.0).all(),
            "Cox model: exact ties cannot be joined with weights");
    require(!is_robust(data, options),
            "Cox model: exact ties cannot be joined with robust or cluster variance");
  }
}

void add(CoxFit& fit,
         ConditionKind kind,
         ConditionSeverity severity,
         std::string column = {},
         std::string detail = {}) {
  fit.conditions.push_back({kind, severity, std::move(column), std::move(detail)});
}

/// Errors of the rows; true if there is something to fit.
bool rows_can_be_fitted(const CoxData& data, CoxFit& fit) {
  constexpr auto kError = ConditionSeverity::error;
  if (fit.rows == 0) {
    add(fit, ConditionKind::no_rows, kError);
    return false;
  }
  for (Eigen::Index j = 0; j < data.design.cols(); ++j) {
    if (!data.design.col(j).allFinite()) {
      add(fit, ConditionKind::infinite_value, kError, data.columns[static_cast<std::size_t>(j)]);
    }
  }
  if (data.offset && !data.offset->allFinite()) {
    add(fit, ConditionKind::infinite_value, kError, "offset");
  }
  if (data.weights && !(data.weights->allFinite() && (data.weights->array() > 0.0).all())) {
    add(fit, ConditionKind::bad_weight, kError);
  }
  if (fit.events == 0) {
    add(fit, ConditionKind::no_events, kError);
  }
  if (fit.rows == 1) {
    add(fit, ConditionKind::too_few_rows, kError, {}, "a single row");
  }
  return !has_error(fit.conditions);
}

/// As coxph centres: not at all for columns of -1, 0 and 1; the exact and left-truncated fits do
/// not weight.
Eigen::VectorXd centring_means(const CoxData& data, const CoxRows& rows, Ties ties) {
  Eigen::VectorXd means = rows.centre;
  const bool weighted = ties != Ties::exact && !data.outcome.left_truncated();
  for (Eigen::Index j = 0; j < means.size(); ++j) {
    const auto column = data.design.col(j).array();
    if ((column == 0.0 || column == 1.0 || column == -1.0).all()) {
      means(j) = 0.0;
    } else if (!weighted && data.weights) {
      means(j) = column.mean();
    }
  }
  return means;
}

std::string words_of_infinite(const CoxMaximum& maximum, Eigen::Index column) {
  const double along = maximum.recession(column);
  if (std::abs(along) <= 1e-6 * maximum.recession.cwiseAbs().maxCoeff()) {
    return "the others that run away leave it open";
  }
  return along > 0.0 ? "its coefficient runs to +infinity" : "its coefficient runs to -infinity";
}

void name_columns(const CoxData& data, const CoxMaximum& maximum, CoxFit& fit) {
  constexpr auto kWarning = ConditionSeverity::warning;
  for (std::size_t j = 0; j < maximum.columns.size(); ++j) {
    const auto column = data.design.col(static_cast<Eigen::Index>(j)).array();
    switch (maximum.columns[j]) {
      case ColumnState::estimated:
        break;
      case ColumnState::constant:
        add(fit,
            ConditionKind::constant_column,
            kWarning,
            data.columns[j],
            (column == column(0)).all() ? "" : "within every set of rows at risk");
        break;
      case ColumnState::collinear:
        add(fit, ConditionKind::collinear_column, kWarning, data.columns[j]);
        break;
      case ColumnState::infinite:
        add(fit,
            ConditionKind::monotone_likelihood,
            kWarning,
            data.columns[j],
            words_of_infinite(maximum, static_cast<Eigen::Index>(j)));
        break;
    }
  }
}

/// The names alone, for a fit that has nothing to say about them.
void add_empty_coefficients(const CoxData& data, CoxFit& fit) {
  for (const std::string& column : data.columns) {
    CoxCoefficient coefficient;
    coefficient.column = column;
    fit.coefficients.push_back(std::move(coefficient));
  }
}

}  // namespace

std::string_view to_string(Ties ties) noexcept {
  switch (ties) {
    case Ties::efron:
      return "efron";
    case Ties::breslow:
      return "breslow";
    case Ties::exact:
      return "exact";
  }
  return "";
}

std::string_view to_string(CoxTermination termination) noexcept {
  switch (termination) {
    case CoxTermination::converged:
      return "converged";
    case CoxTermination::monotone:
      return "monotone likelihood";
    case CoxTermination::iteration_limit:
      return "iteration limit";
    case CoxTermination::no_fit:
      return "no fit";
  }
  return "";
}

CoxFit fit_cox(const CoxData& data, const CoxOptions& options) {
  check_shape(data);
  check_options(data, options);
  CoxFit fit;
  fit.ties = options.ties;
  fit.robust = is_robust(data, options);
  fit.level = options.level;
  fit.rows = data.rows();
  fit.events = static_cast<std::size_t>(
      std::count(data.outcome.event.begin(), data.outcome.event.end(), std::uint8_t{1}));
  if (!rows_can_be_fitted(data, fit)) {
    add_empty_coefficients(data, fit);
    return fit;
  }

  const CoxRows rows = cox_rows(data);
  const CoxMaximum maximum = maximise(rows, options);
  fit.summary = maximum.summary;
  if (!std::isfinite(maximum.null.loglik) || !maximum.null.information.allFinite()) {
    fit.summary.termination = CoxTermination::no_fit;
    add(fit,
        ConditionKind::infinite_value,
        ConditionSeverity::error,
        "offset",
        "beside the largest offset that of all rows at risk at some time is nothing");
    add_empty_coefficients(data, fit);
    return fit;
  }
  if (fit.summary.termination == CoxTermination::iteration_limit) {
    add(fit, ConditionKind::not_converged, ConditionSeverity::error);
    add_empty_coefficients(data, fit);
    return fit;
  }
  fit.df = ranked_columns(maximum.columns).size();
  for (const ColumnState state : maximum.columns) {
    fit.estimated.push_back(state == ColumnState::estimated);
  }
  fit.at_limit = maximum.at_limit;
  if (maximum.recession.size() > 0) {
    fit.recession = maximum.recession.cwiseQuotient(rows.scale);
  }
  fit.beta = maximum.beta.cwiseQuotient(rows.scale);
  fit.means = centring_means(data, rows, options.ties);
  fit.loglik_null = maximum.null.loglik;
  fit.loglik = maximum.fitted.loglik;
  fit.linear_predictors = data.design * fit.beta;
  fit.linear_predictors.array() -= fit.means.dot(fit.beta);
  if (data.offset) {
    fit.linear_predictors.array() += data.offset->array() - data.offset->mean();
  }
  name_columns(data, maximum, fit);
  if (options.inference) {
    add_cox_inference(data, rows, maximum, fit);
  }
  return fit;
}

}  // namespace tcert::statistics
