#include "analysis/study/early/auc_by_day.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/normal.hpp>
#include <stdexcept>

#include "analysis/study/h1/withhold.hpp"

namespace tcert::study {
namespace {

/// TC_early and outcomes of some trials, as estimators take them.
struct DayColumns {
  std::vector<double> tc_early;
  std::vector<double> success;
};

DayAuc auc_of_day(const std::string& name, const DayColumns& trials) {
  const statistics::AucEstimate found =
      statistics::auc(trials.tc_early, trials.success, statistics::HigherMeans::success);
  DayAuc day{name, found.successes, found.failures, found.auc, {}};
  if (day.auc) {
    day.interval = score_auc_interval(*day.auc, day.successes, day.failures);
  }
  return day;
}

void add_within_days(AucByDay& found) {
  double pairs = 0.0;
  double sum = 0.0;
  double days = 0.0;
  const auto pairs_of_day = [](const DayAuc& day) {
    return static_cast<double>(day.successes) * static_cast<double>(day.failures);
  };
  for (const DayAuc& day : found.days) {
    if (day.auc) {
      pairs += pairs_of_day(day);
      sum += pairs_of_day(day) * *day.auc;
      days += 1.0;
    }
  }
  if (days < 2.0) {
    return;
  }
  const double mean = sum / pairs;
  double squares = 0.0;
  for (const DayAuc& day : found.days) {
    if (day.auc) {
      const double influence = pairs_of_day(day) * (*day.auc - mean) / pairs;
      squares += influence * influence;
    }
  }
  constexpr double kLevel = 0.95;
  const double reach = statistics::normal_factor(kLevel) * std::sqrt(days / (days - 1.0) * squares);
  found.within = mean;
  found.within_interval = {std::max(0.0, mean - reach), std::min(1.0, mean + reach), kLevel};
}

}  // namespace

AucByDay auc_by_day(const EarlyTrials& trials) {
  std::vector<DayColumns> days(trials.day.levels.size());
  DayColumns all;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (DayColumns* const part : {&all, &days[trials.day.codes[i]]}) {
      part->tc_early.push_back(trials.tc_early_m[i]);
      part->success.push_back(trials.success[i]);
    }
  }
  AucByDay found;
  for (std::size_t d = 0; d < days.size(); ++d) {
    found.days.push_back(auc_of_day(trials.day.levels[d], days[d]));
  }
  statistics::AucOptions by_day;
  by_day.cluster = trials.day.codes;
  found.pooled =
      statistics::auc(all.tc_early, all.success, statistics::HigherMeans::success, by_day);
  add_within_days(found);
  if (!too_few("day", days.size(), found.pooled.successes, found.pooled.failures, kTooFewUntried)
           .empty()) {
    found.pooled.interval.reset();
    found.within_interval.reset();
  }
  return found;
}

statistics::Interval score_auc_interval(double auc,
                                        std::size_t successes,
                                        std::size_t failures,
                                        double level) {
  constexpr int kHalvings = 100;
  if (successes == 0 || failures == 0 || !(auc >= 0.0 && auc <= 1.0)) {
    throw std::invalid_argument("an interval of an AUC needs both outcomes and an AUC in [0, 1]");
  }
  const double z = statistics::normal_factor(level);
  const auto m = static_cast<double>(successes);
  const auto n = static_cast<double>(failures);
  const double others = (m + n) / 2.0 - 1.0;
  const auto standard_error = [&](double t) {
    const double spread = 1.0 + others * ((1.0 - t) / (2.0 - t) + t / (1.0 + t));
    return std::sqrt(t * (1.0 - t) * spread / (m * n));
  };
  // From the observed AUC, which is within, to the end of the range, which is not or is the end.
  const auto limit = [&](double outside) {
    double inside = auc;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (inside + outside) / 2.0;
      (std::abs(middle - auc) <= z * standard_error(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  return {limit(0.0), limit(1.0), level};
}

}  // namespace tcert::study
