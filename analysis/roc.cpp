#include "analysis/roc.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "analysis/complete_rows.hpp"

namespace tcert {
namespace {

/// Conditions of the classes alone; true if there is an AUC.
bool class_conditions(const CompleteRows& rows, std::vector<AucCondition>& conditions) {
  if (rows.success.empty()) {
    conditions.push_back(AucCondition::no_rows);
  } else {
    if (rows.successes == 0) {
      conditions.push_back(AucCondition::no_successes);
    }
    if (rows.failures == 0) {
      conditions.push_back(AucCondition::no_failures);
    }
  }
  if (!conditions.empty()) {
    return false;
  }
  if (rows.successes == 1) {
    conditions.push_back(AucCondition::one_success);
  }
  if (rows.failures == 1) {
    conditions.push_back(AucCondition::one_failure);
  }
  return true;
}

/// Sample variance of the mean of `values`, n - 1 in the denominator. \pre at least two values.
double variance_of_mean(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  return squares / (n - 1.0) / n;
}

/// Two-sided standard normal quantile: 1.96 for level 0.95.
double normal_factor(double level) { return std::numbers::sqrt2 * boost::math::erf_inv(level); }

void check_level(double level) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("AUC: level must be in (0, 1)");
  }
}

std::vector<double> difference_of(std::span<const double> a, std::span<const double> b) {
  std::vector<double> result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::minus<>());
  return result;
}

}  // namespace

std::string_view to_string(AucCondition condition) noexcept {
  switch (condition) {
    case AucCondition::no_rows:
      return "no complete rows";
    case AucCondition::no_successes:
      return "no successes";
    case AucCondition::no_failures:
      return "no failures";
    case AucCondition::one_success:
      return "a single success";
    case AucCondition::one_failure:
      return "a single failure";
    case AucCondition::all_tied:
      return "all tied";
    case AucCondition::separated:
      return "separated";
    case AucCondition::same_ranking:
      return "same ranking";
    case AucCondition::zero_variance:
      return "zero variance";
  }
  return "";
}

AucEstimate auc(std::span<const double> score,
                std::span<const double> success,
                HigherMeans higher,
                double level) {
  check_level(level);
  const CompleteRows rows = complete_rows({score}, success);
  AucEstimate estimate;
  estimate.successes = rows.successes;
  estimate.failures = rows.failures;
  estimate.missing = rows.missing;
  if (!class_conditions(rows, estimate.conditions)) {
    return estimate;
  }

  const Placements place = placements(rows.scores[0], rows.success, higher);
  estimate.auc = place.auc;
  if (place.distinct == 1) {
    estimate.conditions.push_back(AucCondition::all_tied);
  }
  if (place.auc == 0.0 || place.auc == 1.0) {
    estimate.conditions.push_back(AucCondition::separated);
  }
  if (rows.successes < 2 || rows.failures < 2) {
    return estimate;
  }

  const double variance = variance_of_mean(place.successes) + variance_of_mean(place.failures);
  const double half = normal_factor(level) * std::sqrt(variance);
  estimate.variance = variance;
  estimate.interval =
      Interval{std::max(0.0, place.auc - half), std::min(1.0, place.auc + half), level};
  return estimate;
}

AucDifference paired_auc_test(const Score& first,
                              const Score& second,
                              std::span<const double> success,
                              double level) {
  check_level(level);
  const CompleteRows rows = complete_rows({first.values, second.values}, success);
  AucDifference result;
  result.successes = rows.successes;
  result.failures = rows.failures;
  result.missing = rows.missing;
  if (!class_conditions(rows, result.conditions)) {
    return result;
  }

  const Placements a = placements(rows.scores[0], rows.success, first.higher);
  const Placements b = placements(rows.scores[1], rows.success, second.higher);
  const double difference = a.auc - b.auc;
  result.first_auc = a.auc;
  result.second_auc = b.auc;
  result.difference = difference;
  if (rows.successes < 2 || rows.failures < 2) {
    return result;
  }

  // The variance of the row-wise differences is var(A) + var(B) - 2 cov(A, B) of the paper, without
  // the cancellation that leaves a spurious remainder when the two predictors rank alike.
  const double variance = variance_of_mean(difference_of(a.successes, b.successes)) +
                          variance_of_mean(difference_of(a.failures, b.failures));
  const double half = normal_factor(level) * std::sqrt(variance);
  result.variance = variance;
  result.interval = Interval{difference - half, difference + half, level};
  if (variance > 0.0) {
    const double z = difference / std::sqrt(variance);
    result.z = z;
    result.p_value = std::erfc(std::abs(z) / std::numbers::sqrt2);
  } else if (difference == 0.0) {
    result.conditions.push_back(AucCondition::same_ranking);
    result.z = 0.0;
    result.p_value = 1.0;
  } else {
    result.conditions.push_back(AucCondition::zero_variance);
  }
  return result;
}

}  // namespace tcert
