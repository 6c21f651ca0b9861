#include <limits>
#include <numeric>
#include <statistics/calibration/calibration.hpp>
#include <statistics/calibration/out_of_fold.hpp>
#include <statistics/model/frame_checks.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/fit/fit_input.hpp"
#include "reports/fit/calibration_report.hpp"

namespace tcert::cli {
namespace {

std::vector<double> as_vector(const Eigen::VectorXd& values) {
  return {values.data(), values.data() + values.size()};
}

/// The given probabilities: the formula's only predictor.
std::vector<double> given(const FitInput& from) {
  const statistics::ModelFrame& frame = from.frame;
  std::vector<double> values;
  std::size_t others = 0;
  const std::string given_name = statistics::to_string(statistics::Expression{
      statistics::Expression::Kind::column, 0.0, from.request.predicted, {}});
  for (std::size_t k = 0; k < frame.columns.size(); ++k) {
    if (frame.term_of[k] == 0) {
      continue;
    }
    if (frame.columns[k] == given_name) {
      values = as_vector(frame.design.col(static_cast<Eigen::Index>(k)));
    } else {
      ++others;
    }
  }
  if (others > 0 || values.empty()) {
    throw UsageError("--predicted " + from.request.predicted + ": the formula is to be '" +
                     frame.response + " ~ " + from.request.predicted + "'");
  }
  return values;
}

/// Folds of whole clusters; rows are their own without one.
statistics::Folds folds_of(const statistics::LogisticInput& input, const FitRequest& request) {
  const auto rows = static_cast<std::size_t>(input.design.rows());
  std::vector<std::uint8_t> success(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    success[i] = input.successes[static_cast<Eigen::Index>(i)] == 1.0 ? 1 : 0;
  }
  std::vector<std::uint32_t> cluster(rows);
  std::iota(cluster.begin(), cluster.end(), 0U);
  statistics::FoldOptions fold_options;
  fold_options.folds = static_cast<std::size_t>(request.folds);
  fold_options.seed = static_cast<std::uint64_t>(request.seed);
  return statistics::assign_folds(
      success, input.cluster ? input.cluster->codes : cluster, fold_options);
}

void add(const statistics::Conditions& more, statistics::Conditions& conditions) {
  conditions.insert(conditions.end(), more.begin(), more.end());
}

void predict(const statistics::LogisticInput& input,
             const FitRequest& request,
             CalibrationSource& source,
             statistics::Conditions& conditions) {
  const statistics::Folds folds = folds_of(input, request);
  add(folds.conditions, conditions);
  source.folds = folds.count;
  source.probability.assign(source.rows.size(), std::numeric_limits<double>::quiet_NaN());
  if (folds.count < 2) {
    return;
  }
  statistics::OutOfFold predicted = statistics::out_of_fold_probabilities(input, folds);
  source.probability = std::move(predicted.probability);
  add(predicted.conditions, conditions);
  for (const std::uint32_t fold : folds.of_row) {
    source.fold.push_back(fold + 1);
  }
}

}  // namespace

FitReport fit_calibration(const FitInput& from) {
  if (std::holds_alternative<statistics::SurvivalOutcome>(from.frame.outcome)) {
    return fit_time_calibration(from);
  }
  if (from.frame.strata) {
    throw UsageError("strata: calibration takes them with Surv()");
  }
  if (!from.request.times.empty()) {
    throw UsageError("--times: calibration takes them with Surv()");
  }
  const statistics::LogisticInput input = statistics::logistic_input(from.frame);
  if (input.trials.size() > 0 || input.weights.size() > 0) {
    throw UsageError("calibration takes one trial a row: no cbind() and no --weights");
  }
  CalibrationSource source;
  source.rows = from.frame.rows;
  source.predicted = from.request.predicted;
  statistics::Conditions conditions = input.conditions;
  statistics::ModelCalibration result;
  if (!statistics::has_error(conditions)) {
    source.outcome = as_vector(input.successes);
    if (source.predicted.empty()) {
      predict(input, from.request, source, conditions);
    } else {
      source.probability = given(from);
    }
    statistics::CalibrationOptions options;
    options.level = from.request.level;
    options.column = source.predicted;
    options.place = [&](std::size_t row) { return statistics::place_of(from.frame, row); };
    result = statistics::calibration(
        source.outcome, source.probability, input.cluster ? &*input.cluster : nullptr, options);
  } else {
    source.rows.clear();
  }
  result.conditions.insert(result.conditions.begin(), conditions.begin(), conditions.end());
  return calibration_report(result, source, from.request.level);
}

}  // namespace tcert::cli
