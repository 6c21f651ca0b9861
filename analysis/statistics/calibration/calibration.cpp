#include <statistics/basics/few_clusters.hpp>
#include <statistics/calibration/calibration.hpp>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/calibration/calibration_bins.hpp>
#include <statistics/logistic/logistic.hpp>
#include <stdexcept>
#include <string>
#include <table/csv_write.hpp>

namespace tcert::statistics {
namespace {

void check(std::span<const double> outcome,
           std::span<const double> probability,
           const table::Factor* cluster,
           const CalibrationOptions& options) {
  if (outcome.size() != probability.size() ||
      (cluster != nullptr && cluster->rows() != outcome.size())) {
    throw std::invalid_argument("calibration: lengths differ");
  }
  if (!(options.level > 0.0 && options.level < 1.0) || options.bins < 3) {
    throw std::invalid_argument("calibration: level must be in (0, 1), bins at least 3");
  }
  const bool binary = std::all_of(outcome.begin(), outcome.end(), [](double y) {
    return y == 0.0 || y == 1.0 || std::isnan(y);
  });
  if (!binary) {
    throw std::invalid_argument("calibration: an outcome is 0 or 1");
  }
}

/// Rows of one kind: how many, and the first.
struct NamedRows {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t row) { first = count++ == 0 ? row : first; }
};

/// "3 rows, the first is row 5 (line 6) with 1.5".
std::string words_of(const NamedRows& named,
                     std::span<const double> probability,
                     const CalibrationOptions& options) {
  std::string words =
      std::to_string(named.count) + (named.count == 1 ? " row, " : " rows, the first is ");
  words += options.place ? options.place(named.first) : "row " + std::to_string(named.first + 1);
  words += " with ";
  table::append_number(words, probability[named.first]);
  return words;
}

/// Complete rows; a probability outside [0, 1] becomes an error, one of 0 or 1 a warning.
CalibrationRows usable_rows(std::span<const double> outcome,
                            std::span<const double> probability,
                            const table::Factor* cluster,
                            const CalibrationOptions& options,
                            ModelCalibration& result) {
  CalibrationRows rows;
  NamedRows outside;
  NamedRows certain;
  bool predicted = false;
  for (std::size_t i = 0; i < outcome.size(); ++i) {
    const double p = probability[i];
    predicted = predicted || !std::isnan(p);
    if (std::isnan(outcome[i]) || std::isnan(p) ||
        (cluster != nullptr && cluster->codes[i] == table::Factor::kMissing)) {
      ++result.missing;
      continue;
    }
    if (!(p >= 0.0 && p <= 1.0)) {
      outside.add(i);
      continue;
    }
    if (p == 0.0 || p == 1.0) {
      certain.add(i);
    }
    rows.outcome.push_back(outcome[i]);
    rows.probability.push_back(p);
    if (cluster != nullptr) {
      rows.cluster.push_back(cluster->codes[i]);
    }
  }
  if (outside.count > 0) {
    result.conditions.push_back({ConditionKind::bad_probability,
                                 ConditionSeverity::error,
                                 options.column,
                                 words_of(outside, probability, options)});
  } else if (certain.count > 0) {
    result.conditions.push_back({ConditionKind::certain_probability,
                                 ConditionSeverity::warning,
                                 options.column,
                                 words_of(certain, probability, options)});
  }
  if (!outcome.empty() && !predicted) {
    result.conditions.push_back({ConditionKind::no_prediction, ConditionSeverity::error, "", ""});
  }
  return rows;
}

/// The outcome on the logit of its probability; with `slope` held at 1 that is an offset.
LogisticFit recalibration(const CalibrationRows& rows,
                          const table::Factor* cluster,
                          bool slope,
                          double level) {
  const auto n = static_cast<Eigen::Index>(rows.outcome.size());
  LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(n, slope ? 2 : 1);
  input.columns = {"(Intercept)"};
  input.term_of = {0};
  input.successes = Eigen::Map<const Eigen::VectorXd>(rows.outcome.data(), n);
  Eigen::VectorXd logit(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double p = rows.probability[static_cast<std::size_t>(i)];
    logit[i] = std::log(p) - std::log1p(-p);
  }
  if (slope) {
    input.design.col(1) = logit;
    input.columns.emplace_back("logit p");
    input.term_of.push_back(1);
    input.terms = {"logit p"};
  } else {
    input.offset = logit;
  }
  LogisticOptions options;
  options.level = level;
  if (cluster != nullptr) {
    input.cluster = table::Factor{rows.cluster, cluster->levels};
    options.variance = CoefficientVariance::robust;
  }
  return fit_logistic(input, options);
}

void add_recalibration(const CalibrationRows& rows,
                       const table::Factor* cluster,
                       double level,
                       ModelCalibration& result) {
  if (result.events == 0 || result.events == result.rows) {
    result.conditions.push_back(
        {ConditionKind::one_class, ConditionSeverity::warning, "", "no slope, no intercepts"});
    return;
  }
  if (has(result.conditions, ConditionKind::certain_probability)) {
    return;
  }
  const LogisticFit both = recalibration(rows, cluster, true, level);
  result.in_the_large = recalibration(rows, cluster, false, level).coefficients[0];
  for (Condition condition : both.conditions) {
    const bool apart = condition.kind == ConditionKind::complete_separation ||
                       condition.kind == ConditionKind::quasi_separation ||
                       condition.kind == ConditionKind::near_separation;
    if (apart) {
      condition.advice =
          "the probabilities tell the outcomes apart, so that no finite slope recalibrates them";
    }
    if (condition.kind == ConditionKind::few_clusters) {
      condition = few_clusters(both.clusters, both.rank).value_or(condition);  // No refits here.
    }
    if (condition.kind == ConditionKind::constant_column) {
      condition.advice = "equal probabilities have no slope";
    }
    // The probabilities stand although no finite slope recalibrates them.
    if (condition.severity == ConditionSeverity::error) {
      condition.severity = ConditionSeverity::warning;
    }
    result.conditions.push_back(std::move(condition));
  }
  if (both.coefficients[1].estimate) {
    result.intercept = both.coefficients[0];
    result.slope = both.coefficients[1];
  }
}

}  // namespace

ModelCalibration calibration(std::span<const double> outcome,
                             std::span<const double> probability,
                             const table::Factor* cluster,
                             const CalibrationOptions& options) {
  check(outcome, probability, cluster, options);
  ModelCalibration result;
  const CalibrationRows rows = usable_rows(outcome, probability, cluster, options, result);
  result.rows = rows.outcome.size();
  if (has_error(result.conditions)) {
    return result;
  }
  if (rows.outcome.empty()) {
    result.conditions.push_back({ConditionKind::no_rows, ConditionSeverity::error, "", ""});
    return result;
  }
  for (std::size_t i = 0; i < rows.outcome.size(); ++i) {
    result.events += rows.outcome[i] == 1.0 ? 1 : 0;
    result.expected += rows.probability[i];
  }
  result.clusters = count_codes(rows.cluster);
  result.observed = static_cast<double>(result.events);
  if (result.events > 0) {
    result.expected_to_observed = result.expected / result.observed;
  }
  result.bins = calibration_bins(rows, options);
  if (result.bins.size() < options.bins) {
    result.conditions.push_back(
        {ConditionKind::few_bins,
         ConditionSeverity::note,
         "",
         std::to_string(result.bins.size()) + " of " + std::to_string(options.bins)});
  }
  result.brier = brier_parts(rows, result.bins);
  result.hosmer_lemeshow = hosmer_lemeshow(result.bins);
  add_recalibration(rows, cluster, options.level, result);
  return result;
}

}  // namespace tcert::statistics
