#include "coverage/coverage_study.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "analysis/basics/normal.hpp"
#include "analysis/resampling/bootstrap.hpp"
#include "analysis/roc/auc_statistic.hpp"
#include "analysis/roc/roc.hpp"
#include "datasets/random.hpp"

namespace tcert::coverage {
namespace {

constexpr std::size_t kMethods = 6;
constexpr std::array<const char*, kMethods> kMethodNames{"delong_plain",
                                                         "delong_clustered",
                                                         "percentile_trials",
                                                         "bca_trials",
                                                         "percentile_days",
                                                         "bca_days"};

/// Intervals of the AUC and of the difference by every method, and the estimates.
struct Intervals {
  std::array<std::array<std::optional<Interval>, kMethods>, 2> by_quantity;
  std::array<double, 2> estimate{};
};

Intervals intervals_of(const Study& study, const Options& options, std::uint64_t index) {
  const std::vector<Score> scores{{study.first, HigherMeans::success},
                                  {study.second, HigherMeans::success}};
  const std::vector<double> outcome(study.success.begin(), study.success.end());
  Intervals result;
  for (const bool clustered : {false, true}) {
    const JointAuc joint = joint_auc(
        scores,
        outcome,
        {options.level,
         clustered ? std::span<const std::uint32_t>(study.day) : std::span<const std::uint32_t>()});
    const std::size_t method = clustered ? 1 : 0;
    result.by_quantity[0][method] = joint.markers[0].interval;
    result.by_quantity[1][method] = auc_contrast(joint, 0, 1).interval;
  }
  const Statistic statistic = auc_statistic(scores, study.success, {{0, 1}});
  for (const bool clustered : {false, true}) {
    const ResamplingPlan plan = clustered ? ResamplingPlan::of_clusters(study.day)
                                          : ResamplingPlan::of_rows(study.success.size());
    // Every data set resamples by its own stream.
    const BootstrapResult boot = bootstrap(
        statistic, plan, {options.replicates, options.seed + index, clustered ? 101U : 100U});
    for (const std::size_t quantity : {0U, 1U}) {
      const std::size_t value = quantity == 0 ? 0 : 2;
      const BootstrapDistribution distribution =
          bootstrap_distribution(boot.replicates[value], boot.observed[value]);
      result.estimate[quantity] = boot.observed[value];
      const std::size_t method = clustered ? 4 : 2;
      result.by_quantity[quantity][method] =
          bootstrap_interval(distribution, BootstrapMethod::percentile, {}, options.level).interval;
      result.by_quantity[quantity][method + 1] =
          bootstrap_interval(
              distribution, BootstrapMethod::bca, boot.acceleration[value], options.level)
              .interval;
    }
  }
  return result;
}

Coverage summary(const std::vector<Intervals>& all,
                 std::size_t quantity,
                 std::size_t method,
                 double truth) {
  Coverage result;
  result.quantity = quantity == 0 ? "auc" : "delta_auc";
  result.method = kMethodNames[method];
  result.truth = truth;
  double covered = 0.0;
  double width = 0.0;
  for (const Intervals& of_set : all) {
    result.mean_estimate += of_set.estimate[quantity] / static_cast<double>(all.size());
    const auto& interval = of_set.by_quantity[quantity][method];
    if (!interval) {
      ++result.missing;
      continue;
    }
    ++result.intervals;
    covered += interval->low <= truth && truth <= interval->high ? 1.0 : 0.0;
    width += interval->high - interval->low;
  }
  const auto count = static_cast<double>(result.intervals);
  result.covered = covered / count;
  result.monte_carlo_se = std::sqrt(result.covered * (1.0 - result.covered) / count);
  result.mean_width = width / count;
  return result;
}

}  // namespace

Study simulate(const Scenario& scenario,
               std::uint64_t seed,
               std::uint32_t stream,
               std::uint64_t index) {
  RandomStream random(seed, stream, index);
  const double threshold = normal_quantile(kFailureShare);
  const double shared = std::sqrt(scenario.icc);
  const double own = std::sqrt(1.0 - scenario.icc);
  const auto predictor = [](double correlation, double ability, double noise) {
    return correlation * ability + std::sqrt(1.0 - correlation * correlation) * noise;
  };
  Study study;
  for (std::uint32_t day = 0; day < scenario.days; ++day) {
    const double day_ability = shared * random.normal();
    const double day_first = shared * random.normal();
    const double day_second = shared * random.normal();
    for (std::size_t trial = 0; trial < scenario.trials_per_day; ++trial) {
      const double ability = day_ability + own * random.normal();
      const double first = day_first + own * random.normal();
      const double second = day_second + own * random.normal();
      study.success.push_back(ability > threshold ? 1 : 0);
      study.first.push_back(predictor(kFirstCorrelation, ability, first));
      study.second.push_back(predictor(kSecondCorrelation, ability, second));
      study.day.push_back(day);
    }
  }
  return study;
}

double true_auc(double correlation) {
  const double threshold = normal_quantile(kFailureShare);
  const double scale = correlation / std::sqrt(2.0 * (1.0 - correlation * correlation));
  const auto density = [](double x) { return std::exp(-0.5 * x * x); };
  // Midpoints: the integrand is smooth and the tails beyond 9 are below 1e-18.
  constexpr int kPanels = 1500;
  constexpr double kReach = 9.0;
  const double step_failure = (threshold + kReach) / kPanels;
  const double step_success = (kReach - threshold) / kPanels;
  double sum = 0.0;
  double weight = 0.0;
  for (int i = 0; i < kPanels; ++i) {
    const double failure = -kReach + (i + 0.5) * step_failure;
    for (int j = 0; j < kPanels; ++j) {
      const double success = threshold + (j + 0.5) * step_success;
      const double w = density(failure) * density(success);
      sum += w * normal_cdf(scale * (success - failure));
      weight += w;
    }
  }
  return sum / weight;
}

std::vector<Coverage> run(const Scenario& scenario, std::uint32_t stream, const Options& options) {
  std::vector<Intervals> all(options.data_sets);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, options.data_sets, 1), [&](const Range& range) {
    for (std::size_t index = range.begin(); index < range.end(); ++index) {
      all[index] = intervals_of(simulate(scenario, options.seed, stream, index), options, index);
    }
  });
  const double first = true_auc(kFirstCorrelation);
  const double second = true_auc(kSecondCorrelation);
  std::vector<Coverage> rows;
  for (const std::size_t quantity : {0U, 1U}) {
    for (std::size_t method = 0; method < kMethods; ++method) {
      rows.push_back(summary(all, quantity, method, quantity == 0 ? first : first - second));
      rows.back().scenario = scenario.name;
    }
  }
  return rows;
}

}  // namespace tcert::coverage
