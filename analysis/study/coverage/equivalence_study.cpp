#include "analysis/study/coverage/equivalence_study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <statistics/basics/normal.hpp>
#include <statistics/equivalence/equivalence.hpp>
#include <statistics/equivalence/statistic_by_group.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <table/random.hpp>
#include <utility>

#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/h1/withhold.hpp"

namespace tcert::study::coverage {
namespace {

constexpr double kBetterAuc = 0.76;

/// Too few of an outcome in a lighting for `hypotheses h2` to test it.
bool is_withheld(const LightingStudy& study) {
  std::array<std::array<std::size_t, 2>, kLightings> count{};
  for (std::size_t i = 0; i < study.success.size(); ++i) {
    ++count[study.lighting.codes[i]][study.success[i]];
  }
  return std::any_of(count.begin(), count.end(), [](const auto& one) {
    return std::min(one[0], one[1]) < kTooFewOutcomes;
  });
}

std::optional<statistics::Equivalence> tested(const LightingStudy& study, double margin) {
  if (is_withheld(study)) {
    return std::nullopt;
  }
  const statistics::Score score{study.predictor, statistics::HigherMeans::success};
  const auto groups = statistics::jackknife_by_group(
      statistics::auc_statistic({&score, 1}, study.success), 0, study.lighting, study.day);
  if (!groups) {
    return std::nullopt;
  }
  statistics::EquivalenceOptions options;
  options.margin = margin;
  return statistics::equivalence(*groups, options);
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

EquivalenceSets::EquivalenceSets(LightingScenario scenario,
                                 std::uint32_t stream,
                                 std::uint64_t seed)
    : scenario_(std::move(scenario)), stream_(stream), seed_(seed) {}

std::optional<EquivalenceFound> EquivalenceSets::operator()(std::uint64_t index) const {
  static const double better = correlation_of(kBetterAuc);
  std::call_once(is_known_, [&] {
    correlation_ = {better, better, correlation_of(kBetterAuc - scenario_.difference)};
  });
  const auto one =
      tested(simulate(scenario_, correlation_, seed_, stream_, index), scenario_.margin);
  if (!one || !one->heterogeneity) {
    return std::nullopt;
  }
  const statistics::EquivalencePair& pair = one->pairs[1];
  return EquivalenceFound{*one->equivalent,
                          pair.equivalent,
                          one->heterogeneity->p_value < 0.05,
                          pair.standard_error,
                          *one->range,
                          *one->margin_with_power,
                          pair.difference};
}

void EquivalenceTally::add(const std::optional<EquivalenceFound>& found) {
  if (!found) {
    return;
  }
  ++sums_.tested;
  sums_.equivalent += found->equivalent ? 1.0 : 0.0;
  sums_.one_pair += found->one_pair ? 1.0 : 0.0;
  sums_.different += found->different ? 1.0 : 0.0;
  sums_.mean_error += found->error;
  sums_.mean_range += found->range;
  sums_.mean_power_margin += found->power_margin;
  sum_ += found->difference;
  squares_ += found->difference * found->difference;
}

EquivalenceRates EquivalenceTally::rates() const {
  EquivalenceRates rates = sums_;
  const auto count = static_cast<double>(rates.tested);
  for (double* const rate : {&rates.equivalent,
                             &rates.one_pair,
                             &rates.different,
                             &rates.mean_error,
                             &rates.mean_range,
                             &rates.mean_power_margin}) {
    *rate /= count;
  }
  const double variance = squares_ / count - (sum_ / count) * (sum_ / count);
  rates.true_error = rates.tested == 0 ? std::nan("") : std::sqrt(std::max(0.0, variance));
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
    for (const std::size_t days : {6U, 12U, 40U}) {
      LightingScenario alike;
      alike.days = days;
      alike.icc = icc;
      alike.margin = 0.22;
      scenarios.push_back(alike);
    }
  }
  return scenarios;
}

}  // namespace tcert::study::coverage
