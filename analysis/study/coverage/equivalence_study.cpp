#include "analysis/study/coverage/equivalence_study.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <statistics/basics/normal.hpp>
#include <statistics/equivalence/equivalence.hpp>
#include <statistics/equivalence/scores_by_group.hpp>
#include <table/random.hpp>
#include <utility>

#include "analysis/study/coverage/coverage_study.hpp"

namespace tcert::study::coverage {
namespace {

constexpr double kBetterAuc = 0.76;

std::optional<statistics::Equivalence> tested(const LightingStudy& study, double margin) {
  const statistics::ScoresByGroup scores =
      statistics::auc_by_group({study.predictor, statistics::HigherMeans::success},
                               study.success,
                               study.lighting,
                               study.day);
  if (!scores.joint) {
    return std::nullopt;
  }
  statistics::EquivalenceOptions options;
  options.margin = margin;
  return statistics::equivalence(*scores.joint, options);
}

EquivalenceRates rates_of(const std::vector<std::optional<statistics::Equivalence>>& all) {
  EquivalenceRates rates;
  double squares = 0.0;
  double sum = 0.0;
  for (const std::optional<statistics::Equivalence>& one : all) {
    if (!one || !one->heterogeneity) {
      continue;
    }
    ++rates.tested;
    const statistics::EquivalencePair& pair = one->pairs[1];
    rates.equivalent += *one->equivalent ? 1.0 : 0.0;
    rates.one_pair += pair.equivalent ? 1.0 : 0.0;
    rates.different += one->heterogeneity->p_value < 0.05 ? 1.0 : 0.0;
    rates.mean_error += pair.standard_error;
    rates.mean_range += *one->range;
    rates.mean_power_margin += *one->margin_with_power;
    sum += pair.difference;
    squares += pair.difference * pair.difference;
  }
  const auto count = static_cast<double>(rates.tested);
  for (double* const rate : {&rates.equivalent,
                             &rates.one_pair,
                             &rates.different,
                             &rates.mean_error,
                             &rates.mean_range,
                             &rates.mean_power_margin}) {
    *rate /= count;
  }
  rates.true_error = std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
  return rates;
}

}  // namespace

double correlation_of(double auc) {
  // Secants: the function is smooth and nearly straight, and each value a long sum.
  double before = 0.3;
  double at = 0.5;
  double error_before = true_auc(before) - auc;
  double error = true_auc(at) - auc;
  while (std::abs(error) > 1e-8) {
    const double next = at - error * (at - before) / (error - error_before);
    before = std::exchange(at, next);
    error_before = std::exchange(error, true_auc(next) - auc);
  }
  return at;
}

LightingStudy simulate(const LightingScenario& scenario,
                       const std::array<double, kLightings>& correlation,
                       std::uint64_t seed,
                       std::uint32_t stream,
                       std::uint64_t index) {
  table::RandomStream random(seed, stream, index);
  const double threshold = statistics::normal_quantile(kFailureShare);
  const double shared = std::sqrt(scenario.icc);
  const double own = std::sqrt(1.0 - scenario.icc);
  LightingStudy study;
  study.lighting.levels = {"Dark", "Indoor", "Outdoor"};
  for (std::uint32_t day = 0; day < scenario.days; ++day) {
    const double day_ability = shared * random.normal();
    const double day_noise = shared * random.normal();
    for (std::uint32_t lighting = 0; lighting < kLightings; ++lighting) {
      const double r = correlation[lighting];
      for (std::size_t trial = 0; trial < scenario.trials_per_lighting; ++trial) {
        const double ability = day_ability + own * random.normal();
        const double noise = day_noise + own * random.normal();
        study.success.push_back(ability > threshold ? 1 : 0);
        study.predictor.push_back(r * ability + std::sqrt(1.0 - r * r) * noise);
        study.day.push_back(day);
        study.lighting.codes.push_back(lighting);
      }
    }
  }
  return study;
}

EquivalenceRates run_equivalence(const LightingScenario& scenario,
                                 std::uint32_t stream,
                                 std::size_t data_sets,
                                 std::uint64_t seed) {
  const double better = correlation_of(kBetterAuc);
  const double worse = correlation_of(kBetterAuc - scenario.difference);
  std::vector<std::optional<statistics::Equivalence>> all(data_sets);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, data_sets, 8), [&](const Range& range) {
    for (std::size_t index = range.begin(); index < range.end(); ++index) {
      all[index] =
          tested(simulate(scenario, {better, better, worse}, seed, stream, index), scenario.margin);
    }
  });
  EquivalenceRates rates = rates_of(all);
  rates.scenario = scenario.name;
  return rates;
}

std::vector<LightingScenario> equivalence_scenarios() {
  std::vector<LightingScenario> scenarios;
  for (const double icc : {0.0, 0.2, 0.5}) {
    for (const double margin : {0.05, 0.22, 0.27}) {
      for (const double share : {0.0, 0.5, 1.0}) {
        LightingScenario scenario;
        scenario.icc = icc;
        scenario.margin = margin;
        scenario.difference = share * margin;
        scenarios.push_back(scenario);
      }
    }
  }
  return scenarios;
}

}  // namespace tcert::study::coverage
