#include <algorithm>
#include <cmath>
#include <numeric>
#include <statistics/cox/cox_predict.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/resampling/cross_validation.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <statistics/survival/time_scores.hpp>
#include <table/not_a_number.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/fit/cluster_options.hpp"
#include "cli/runs/fit/predictions.hpp"
#include "reports/fit/prediction_tables.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kBins = 10;

statistics::Folds folds_of(const statistics::CoxData& data, const FitRequest& request) {
  std::vector<std::uint32_t> cluster(data.rows());
  std::iota(cluster.begin(), cluster.end(), 0U);
  statistics::FoldOptions options;
  options.folds = static_cast<std::size_t>(request.folds);
  options.seed = static_cast<std::uint64_t>(request.seed);
  return statistics::assign_folds(
      data.outcome.event, data.cluster ? data.cluster->codes : cluster, options);
}

/// Rows x times, each from the fit that has not seen its fold; NaN where that has no fit.
Eigen::MatrixXd risks_out_of_fold(const statistics::CoxData& data,
                                  const statistics::Folds& folds,
                                  const std::vector<double>& times,
                                  statistics::Conditions& conditions) {
  Eigen::MatrixXd risks = Eigen::MatrixXd::Constant(
      data.design.rows(), static_cast<Eigen::Index>(times.size()), table::kNaN);
  for (std::size_t fold = 0; fold < folds.count; ++fold) {
    statistics::CoxData training =
        statistics::on_rows(data, statistics::training_rows(folds, fold));
    training.cluster.reset();
    const statistics::CoxFit fit = statistics::fit_cox(training);
    const bool whole = std::all_of(
        fit.estimated.begin(), fit.estimated.end(), [](bool estimated) { return estimated; });
    if (fit.summary.termination != statistics::CoxTermination::converged || !whole) {
      conditions.push_back({statistics::ConditionKind::fold_without_fit,
                            statistics::ConditionSeverity::warning,
                            "",
                            "fold " + std::to_string(fold + 1) + ": " +
                                std::string(statistics::to_string(fit.summary.termination))});
      continue;
    }
    const std::vector<std::size_t> held_out = statistics::held_out_rows(folds, fold);
    const Eigen::MatrixXd own =
        statistics::cox_risks(training, fit, statistics::on_rows(data, held_out), times);
    for (std::size_t i = 0; i < held_out.size(); ++i) {
      risks.row(static_cast<Eigen::Index>(held_out[i])) = own.row(static_cast<Eigen::Index>(i));
    }
  }
  return risks;
}

/// As the risks: 1 - Kaplan-Meier of the rows outside each row's fold.
Eigen::MatrixXd same_risks(const statistics::CoxData& data,
                           const statistics::Folds& folds,
                           const std::vector<double>& times) {
  Eigen::MatrixXd risks(data.design.rows(), static_cast<Eigen::Index>(times.size()));
  for (std::size_t fold = 0; fold < folds.count; ++fold) {
    const auto outside = statistics::on_rows(data.outcome, statistics::training_rows(folds, fold));
    const statistics::SurvivalCurve curve = statistics::survival_curves(outside).front();
    for (std::size_t t = 0; t < times.size(); ++t) {
      const statistics::SurvivalPoint* const point = curve.at(times[t]);
      for (const std::size_t row : statistics::held_out_rows(folds, fold)) {
        risks(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(t)) =
            point == nullptr ? 0.0 : 1.0 - point->survival;
      }
    }
  }
  return risks;
}

std::vector<double> values_of(const Eigen::MatrixXd& risks,
                              const std::vector<std::size_t>& rows,
                              std::size_t time) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) {
    values.push_back(risks(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(time)));
  }
  return values;
}

/// The log hazard ratio of log(-log(1 - risk)): 1 where risks are as far apart as they should be.
/// Follow-up ends at `time`, for that is what the risks are of.
statistics::ClusterT slope_of(const statistics::CoxData& data,
                              const std::vector<double>& risk,
                              double time,
                              double level,
                              std::optional<double>& slope) {
  statistics::CoxData recalibrated;
  recalibrated.outcome = data.outcome;
  for (std::size_t row = 0; row < risk.size(); ++row) {
    if (recalibrated.outcome.stop[row] > time) {
      recalibrated.outcome.stop[row] = time;
      recalibrated.outcome.event[row] = 0;
    }
  }
  recalibrated.cluster = data.cluster;
  recalibrated.columns = recalibrated.terms = {"log(-log(1 - risk))"};
  recalibrated.term_of = {0};
  recalibrated.design.resize(static_cast<Eigen::Index>(risk.size()), 1);
  for (std::size_t i = 0; i < risk.size(); ++i) {
    recalibrated.design(static_cast<Eigen::Index>(i), 0) = std::log(-std::log1p(-risk[i]));
  }
  if (!recalibrated.design.allFinite()) {
    return {};
  }
  const statistics::CoxFit fit = statistics::fit_cox(recalibrated);
  slope = fit.coefficients.front().estimate;
  statistics::WildOptions options;
  options.level = level;
  if (recalibrated.cluster) {
    return statistics::cluster_inferences(recalibrated, fit, {}, options).of.front();
  }
  statistics::ClusterT plain;
  plain.interval = fit.coefficients.front().interval;
  return plain;
}

TimeCalibration calibration_at(const statistics::CoxData& data,
                               const std::vector<double>& risk,
                               const std::vector<double>& same,
                               double time,
                               double level) {
  const table::Factor* const cluster = data.cluster ? &*data.cluster : nullptr;
  TimeCalibration one;
  one.scores = statistics::time_scores(data.outcome, risk, time, cluster, level);
  one.scores.brier_null =
      statistics::time_scores(data.outcome, same, time, nullptr, level).brier.value;
  one.bins = statistics::risk_bins(data.outcome, risk, time, kBins, cluster, level);
  one.whole = statistics::risk_bins(data.outcome, risk, time, 1, cluster, level).front();
  one.slope_interval = slope_of(data, risk, time, level, one.slope).interval;
  return one;
}

}  // namespace

FitReport fit_time_calibration(const FitInput& from) {
  const statistics::CoxData data = statistics::cox_data(from.frame);
  const std::vector<double> times = times_of(from.request);
  if (times.empty()) {
    throw UsageError("calibration of Surv() needs --times");
  }
  if (data.outcome.left_truncated() || !from.request.predicted.empty()) {
    throw UsageError("calibration of Surv() takes Surv(time, event), and no --predicted");
  }
  statistics::Conditions conditions;
  const statistics::Folds folds = folds_of(data, from.request);
  conditions.insert(conditions.end(), folds.conditions.begin(), folds.conditions.end());
  const Eigen::MatrixXd risks = risks_out_of_fold(data, folds, times, conditions);
  const Eigen::MatrixXd same = same_risks(data, folds, times);
  add_too_many_clusters(data.cluster, conditions);
  std::vector<std::size_t> known;
  for (std::size_t row = 0; row < data.rows(); ++row) {
    if (risks.row(static_cast<Eigen::Index>(row)).allFinite()) {
      known.push_back(row);
    }
  }
  std::vector<TimeCalibration> all;
  const statistics::CoxData scored = statistics::on_rows(data, known);
  for (std::size_t t = 0; t < times.size() && !known.empty(); ++t) {
    all.push_back(calibration_at(scored,
                                 values_of(risks, known, t),
                                 values_of(same, known, t),
                                 times[t],
                                 from.request.level));
  }
  FitReport report = time_calibration_report(all, data.rows() - known.size(), folds.count);
  report.conditions = std::move(conditions);
  return report;
}

}  // namespace tcert::cli
