#include "cli/runs/fit/predictions.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/normal.hpp>
#include <statistics/cox/cox_baseline.hpp>
#include <statistics/cox/cox_predict.hpp>
#include <statistics/logistic/binomial_likelihood.hpp>
#include <statistics/model/new_rows.hpp>
#include <statistics/survival/time_scores.hpp>
#include <table/not_a_number.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/fit/cluster_options.hpp"
#include "reports/fit/prediction_tables.hpp"

namespace tcert::cli {
namespace {

statistics::NewRows rows_to_predict(const FitInput& from) {
  const DataFile file = read_data_file(from.request.predict,
                                       statistics::columns_to_predict(from.formula, from.options),
                                       from.request.decimal_comma,
                                       from.progress);
  return statistics::new_rows(from.formula, from.table, from.frame, file.table, from.options);
}

void name_dropped(const statistics::NewRows& rows, const std::string& file, FitReport& report) {
  if (rows.dropped > 0) {
    report.conditions.push_back({statistics::ConditionKind::missing_rows,
                                 statistics::ConditionSeverity::note,
                                 "",
                                 std::to_string(rows.dropped) + " of " + file});
  }
}

/// Of a log odds; NaN of a single cluster, which has no spread.
double error_of(const Eigen::MatrixXd& covariance,
                const std::vector<Eigen::Index>& known,
                const Eigen::VectorXd& x) {
  return covariance.size() == 0 ? table::kNaN : std::sqrt(x.dot(covariance(known, known) * x));
}

/// Half width of an interval in standard errors; NaN of a single cluster.
double half_width_of(double level, bool clustered, std::size_t clusters) {
  return !clustered     ? statistics::normal_factor(level)
         : clusters < 2 ? table::kNaN
                        : statistics::t_factor(level, static_cast<double>(clusters) - 1.0);
}

/// The fit with its coefficients' covariance as the clusters have it.
statistics::CoxFit spread_by(const statistics::CoxFit& fit,
                             const statistics::ClusterInferences& inferences) {
  statistics::CoxFit spread = fit;
  if (inferences.covariance.rows() == fit.limit_vcov.rows()) {
    for (Eigen::Index i = 0; i < fit.limit_vcov.rows(); ++i) {
      for (Eigen::Index j = 0; j < fit.limit_vcov.cols(); ++j) {
        const bool counts = fit.limit_vcov(i, i) != 0.0 && fit.limit_vcov(j, j) != 0.0;
        spread.limit_vcov(i, j) = counts ? inferences.covariance(i, j) : 0.0;
      }
    }
  }
  return spread;
}

/// On the log scale.
std::optional<statistics::Interval> log_interval_of(const SurvivalRow& row,
                                                    double factor,
                                                    double level) {
  if (!row.std_error || !(row.survival > 0.0) || std::isnan(factor)) {
    return std::nullopt;
  }
  const double half = factor * *row.std_error / row.survival;
  return statistics::Interval{
      row.survival * std::exp(-half), std::min(1.0, row.survival * std::exp(half)), level};
}

}  // namespace

std::vector<double> times_of(const FitRequest& request) {
  std::vector<double> times = numbers_of("times", request.times);
  for (const double time : times) {
    if (!(time > 0.0) || !std::isfinite(time)) {
      throw UsageError("--times: expected times above 0");
    }
  }
  return times;
}

void add_predictions(const FitInput& from,
                     const statistics::LogisticFit& fit,
                     const statistics::ClusterInferences& inferences,
                     FitReport& report) {
  if (from.request.predict.empty() || !fit.log_likelihood) {
    return;
  }
  const statistics::NewRows rows = rows_to_predict(from);
  const bool clustered = !inferences.of.empty();
  const Eigen::MatrixXd& covariance = clustered ? inferences.covariance : fit.covariance;
  const double factor = half_width_of(from.request.level, clustered, fit.clusters);
  std::vector<Eigen::Index> known;
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(rows.design.cols());
  for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    const statistics::LogisticCoefficient& one = fit.coefficients[j];
    if (one.estimate) {
      beta[at] = *one.estimate;
      known.push_back(at);
    } else if (one.kind != statistics::CoefficientKind::not_estimable) {
      beta[at] = table::kNaN;  // It has no prediction where its column counts.
    }
  }
  std::vector<ProbabilityRow> shown;
  for (Eigen::Index row = 0; row < rows.design.rows(); ++row) {
    double eta = rows.offset ? (*rows.offset)[row] : 0.0;
    for (Eigen::Index j = 0; j < beta.size(); ++j) {
      eta += rows.design(row, j) == 0.0 ? 0.0 : rows.design(row, j) * beta[j];
    }
    const Eigen::VectorXd x = rows.design(row, known);
    const double error = error_of(covariance, known, x);
    ProbabilityRow one;
    one.row = rows.rows[static_cast<std::size_t>(row)] + 1;
    if (std::isfinite(eta)) {
      one.log_odds = eta;
      one.probability = statistics::inverse_logit(eta);
      if (std::isfinite(error)) {
        one.std_error = error;
        one.interval = statistics::Interval{statistics::inverse_logit(eta - factor * error),
                                            statistics::inverse_logit(eta + factor * error),
                                            from.request.level};
      }
    }
    shown.push_back(one);
  }
  report.tables.push_back(probability_table(shown));
  if (clustered) {
    report.tables.back().footnotes.push_back(prediction_footnote(fit.clusters, inferences.by));
  }
  name_dropped(rows, from.request.predict, report);
}

void add_predictions(const FitInput& from,
                     const statistics::CoxData& data,
                     const statistics::CoxFit& fit,
                     const statistics::ClusterInferences& inferences,
                     FitReport& report) {
  if (from.request.predict.empty()) {
    return;
  }
  const std::vector<double> times = times_of(from.request);
  if (times.empty()) {
    throw UsageError("--predict: of cox needs --times");
  }
  const statistics::NewRows rows = rows_to_predict(from);
  // The frame's columns hold an intercept that a Cox model has not.
  std::vector<Eigen::Index> columns;
  for (std::size_t j = 0; j < from.frame.columns.size(); ++j) {
    if (from.frame.term_of[j] != 0) {
      columns.push_back(static_cast<Eigen::Index>(j));
    }
  }
  const bool clustered = !inferences.of.empty();
  const statistics::CoxFit spread = clustered ? spread_by(fit, inferences) : fit;
  const double factor = half_width_of(from.request.level, clustered, fit.clusters);
  std::vector<SurvivalRow> shown;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Eigen::MatrixXd own = rows.design(std::vector<Eigen::Index>{at}, columns);
    const Eigen::VectorXd offset =
        rows.offset ? Eigen::VectorXd::Constant(1, (*rows.offset)[at]) : Eigen::VectorXd();
    const std::string stratum =
        rows.strata ? rows.strata->levels[rows.strata->codes[i]] : std::string();
    bool known = false;
    for (const statistics::CoxCurve& curve : statistics::cox_curves(data, spread, own, offset)) {
      if (curve.stratum != stratum) {
        continue;
      }
      known = true;
      for (const double time : times) {
        shown.push_back(survival_at(curve, rows.rows[i] + 1, time));
        if (clustered) {
          shown.back().interval = log_interval_of(shown.back(), factor, from.request.level);
        }
      }
    }
    if (!known) {
      throw statistics::FormulaError("row " + std::to_string(rows.rows[i] + 1) + " of " +
                                     from.request.predict + ": the fit has not seen stratum '" +
                                     stratum + "'");
    }
  }
  report.tables.push_back(survival_prediction_table(shown));
  if (clustered) {
    report.tables.back().footnotes.push_back(prediction_footnote(fit.clusters, inferences.by) +
                                             " The baseline hazard's own spread is by rows.");
  }
  name_dropped(rows, from.request.predict, report);
}

void add_time_scores(const FitInput& from,
                     const statistics::CoxData& data,
                     const statistics::CoxFit& fit,
                     FitReport& report) {
  const std::vector<double> times = times_of(from.request);
  if (times.empty() || data.weights || data.outcome.left_truncated()) {
    return;
  }
  const Eigen::MatrixXd risks = statistics::cox_risks(data, fit, data, times);
  std::vector<statistics::TimeScores> scores;
  for (std::size_t t = 0; t < times.size(); ++t) {
    const Eigen::VectorXd column = risks.col(static_cast<Eigen::Index>(t));
    scores.push_back(
        statistics::time_scores(data.outcome,
                                {column.data(), static_cast<std::size_t>(column.size())},
                                times[t],
                                data.cluster ? &*data.cluster : nullptr,
                                from.request.level));
  }
  add_too_many_clusters(data.cluster, report.conditions);
  report.tables.push_back(time_score_table(scores));
  report.tables.back().footnotes.emplace_back(
      "Of the rows of the fit themselves, which flatters it; out of fold: tcert fit calibration.");
}

}  // namespace tcert::cli
