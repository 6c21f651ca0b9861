#include <statistics/survival/time_rounding.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <statistics/basics/sort_order.hpp>

namespace tcert::statistics {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Two stamps of about 1.7e9 s are off by 1.2e-7 each, so two differences of them by 4.8e-7.
constexpr double kStampRounding = 5e-7;
constexpr double kShare = 1e-6;

/// Distinct numbers as they first come, up to `kMost` of them; empty if there are more.
std::vector<double> few_distinct(const std::vector<double>& times) {
  constexpr std::size_t kSlots = 4096;
  constexpr std::size_t kMost = kSlots / 4;
  std::vector<double> slots(kSlots, std::numeric_limits<double>::quiet_NaN());
  std::vector<double> distinct;
  for (const double time : times) {
    // Fibonacci hashing of the bits; -0 is 0.
    std::size_t slot = (std::bit_cast<std::uint64_t>(time + 0.0) * 0x9E3779B97F4A7C15U) >> 52U;
    while (slots[slot] != time && !std::isnan(slots[slot])) {
      slot = (slot + 1) % kSlots;
    }
    if (slots[slot] != time) {
      if (distinct.size() == kMost) {
        return {};
      }
      slots[slot] = time;
      distinct.push_back(time);
    }
  }
  std::sort(distinct.begin(), distinct.end());
  return distinct;
}

std::vector<double> distinct_values(const std::vector<double>& times) {
  std::vector<double> distinct = few_distinct(times);
  if (!distinct.empty()) {
    return distinct;
  }
  for (const std::uint32_t row : sort_order(times)) {
    if (distinct.empty() || distinct.back() != times[row]) {
      distinct.push_back(times[row]);
    }
  }
  return distinct;
}

std::vector<double> distinct_times(const SurvivalOutcome& outcome) {
  std::vector<double> stops = distinct_values(outcome.stop);
  if (!outcome.left_truncated()) {
    return stops;
  }
  const std::vector<double> starts = distinct_values(outcome.start);
  std::vector<double> all;
  std::set_union(starts.begin(), starts.end(), stops.begin(), stops.end(), std::back_inserter(all));
  return all;
}

double timefix_step(const std::vector<double>& distinct) {
  const double sum =
      std::accumulate(distinct.begin(), distinct.end(), 0.0, [](double total, double time) {
        return total + std::abs(time);
      });
  const double mean = distinct.empty() ? 0.0 : sum / static_cast<double>(distinct.size());
  return std::sqrt(kEpsilon) * std::max(1.0, mean);
}

/// Counts what is there, with R's rule, which compares neighbours.
TimeRounding counts_of(const std::vector<double>& distinct) {
  TimeRounding rounding;
  rounding.distinct = rounding.kept = distinct.size();
  rounding.timefix_step = timefix_step(distinct);
  rounding.by_timefix = distinct.empty() ? 0 : 1;
  for (std::size_t i = 1; i < distinct.size(); ++i) {
    rounding.by_timefix += distinct[i] - distinct[i - 1] > rounding.timefix_step ? 1U : 0U;
  }
  return rounding;
}

void fall_to(const std::vector<double>& kept, std::vector<double>& times) {
  for (double& time : times) {
    time = *(std::upper_bound(kept.begin(), kept.end(), time) - 1);
  }
}

}  // namespace

bool same_time(double other, double time) noexcept {
  const double size = std::abs(time);
  return std::abs(other - time) <=
         std::max(std::min(kStampRounding, kShare * size), kEpsilon * size);
}

TimeRounding round_times(SurvivalOutcome& outcome) {
  const std::vector<double> distinct = distinct_times(outcome);
  TimeRounding rounding = counts_of(distinct);
  std::vector<double> kept;
  kept.reserve(distinct.size());
  for (const double time : distinct) {
    const double step = kept.empty() ? 0.0 : time - kept.back();
    if (!kept.empty() && step <= rounding.timefix_step && same_time(kept.back(), time)) {
      rounding.merged_step = std::max(rounding.merged_step, step);
      rounding.merged_share = std::max(rounding.merged_share, step / std::abs(time));
    } else {
      kept.push_back(time);
    }
  }
  rounding.kept = kept.size();
  if (kept.size() < distinct.size()) {
    fall_to(kept, outcome.stop);
    fall_to(kept, outcome.start);
  }
  return rounding;
}

TimeRounding count_times(const SurvivalOutcome& outcome) {
  return counts_of(distinct_times(outcome));
}

}  // namespace tcert::statistics
