#include <statistics/roc/roc_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <statistics/basics/complete_rows.hpp>
#include <statistics/basics/rank_order.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// Rows of one class that a point calls right, from its rate.
double count_of(double rate, std::size_t rows) {
  return std::round(rate * static_cast<double>(rows));
}

std::optional<double> share(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

RocThreshold threshold_at(const RocCurve& curve, const RocPoint& point) {
  const auto successes = static_cast<double>(curve.successes);
  const auto failures = static_cast<double>(curve.failures);
  const double true_successes = count_of(point.sensitivity, curve.successes);
  const double true_failures = count_of(point.specificity, curve.failures);
  RocThreshold result;
  result.point = point;
  result.accuracy = (true_successes + true_failures) / (successes + failures);
  result.ppv = share(true_successes, true_successes + (failures - true_failures));
  result.npv = share(true_failures, true_failures + (successes - true_successes));
  return result;
}

/// The criterion in pairs of rows: products of counts, which are whole numbers.
double badness(const RocCurve& curve, const RocPoint& point, BestBy criterion) {
  const auto successes = static_cast<double>(curve.successes);
  const auto failures = static_cast<double>(curve.failures);
  const double missed = (successes - count_of(point.sensitivity, curve.successes)) * failures;
  const double false_alarms = (failures - count_of(point.specificity, curve.failures)) * successes;
  return criterion == BestBy::youden ? missed + false_alarms
                                     : missed * missed + false_alarms * false_alarms;
}

}  // namespace

RocCurve roc_curve(std::span<const double> score,
                   std::span<const double> success,
                   HigherMeans higher) {
  const CompleteRows rows = complete_rows({&score, 1}, success);
  RocCurve curve;
  curve.successes = rows.successes;
  curve.failures = rows.failures;
  if (rows.successes == 0 || rows.failures == 0) {
    return curve;
  }
  const std::vector<double>& x = rows.scores[0];
  const std::vector<std::uint32_t> order = rank_order(x, higher);
  const bool rising = higher == HigherMeans::success;
  const double infinity = std::numeric_limits<double>::infinity();
  const auto successes = static_cast<double>(rows.successes);
  const auto failures = static_cast<double>(rows.failures);
  curve.points.push_back({rising ? -infinity : infinity, 1.0, 0.0});
  std::size_t successes_below = 0;
  std::size_t failures_below = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    ++(rows.success[order[k]] != 0 ? successes_below : failures_below);
    const bool last = k + 1 == order.size();
    if (!last && x[order[k]] == x[order[k + 1]]) {
      continue;
    }
    const double threshold =
        last ? (rising ? infinity : -infinity) : std::midpoint(x[order[k]], x[order[k + 1]]);
    curve.points.push_back({threshold,
                            static_cast<double>(rows.successes - successes_below) / successes,
                            static_cast<double>(failures_below) / failures});
  }
  return curve;
}

std::vector<RocThreshold> best_thresholds(const RocCurve& curve, BestBy criterion) {
  double least = std::numeric_limits<double>::infinity();
  for (const RocPoint& point : curve.points) {
    least = std::min(least, badness(curve, point, criterion));
  }
  std::vector<RocThreshold> best;
  for (const RocPoint& point : curve.points) {
    if (badness(curve, point, criterion) == least) {
      best.push_back(threshold_at(curve, point));
    }
  }
  return best;
}

std::optional<double> sensitivity_at(const RocCurve& curve, double specificity) {
  if (!(specificity >= 0.0 && specificity <= 1.0)) {
    throw std::invalid_argument("ROC: specificity must be in [0, 1]");
  }
  const auto above =
      std::find_if(curve.points.begin(), curve.points.end(), [&](const RocPoint& point) {
        return point.specificity >= specificity;
      });
  if (above == curve.points.end()) {
    return std::nullopt;
  }
  if (above->specificity == specificity) {
    return above->sensitivity;
  }
  const RocPoint& below = *std::prev(above);
  const double part = (above->specificity - specificity) / (above->specificity - below.specificity);
  return above->sensitivity + part * (below.sensitivity - above->sensitivity);
}

}  // namespace tcert::statistics
