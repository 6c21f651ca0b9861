#include "analysis/study/early/operating_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <stdexcept>

#include "analysis/study/h1/withhold.hpp"

namespace tcert::study {
namespace {

constexpr std::size_t kThresholdReplicates = 2000;
constexpr std::uint32_t kThresholdStream = 0x4f50;  // "OP"

/// Trials in ascending order of TC_early, each so many times.
class TrialsByCertificate {
 public:
  explicit TrialsByCertificate(const EarlyTrials& trials) : trials_(trials), order_(trials.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return trials.tc_early_m[a] < trials.tc_early_m[b];
    });
  }

  /// The largest value of a success below which lie at most 1 - retention of them; NaN without a
  /// success.
  template <class Weights>
  [[nodiscard]] double threshold(const Weights& weights, double retention) const {
    constexpr double kRounding = 1e-9;
    const double all = sum(weights, true, std::numeric_limits<double>::infinity());
    const double allowed = std::floor((1.0 - retention) * all + kRounding);
    double passed = 0.0;
    for (const std::size_t i : order_) {
      if (trials_.success[i] != 0) {
        passed += weights[i];
        if (passed > allowed) {
          return trials_.tc_early_m[i];
        }
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// Share of the trials with this outcome below the threshold; NaN without one.
  template <class Weights>
  [[nodiscard]] double below(const Weights& weights, bool success, double threshold) const {
    return sum(weights, success, threshold) /
           sum(weights, success, std::numeric_limits<double>::infinity());
  }

 private:
  template <class Weights>
  [[nodiscard]] double sum(const Weights& weights, bool success, double threshold) const {
    double total = 0.0;
    for (const std::size_t i : order_) {
      if (trials_.tc_early_m[i] >= threshold) {
        break;
      }
      total += (trials_.success[i] != 0) == success ? weights[i] : 0.0;
    }
    return total;
  }

  const EarlyTrials& trials_;
  std::vector<std::size_t> order_;
};

void resample_threshold(const EarlyTrials& trials,
                        const TrialsByCertificate& weighted,
                        double retention,
                        OperatingPoint& point) {
  statistics::Statistic statistic;
  statistic.rows = trials.size();
  statistic.values = 3;
  const double observed = point.threshold_m;
  statistic.make_kernel = [&weighted, retention, observed] {
    return [&weighted, retention, observed](auto multiplicity, auto values) {
      values[0] = weighted.threshold(multiplicity, retention);
      values[1] = 1.0 - weighted.below(multiplicity, true, observed);
      values[2] = weighted.below(multiplicity, false, values[0]);
    };
  };
  const statistics::BootstrapResult result =
      statistics::bootstrap(statistic,
                            statistics::ResamplingPlan::of_clusters(trials.day.codes),
                            {.replicates = kThresholdReplicates, .analysis = kThresholdStream});
  const auto interval_of = [&](std::size_t value) {
    return statistics::bootstrap_estimate(
               result, value, 0.95, statistics::BootstrapMethod::expanded)
        .interval;
  };
  point.threshold_interval = interval_of(0);
  point.kept.interval = interval_of(1);
  point.stopped.interval = interval_of(2);
}

std::size_t counted_of_share(double share, std::size_t of) {
  return static_cast<std::size_t>(std::llround(share * static_cast<double>(of)));
}

}  // namespace

std::optional<OperatingPoint> operating_point(const EarlyTrials& trials, double retention) {
  if (!(retention > 0.0 && retention <= 1.0)) {
    throw std::invalid_argument("the share of successes to keep lies in (0, 1]");
  }
  OperatingPoint point;
  for (const std::uint8_t success : trials.success) {
    (success != 0 ? point.successes : point.failures) += 1;
  }
  if (point.successes == 0 || point.failures == 0) {
    return std::nullopt;
  }
  const TrialsByCertificate weighted(trials);
  const std::vector<double> once(trials.size(), 1.0);
  point.threshold_m = weighted.threshold(once, retention);
  point.kept.value = 1.0 - weighted.below(once, true, point.threshold_m);
  point.stopped.value = weighted.below(once, false, point.threshold_m);
  point.by_days =
      trials.has_days &&
      too_few("day", trials.day.levels.size(), point.successes, point.failures, kTooFewUntried)
          .empty();
  if (point.by_days) {
    resample_threshold(trials, weighted, retention, point);
  } else {
    point.kept.interval =
        statistics::wilson(counted_of_share(point.kept.value, point.successes), point.successes);
    point.stopped.interval =
        statistics::wilson(counted_of_share(point.stopped.value, point.failures), point.failures);
  }
  return point;
}

std::vector<OperatingCurvePoint> operating_curve(const EarlyTrials& trials, std::size_t points) {
  const TrialsByCertificate weighted(trials);
  const std::vector<double> once(trials.size(), 1.0);
  const auto [least, most] =
      std::minmax_element(trials.tc_early_m.begin(), trials.tc_early_m.end());
  std::vector<OperatingCurvePoint> curve;
  for (std::size_t p = 0; p < points; ++p) {
    const double at = static_cast<double>(p) / static_cast<double>(points - 1);
    const double threshold = *least + at * (*most - *least);
    curve.push_back({threshold,
                     1.0 - weighted.below(once, true, threshold),
                     weighted.below(once, false, threshold)});
  }
  return curve;
}

}  // namespace tcert::study
