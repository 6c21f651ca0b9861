#include "analysis/study/coverage/advance_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/normal.hpp>
#include <table/random.hpp>

#include "analysis/study/h3/chosen_beta.hpp"
#include "analysis/study/h3/h3_group.hpp"

namespace tcert::study::coverage {
namespace {

constexpr double kSpread = 0.3;       ///< Of log times.
constexpr double kGatedSpread = 0.1;  ///< Of what gating does to one of them.
constexpr double kLength = 6.0;
constexpr double kGatedMedian = 50.0;
constexpr double kBaselineMedian = 30.0;
constexpr double kBold = 0.8;  ///< Times are multiplied by it, but for their own spread.
/// Of the mean time nothing is gained, though every trial takes a time of its own.
const double kIdle = std::exp(-0.5 * kGatedSpread * kGatedSpread);
constexpr double kMargin = 0.05;
/// Of the successes, so that the margin of all trials is reached.
constexpr double kLossOfSuccess = kMargin / (1.0 - kFailureShare);

/// What one trial shares with its day, and its own.
class Alike {
 public:
  Alike(double icc, table::RandomStream& random) : icc_(icc), random_(random) {}

  [[nodiscard]] double day() { return std::sqrt(icc_) * random_.normal(); }
  [[nodiscard]] double of(double day) { return day + std::sqrt(1.0 - icc_) * random_.normal(); }

 private:
  double icc_;
  table::RandomStream& random_;
};

struct Trial {
  std::string id;
  bool baseline = false;
  std::size_t day = 0;
  std::size_t lighting = 0;
  bool success = false;
  double time = 0.0;
  double gated_times = 1.0;  ///< What gating multiplies its time by, but for the law.
  bool loses = false;
};

void add_case(const Trial& trial, const char* law, double beta, double factor, ReplayRows& rows) {
  static constexpr std::array kLightings{"Dark", "Indoor", "Outdoor"};
  rows.trial.push_back(trial.id);
  rows.algorithm.emplace_back(trial.baseline ? "CB-V" : "M3");
  rows.lighting.emplace_back(kLightings.at(trial.lighting));
  rows.cluster.push_back(std::to_string(trial.day));
  rows.law.emplace_back(law);
  rows.success.push_back(trial.success ? 1.0 : 0.0);
  rows.beta.push_back(beta);
  rows.length.push_back(kLength);
  rows.time.push_back(trial.time);
  rows.gated_time.push_back(trial.time * factor * trial.gated_times);
  for (std::vector<double>* const column : {&rows.speed, &rows.gated_speed, &rows.latency}) {
    column->push_back(0.1);
  }
  const bool loses = std::string_view(law) == "bold" && trial.loses;
  rows.stalls.push_back(loses ? 1.0 : 0.0);
  rows.kept.push_back(trial.success && !loses ? 1.0 : 0.0);
}

/// Metres a minute of many trials: a rate is a ratio of means.
double true_rate(double median, double factor, double spread) {
  return 60.0 * kLength / (median * factor * std::exp(0.5 * spread * spread));
}

std::optional<bool> misses(const H3Estimate& estimate, double truth) {
  return estimate.interval
             ? std::optional(truth < estimate.interval->low || truth > estimate.interval->high)
             : std::nullopt;
}

const H3Chosen& found(const std::vector<H3Chosen>& all,
                      const std::string& law,
                      const std::string& lighting) {
  for (const H3Chosen& one : all) {
    if (one.law == law && one.lighting == lighting) {
      return one;
    }
  }
  return all.front();
}

}  // namespace

ReplayRows simulate_replays(const AdvanceScenario& scenario,
                            std::uint64_t seed,
                            std::uint32_t stream,
                            std::uint64_t index) {
  table::RandomStream random(seed, stream, index);
  Alike alike(scenario.icc, random);
  const double fails = statistics::normal_quantile(kFailureShare);
  const double loses = statistics::normal_quantile(kLossOfSuccess);
  ReplayRows rows;
  for (std::size_t day = 0; day < scenario.days; ++day) {
    for (const bool baseline : {false, true}) {
      const double day_time = alike.day();
      const double day_failing = alike.day();
      const double day_losing = alike.day();
      for (std::size_t i = 0; i < 3 * scenario.trials_per_lighting; ++i) {
        Trial trial;
        trial.id = fmt::format("{}{}_{}", baseline ? "c" : "m", day, i);
        trial.baseline = baseline;
        trial.day = day;
        trial.lighting = i % 3;
        trial.time =
            (baseline ? kBaselineMedian : kGatedMedian) * std::exp(kSpread * alike.of(day_time));
        trial.success = alike.of(day_failing) > fails;
        trial.loses = alike.of(day_losing) < loses;
        trial.gated_times = std::exp(kGatedSpread * random.normal());
        for (const double beta : {10.0, 20.0}) {
          add_case(trial, "bold", beta, kBold, rows);
          add_case(trial, "idle", beta, kIdle, rows);
          trial.gated_times = std::exp(kGatedSpread * random.normal());
        }
      }
    }
  }
  return rows;
}

AdvanceMisses advance_misses_of(const AdvanceScenario& scenario,
                                std::uint32_t stream,
                                const Options& options,
                                std::uint64_t index) {
  H3Options h3;
  h3.level = options.level;
  h3.loss_margin = kMargin;
  h3.replicates = options.replicates;
  h3.seed = options.seed + index;
  const ReplayRows rows = simulate_replays(scenario, options.seed, stream, index);
  const Grouped trials = grouped(rows, h3);
  std::vector<H3Group> groups;
  std::vector<H3Trial> all;
  for (const auto& [lighting, some] : trials.by_lighting) {
    all.insert(all.end(), some.begin(), some.end());
  }
  groups.push_back(group_of(rows, all, trials.cases, h3, {}, "all"));
  for (const auto& [lighting, some] : trials.by_lighting) {
    groups.push_back(group_of(rows, some, trials.cases, h3, {}, lighting));
  }
  const std::vector<H3Chosen> fixed = chosen_cases(rows, trials, groups, h3, {});
  h3.beta.per_m.reset();
  const std::vector<H3Chosen> folded = chosen_cases(rows, trials, groups, h3, {});

  const double own = true_rate(kGatedMedian, 1.0, kSpread);
  const double gain = true_rate(kGatedMedian, kBold, std::hypot(kSpread, kGatedSpread)) - own;
  const double gap = true_rate(kBaselineMedian, 1.0, kSpread) - own;
  const H3Chosen& bold = found(fixed, "bold", "all");
  const H3Chosen& idle = found(fixed, "idle", "all");
  const auto below = [&](const std::optional<double>& p) {
    return p ? std::optional(*p < 1.0 - options.level) : std::nullopt;
  };
  std::optional<bool> any;
  for (const H3Chosen& one : fixed) {
    if (one.lighting != "all" && one.holds) {
      any = any.value_or(false) || *one.holds;
    }
  }
  std::optional<bool> independent;
  if (groups.front().withheld.empty()) {
    independent =
        *statistics::clopper_pearson_upper(bold.lost, bold.trials, options.level) < kMargin;
  }
  return {{misses(groups.front().ungated, own),
           misses(groups.front().gap, gap),
           misses(bold.gain, gain),
           misses(found(fixed, "bold", "Dark").gain, gain),
           misses(bold.recovered, gain / gap),
           misses(found(folded, "bold", "all").gain, gain),
           misses(found(folded, "bold", "all").recovered, gain / gap),
           below(idle.gain_p),
           below(bold.loss_p),
           independent,
           any}};
}

std::vector<AdvanceRate> advance_rates(const AdvanceScenario& scenario,
                                       const std::vector<AdvanceMisses>& sets) {
  std::vector<AdvanceRate> rates;
  for (std::size_t k = 0; k < kAdvancePrinted.size(); ++k) {
    rates.push_back({count_missed(sets, k), scenario, kAdvancePrinted[k]});
  }
  return rates;
}

std::vector<AdvanceScenario> advance_scenarios() {
  std::vector<AdvanceScenario> scenarios;
  for (const Scenario& one : coverage_scenarios()) {
    scenarios.push_back({one.name, one.days, 3, one.icc});
  }
  return scenarios;
}

}  // namespace tcert::study::coverage
