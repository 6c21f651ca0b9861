#include "analysis/study/driven/paired_arms.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <statistics/basics/quantile.hpp>
#include <statistics/equivalence/paired_proportions.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

#include "analysis/study/driven/arm_outcomes.hpp"
#include "analysis/study/h1/withhold.hpp"
#include "analysis/study/replay/replay.hpp"

namespace tcert::study {
namespace {

constexpr std::uint32_t kPairedStream = 0x48330001;

/// A pair of trials, the base's first.
struct Pair {
  const ArmOutcome* base;
  const ArmOutcome* own;
};

std::vector<Pair> pairs_of(const ArmOutcomes& base, const ArmOutcomes& own) {
  std::vector<Pair> pairs;
  for (const auto& [name, outcome] : own) {
    if (const auto other = base.find(name); other != base.end()) {
      pairs.push_back({&other->second, &outcome});
    }
  }
  return pairs;
}

ArmTotals totals_of(const std::vector<Pair>& pairs, const ArmOutcome* Pair::*side) {
  ArmTotals totals;
  std::vector<double> peaks;
  double above_s = 0.0;
  double stalls = 0.0;
  for (const Pair& pair : pairs) {
    const ArmOutcome& one = *(pair.*side);
    totals.successes += one.success ? 1 : 0;
    totals.collisions += one.end_reason == EndReason::collision ? 1 : 0;
    totals.wedged += one.end_reason == EndReason::wedged ? 1 : 0;
    totals.timeouts += one.end_reason == EndReason::timeout ? 1 : 0;
    if (!std::isnan(one.peak_force_n)) {
      peaks.push_back(one.peak_force_n);
    }
    above_s += one.time_above_s;
    stalls += one.stalls;
  }
  const auto n = static_cast<double>(pairs.size());
  totals.peak_force_n = statistics::median(peaks);
  totals.time_above_s = std::isnan(above_s) ? std::nullopt : std::optional(above_s / n);
  totals.stalls = std::isnan(stalls) ? std::nullopt : std::optional(stalls / n);
  return totals;
}

/// Codes from 0 on of the clusters of pairs.
std::vector<std::uint32_t> clusters_of(const std::vector<Pair>& pairs) {
  std::map<std::string, std::uint32_t> codes;
  std::vector<std::uint32_t> clusters;
  clusters.reserve(pairs.size());
  for (const Pair& pair : pairs) {
    const auto next = static_cast<std::uint32_t>(codes.size());
    clusters.push_back(codes.emplace(pair.base->cluster, next).first->second);
  }
  return clusters;
}

/// What is won and lost, with the bounds of the loss.
void compare_successes(const std::vector<Pair>& pairs,
                       const PairedOptions& options,
                       bool bounded,
                       ArmComparison& found) {
  std::vector<double> differences;
  for (const Pair& pair : pairs) {
    found.lost += pair.base->success && !pair.own->success ? 1 : 0;
    found.won += !pair.base->success && pair.own->success ? 1 : 0;
    found.both += pair.base->success && pair.own->success ? 1 : 0;
    differences.push_back((pair.own->success ? 1.0 : 0.0) - (pair.base->success ? 1.0 : 0.0));
  }
  const double differing =
      static_cast<double>(found.lost + found.won) / static_cast<double>(pairs.size());
  found.pairs_needed = statistics::pairs_for_non_inferiority(
      differing, options.loss_margin, 1.0 - options.level, options.power);
  const std::vector<std::uint32_t> clusters = clusters_of(pairs);
  const auto mean = statistics::clustered_mean(differences, clusters, options.level);
  found.difference = mean->value;
  found.clusters = mean->clusters;
  if (!bounded) {
    return;
  }
  found.mcnemar_p = statistics::mcnemar_exact_p(found.lost, found.won);
  found.difference_interval = mean->interval;
  // One-sided at the level: the ends of a two-sided interval at twice its error.
  const auto one_sided =
      statistics::clustered_mean(differences, clusters, 2.0 * options.level - 1.0)->interval;
  const auto at_most = [&](std::size_t count) {
    return *statistics::clopper_pearson_upper(count, pairs.size(), options.level);
  };
  const double least_lost = 1.0 - at_most(pairs.size() - found.lost);
  found.loss_upper = std::clamp(one_sided ? -one_sided->low : -1.0, at_most(found.lost), 1.0);
  found.loss_lower =
      std::clamp(one_sided ? -one_sided->high : 1.0, -1.0, least_lost - at_most(found.won));
  found.non_inferior = *found.loss_upper < options.loss_margin;
}

/// Metres and seconds of pairs of which both arrive: of an arm and, from other pairs, of the lead.
struct Driven {
  std::vector<double> base_m, base_s, own_m, own_s, lead_base_m, lead_base_s, lead_m, lead_s;
  std::vector<std::uint32_t> clusters;

  void add(const ArmOutcome* base,
           const ArmOutcome* own,
           const ArmOutcome* lead_base,
           const ArmOutcome* lead,
           std::uint32_t cluster) {
    const auto put = [](const ArmOutcome* one, std::vector<double>& m, std::vector<double>& s) {
      m.push_back(one == nullptr ? 0.0 : one->length_m);
      s.push_back(one == nullptr ? 0.0 : one->time_s);
    };
    put(base, base_m, base_s);
    put(own, own_m, own_s);
    put(lead_base, lead_base_m, lead_base_s);
    put(lead, lead_m, lead_s);
    clusters.push_back(cluster);
  }
};

enum RateValue : std::size_t { base_rate, gain, gap, recovered, rate_values };

double rate_of(std::span<const std::uint32_t> multiplicity,
               const std::vector<double>& metres,
               const std::vector<double>& seconds) {
  double length_m = 0.0;
  double time_s = 0.0;
  for (std::size_t i = 0; i < metres.size(); ++i) {
    length_m += multiplicity[i] * metres[i];
    time_s += multiplicity[i] * seconds[i];
  }
  return rate_of_advance(length_m, time_s).value_or(table::kNaN);
}

void fill_rates(const Driven& driven,
                std::span<const std::uint32_t> multiplicity,
                std::span<double> values) {
  values[base_rate] = rate_of(multiplicity, driven.base_m, driven.base_s);
  values[gain] = rate_of(multiplicity, driven.own_m, driven.own_s) - values[base_rate];
  values[gap] = rate_of(multiplicity, driven.lead_m, driven.lead_s) -
                rate_of(multiplicity, driven.lead_base_m, driven.lead_base_s);
  values[recovered] = values[gain] / values[gap];
}

bool both_arrive(const Pair& pair) {
  const auto has_rate = [](const ArmOutcome& one) {
    return one.success && !std::isnan(one.length_m) && !std::isnan(one.time_s);
  };
  return has_rate(*pair.base) && has_rate(*pair.own);
}

std::shared_ptr<const Driven> driven_of(const std::vector<Pair>& own,
                                        const std::vector<Pair>& lead) {
  auto driven = std::make_shared<Driven>();
  std::map<std::string, std::uint32_t> codes;
  const auto code = [&](const ArmOutcome& one) {
    const auto next = static_cast<std::uint32_t>(codes.size());
    return codes.emplace(one.cluster, next).first->second;
  };
  for (const Pair& pair : own) {
    if (both_arrive(pair)) {
      driven->add(pair.base, pair.own, nullptr, nullptr, code(*pair.base));
    }
  }
  for (const Pair& pair : lead) {
    if (both_arrive(pair)) {
      driven->add(nullptr, nullptr, pair.base, pair.own, code(*pair.base));
    }
  }
  return driven;
}

/// Rates of the pairs of which both arrive, days resampled.
void compare_rates(const std::vector<Pair>& own,
                   const std::vector<Pair>& lead,
                   const PairedOptions& options,
                   bool bounded,
                   ArmComparison& found,
                   H3Estimate& gap_found) {
  const auto driven = driven_of(own, lead);
  if (driven->clusters.empty()) {
    return;
  }
  statistics::Statistic statistic;
  statistic.rows = driven->clusters.size();
  statistic.values = rate_values;
  statistic.make_kernel = [driven]() -> statistics::StatisticKernel {
    return [driven](std::span<const std::uint32_t> multiplicity, std::span<double> values) {
      fill_rates(*driven, multiplicity, values);
    };
  };
  const statistics::BootstrapResult resampled =
      statistics::bootstrap(statistic,
                            statistics::ResamplingPlan::of_clusters(driven->clusters),
                            {options.replicates, options.seed, kPairedStream, {}});
  const auto estimate = [&](std::size_t value) {
    H3Estimate out;
    if (std::isnan(resampled.observed[value])) {
      return out;
    }
    out.value = resampled.observed[value];
    if (bounded) {
      out.intervals = statistics::bootstrap_intervals(resampled, value, options.level);
      out.interval = out.intervals.expanded;
    }
    return out;
  };
  found.base_rate = estimate(base_rate);
  found.gain = estimate(gain);
  gap_found = estimate(gap);
  const auto& interval = gap_found.interval;
  if (interval && (interval->low > 0.0 || interval->high < 0.0)) {
    found.recovered = estimate(recovered);
  }
}

}  // namespace

PairedArms compare_arms(const std::vector<TrialRow>& trials,
                        const std::vector<std::string>& extra_columns,
                        const PairedOptions& options) {
  const OutcomesByArm outcomes = outcomes_by_arm(trials, extra_columns, options.pair);
  const auto base = outcomes.of.find(options.base);
  if (base == outcomes.of.end()) {
    throw std::invalid_argument("no trial of '" + options.base +
                                "', which the others are to be "
                                "compared with");
  }
  PairedArms compared;
  compared.options = options;
  compared.unknown = outcomes.unknown;
  const std::vector<Pair> with_itself = pairs_of(base->second, base->second);
  compared.base = totals_of(with_itself, &Pair::base);
  compared.base_trials = with_itself.size();
  const auto lead_arm = outcomes.of.find(options.lead);
  const std::vector<Pair> lead = lead_arm == outcomes.of.end()
                                     ? std::vector<Pair>()
                                     : pairs_of(base->second, lead_arm->second);
  for (const std::string& arm : outcomes.arms) {
    const std::vector<Pair> pairs = pairs_of(base->second, outcomes.of.at(arm));
    if (arm == options.base || pairs.empty()) {
      continue;
    }
    ArmComparison found;
    found.arm = arm;
    found.pairs = pairs.size();
    found.base = totals_of(pairs, &Pair::base);
    found.own = totals_of(pairs, &Pair::own);
    const std::vector<std::uint32_t> clusters = clusters_of(pairs);
    const std::size_t days = *std::ranges::max_element(clusters) + std::size_t{1};
    const std::string few = too_few("day", days, kTooFewOutcomes, kTooFewOutcomes, kTooFewUntried);
    if (!few.empty() && compared.withheld.empty()) {
      compared.withheld = few;
      compared.conditions.push_back(withheld(few));
    } else if (auto condition = statistics::few_clusters(days);
               few.empty() && condition && !statistics::has(compared.conditions, condition->kind)) {
      compared.conditions.push_back(std::move(*condition));
    }
    compare_successes(pairs, options, few.empty(), found);
    compare_rates(pairs, lead, options, few.empty(), found, compared.gap);
    compared.arms.push_back(std::move(found));
  }
  if (compared.arms.empty()) {
    throw std::invalid_argument("no other arm drove a world that '" + options.base + "' drove");
  }
  return compared;
}

}  // namespace tcert::study
