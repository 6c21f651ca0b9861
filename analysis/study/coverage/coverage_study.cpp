#include "analysis/study/coverage/coverage_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <statistics/basics/normal.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/concordance/concordance.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <statistics/roc/roc.hpp>
#include <table/random.hpp>
#include <utility>

#include "analysis/study/h1/withhold.hpp"

namespace tcert::study::coverage {
namespace {

constexpr std::array<const char*, kMethods> kMethodNames{"analytic_plain",
                                                         "analytic_clustered",
                                                         "percentile_days",
                                                         "expanded_days",
                                                         "bca_days",
                                                         "jackknife_days"};
constexpr std::array<const char*, kQuantities> kQuantityNames{"auc", "delta_auc", "c", "delta_c"};
/// Where the quantities are among the values of the joined statistic: each of its parts has the
/// first predictor, the second, the difference.
constexpr std::array<std::size_t, kQuantities> kValueOf{0, 2, 3, 5};

/// DeLong's intervals of the AUCs and the jackknife's of the Cs.
void add_analytic(const Study& study,
                  const std::vector<statistics::Score>& scores,
                  const statistics::SurvivalOutcome& outcome,
                  const std::vector<statistics::Predictor>& predictors,
                  double level,
                  bool clustered,
                  Intervals& result) {
  const std::size_t method = clustered ? 1 : 0;
  const std::vector<double> success(study.success.begin(), study.success.end());
  const std::span<const std::uint32_t> days =
      clustered ? std::span<const std::uint32_t>(study.day) : std::span<const std::uint32_t>();
  const statistics::JointAuc joint = statistics::joint_auc(scores, success, {level, days});
  result.by_quantity[0][method] = joint.markers[0].interval;
  result.by_quantity[1][method] = statistics::auc_contrast(joint, 0, 1).interval;
  table::Factor day;
  day.codes = study.day;
  day.levels.resize(1 + static_cast<std::size_t>(study.day.back()));
  statistics::ConcordanceOptions options;
  options.level = level;
  options.cluster = clustered ? &day : nullptr;
  const statistics::ConcordanceResult c = statistics::concordance(outcome, predictors, options);
  result.by_quantity[2][method] = c.estimates[0].interval;
  result.by_quantity[3][method] = c.differences[0].interval;
}

constexpr std::size_t kBootstrap = 2;  // Percentile, expanded, BCa.
constexpr std::size_t kJackknife = 5;

void add_bootstrap(const statistics::Statistic& statistic,
                   const statistics::ResamplingPlan& plan,
                   const statistics::BootstrapOptions& options,
                   double level,
                   Intervals& result) {
  const statistics::BootstrapResult boot = statistics::bootstrap(statistic, plan, options);
  const auto left_out = statistics::leave_one_out(statistic, plan);
  for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) {
    const std::size_t value = kValueOf[quantity];
    result.estimate[quantity] = boot.observed[value];
    const statistics::BootstrapIntervals intervals =
        statistics::bootstrap_intervals(boot, value, level);
    result.by_quantity[quantity][kBootstrap] = intervals.percentile;
    result.by_quantity[quantity][kBootstrap + 1] = intervals.expanded;
    result.by_quantity[quantity][kBootstrap + 2] = intervals.bca;
    result.by_quantity[quantity][kJackknife] =
        statistics::jackknife_estimate(boot.observed[value], left_out[value], level).interval;
  }
}

/// Pr(x of the higher ability > x of the lower) over independent abilities, the higher above the
/// threshold of failure and the lower below what `lower_end` says: given both, the difference of
/// the predictors is normal.
template <typename LowerEnd>
double mean_over_pairs(double correlation, LowerEnd lower_end) {
  const double threshold = statistics::normal_quantile(kFailureShare);
  const double scale = correlation / std::sqrt(2.0 * (1.0 - correlation * correlation));
  const auto density = [](double x) { return std::exp(-0.5 * x * x); };
  // Midpoints: the integrand is smooth and the tails beyond 9 are below 1e-18.
  constexpr int kPanels = 1500;
  constexpr double kReach = 9.0;
  const double step = (kReach - threshold) / kPanels;
  double sum = 0.0;
  double weight = 0.0;
  for (int j = 0; j < kPanels; ++j) {
    const double higher = threshold + (j + 0.5) * step;
    const double step_lower = (lower_end(higher, threshold) + kReach) / kPanels;
    for (int i = 0; i < kPanels; ++i) {
      const double lower = -kReach + (i + 0.5) * step_lower;
      const double w = density(lower) * density(higher) * step_lower;
      sum += w * statistics::normal_cdf(scale * (higher - lower));
      weight += w;
    }
  }
  return sum / weight;
}

/// Of the quantities, in their order.
std::array<double, kQuantities> true_values() {
  const double first_auc = true_auc(kFirstCorrelation);
  const double first_c = true_c(kFirstCorrelation);
  return {first_auc,
          first_auc - true_auc(kSecondCorrelation),
          first_c,
          first_c - true_c(kSecondCorrelation)};
}

}  // namespace

Study simulate(const Scenario& scenario,
               std::uint64_t seed,
               std::uint32_t stream,
               std::uint64_t index) {
  table::RandomStream random(seed, stream, index);
  const double threshold = statistics::normal_quantile(kFailureShare);
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
      const bool success = ability > threshold;
      study.success.push_back(success ? 1 : 0);
      study.time.push_back(success ? 60.0 - 5.0 * ability : 120.0);
      study.first.push_back(predictor(kFirstCorrelation, ability, first));
      study.second.push_back(predictor(kSecondCorrelation, ability, second));
      study.day.push_back(day);
    }
  }
  return study;
}

double true_auc(double correlation) {
  return mean_over_pairs(correlation, [](double, double threshold) { return threshold; });
}

double true_c(double correlation) {
  return mean_over_pairs(correlation, [](double higher, double) { return higher; });
}

bool is_withheld(const Study& study) {
  const auto successes =
      static_cast<std::size_t>(std::count(study.success.begin(), study.success.end(), 1));
  return std::min(successes, study.success.size() - successes) < kTooFewOutcomes;
}

Intervals intervals_of(const Scenario& scenario,
                       std::uint32_t stream,
                       const Options& options,
                       std::uint64_t index) {
  const Study study = simulate(scenario, options.seed, stream, index);
  Intervals result;
  result.withheld = is_withheld(study);
  if (result.withheld) {
    return result;
  }
  const std::vector<statistics::Score> scores{{study.first, statistics::HigherMeans::success},
                                              {study.second, statistics::HigherMeans::success}};
  const std::vector<statistics::Predictor> predictors{
      {"first", study.first, statistics::LargerMeans::shorter_time},
      {"second", study.second, statistics::LargerMeans::shorter_time}};
  const statistics::SurvivalOutcome outcome{{}, study.time, study.success};
  for (const bool clustered : {false, true}) {
    add_analytic(study, scores, outcome, predictors, options.level, clustered, result);
  }
  const statistics::Statistic statistic =
      statistics::joined({statistics::auc_statistic(scores, study.success, {{0, 1}}),
                          statistics::concordance_statistic(outcome, predictors, {{0, 1}})});
  // Every data set resamples by its own stream.
  add_bootstrap(statistic,
                statistics::ResamplingPlan::of_clusters(study.day),
                {options.replicates, options.seed + index, 101U},
                options.level,
                result);
  return result;
}

CoverageTally::CoverageTally(const std::string& scenario) {
  static const std::array<double, kQuantities> truth = true_values();
  for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) {
    for (const char* const method : kMethodNames) {
      Coverage sum;
      sum.scenario = scenario;
      sum.quantity = kQuantityNames[quantity];
      sum.method = method;
      sum.truth = truth[quantity];
      sums_.push_back(std::move(sum));
    }
  }
}

void CoverageTally::add(const Intervals& set) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    Coverage& sum = sums_[i];
    if (set.withheld) {
      ++sum.withheld;
      continue;
    }
    sum.mean_estimate += set.estimate[i / kMethods];
    const auto& interval = set.by_quantity[i / kMethods][i % kMethods];
    if (!interval) {
      ++sum.missing;
      continue;
    }
    ++sum.intervals;
    sum.covered += interval->low <= sum.truth && sum.truth <= interval->high ? 1.0 : 0.0;
    sum.mean_width += interval->high - interval->low;
  }
}

std::vector<Coverage> CoverageTally::rows() const {
  std::vector<Coverage> rows = sums_;
  for (Coverage& row : rows) {
    const auto count = static_cast<double>(row.intervals);
    row.mean_estimate /= static_cast<double>(row.intervals + row.missing);
    row.covered /= count;
    row.monte_carlo_se = std::sqrt(row.covered * (1.0 - row.covered) / count);
    row.mean_width /= count;
  }
  return rows;
}

std::vector<Scenario> coverage_scenarios() {
  std::vector<Scenario> scenarios;
  for (const std::size_t days : {6U, 12U, 22U, 40U}) {
    for (const double icc : {0.0, 0.2, 0.5}) {
      scenarios.push_back({fmt::format("{} days, icc {:g}", days, icc), days, 30, icc});
    }
  }
  return scenarios;
}

}  // namespace tcert::study::coverage
