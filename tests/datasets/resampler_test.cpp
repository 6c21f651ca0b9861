#include "datasets/resampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <table/random.hpp>

namespace tcert {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Streams with jitter, silences and missing readings.
TrialLog uneven_log(std::uint64_t index) {
  table::RandomStream random(1, 0x7465'0010, index);
  TrialLog log;
  log.tactile.rays = 2;
  const auto next = [&](std::int64_t time, double period_s) {
    const double silence = random.below(40) == 0 ? random.uniform(0.2, 1.5) : 0.0;
    return time + std::llround(1e9 * (period_s * random.uniform(0.5, 1.5) + silence));
  };
  for (std::int64_t t = 5'000'000; t < 12'000'000'000; t = next(t, 0.05)) {
    log.pose.time_ns.push_back(t);
    log.pose.poses.push_back({{random.normal(), random.normal()}, random.normal()});
  }
  for (std::int64_t t = 2'000'000; t < 12'000'000'000; t = next(t, 0.012)) {
    log.tactile.time_ns.push_back(t);
    log.tactile.readings.push_back({random.normal(), random.normal()});
    log.tactile.readings.push_back({random.below(3) == 0 ? kMissing : random.normal(), kMissing});
  }
  log.breaks_ns = {4'000'000'000, 7'123'000'000};
  return log;
}

// Samples are handed over only when their time has come, as while a robot logs them.
TEST(Resampler, MakesTheTicksOfAWholeLogWhileItGrows) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    const TrialLog whole = uneven_log(index);
    const TickTable expected = resample(whole);
    ASSERT_GT(expected.size(), 100U);
    TrialLog growing;
    growing.tactile.rays = whole.tactile.rays;
    growing.breaks_ns = whole.breaks_ns;
    Resampler resampler(growing, ResampleOptions{});
    std::size_t pose = 0;
    std::size_t touch = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const std::int64_t now = expected.time_ns[k];
      for (; pose < whole.pose.time_ns.size() && whole.pose.time_ns[pose] <= now; ++pose) {
        growing.pose.time_ns.push_back(whole.pose.time_ns[pose]);
        growing.pose.poses.push_back(whole.pose.poses[pose]);
      }
      for (; touch < whole.tactile.time_ns.size() && whole.tactile.time_ns[touch] <= now; ++touch) {
        growing.tactile.time_ns.push_back(whole.tactile.time_ns[touch]);
        growing.tactile.readings.push_back(whole.tactile.readings[2 * touch]);
        growing.tactile.readings.push_back(whole.tactile.readings[2 * touch + 1]);
      }
      const Tick tick = resampler.add_tick(now);
      ASSERT_EQ(tick.pose.position, expected.poses[k].position);
      ASSERT_EQ(tick.stale ? 1 : 0, expected.stale[k]);
      ASSERT_EQ(tick.segment_start ? 1 : 0, expected.segment_start[k]);
      for (std::size_t r = 0; r < 2; ++r) {
        ASSERT_TRUE(same(tick.rays[r].value, expected.readings[2 * k + r].value)) << k;
        ASSERT_TRUE(same(tick.rays[r].fsr_n, expected.readings[2 * k + r].fsr_n)) << k;
      }
    }
  }
}

/// Ticks looked up in all samples anew at each instant.
TickTable slow_ticks(const TrialLog& log, const ResampleOptions& options) {
  TickTable ticks;
  ticks.rays = log.tactile.rays;
  const auto there = [](const std::vector<std::int64_t>& arrival_ns, std::int64_t now) {
    std::vector<std::size_t> samples;
    for (std::size_t i = 0; i < arrival_ns.size(); ++i) {
      if (arrival_ns[i] <= now) {
        samples.push_back(i);
      }
    }
    return samples;
  };
  const auto median = [](std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    return n == 0       ? kMissing
           : n % 2 == 1 ? values[n / 2]
                        : 0.5 * (values[n / 2 - 1] + values[n / 2]);
  };
  const std::int64_t hold = std::llround(1e9 * options.max_hold_s);
  const std::int64_t first = std::max(log.pose.time_ns.front(), log.tactile.time_ns.front());
  const std::int64_t last = std::min(log.pose.time_ns.back(), log.tactile.time_ns.back());
  std::int64_t before = INT64_MIN;
  for (std::int64_t now = first; now <= last; now += 100'000'000) {
    const auto poses = there(log.pose.arrival_ns, now);
    const auto touches = there(log.tactile.arrival_ns, now);
    if (poses.empty() || touches.empty()) {
      continue;
    }
    std::int64_t begin = INT64_MIN;
    bool breaks = false;
    for (const std::int64_t one : log.breaks_ns) {
      begin = one <= now ? one : begin;
      breaks = breaks || (one > before && one <= now);
    }
    before = now;
    ticks.time_ns.push_back(now);
    ticks.poses.push_back(log.pose.poses[poses.back()]);
    const bool stale = now - log.pose.time_ns[poses.back()] > hold ||
                       now - log.tactile.time_ns[touches.back()] > hold;
    ticks.stale.push_back(stale ? 1 : 0);
    ticks.segment_start.push_back(breaks ? 1 : 0);
    for (std::size_t k = 0; k < ticks.rays; ++k) {
      std::vector<double> values;
      for (std::size_t back = 0; back < touches.size(); ++back) {
        const std::size_t sample = touches[touches.size() - 1 - back];
        const std::int64_t made = log.tactile.time_ns[sample];
        const bool is_newest = back == 0;
        const bool counts = back < 3 || now - made <= hold;
        const double value = log.tactile.readings[sample * ticks.rays + k].value;
        if (counts && (made >= begin || is_newest) && values.size() < 3 && !std::isnan(value)) {
          values.push_back(value);
        }
      }
      ticks.readings.push_back({median(values), kMissing});
    }
  }
  return ticks;
}

/// Jitter that puts samples out of order, and bursts in which all of some time come at once.
void delay(TrialLog& log, std::uint64_t index) {
  table::RandomStream random(1, 0x7465'0011, index);
  const auto arrivals = [&](const std::vector<std::int64_t>& time_ns) {
    std::vector<std::int64_t> arrival_ns;
    std::int64_t held_until = INT64_MIN;
    for (const std::int64_t time : time_ns) {
      if (time > held_until && random.below(300) == 0) {
        held_until = time + std::llround(1e9 * random.uniform(0.1, 2.0));
      }
      arrival_ns.push_back(std::max(held_until, time) + random.below(50'000'000));
    }
    return arrival_ns;
  };
  log.pose.arrival_ns = arrivals(log.pose.time_ns);
  log.tactile.arrival_ns = arrivals(log.tactile.time_ns);
}

void expect_same_ticks(const TickTable& a, const TickTable& b) {
  ASSERT_EQ(a.time_ns, b.time_ns);
  ASSERT_EQ(a.stale, b.stale);
  ASSERT_EQ(a.segment_start, b.segment_start);
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a.poses[k].position, b.poses[k].position);
    for (std::size_t r = 0; r < a.rays; ++r) {
      ASSERT_TRUE(same(a.readings[a.rays * k + r].value, b.readings[a.rays * k + r].value)) << k;
    }
  }
}

TEST(Resampler, SeesWhatHasArrivedAsASlowLookUpDoes) {
  std::size_t stale = 0;
  std::size_t ticks = 0;
  for (std::uint64_t index = 0; index < 40; ++index) {
    TrialLog log = uneven_log(index);
    delay(log, index);
    const TickTable fast = resample(log);
    expect_same_ticks(fast, slow_ticks(log, {}));
    ticks += fast.size();
    stale += static_cast<std::size_t>(std::ranges::count(fast.stale, 1));
  }
  EXPECT_GT(stale, ticks / 20);
  EXPECT_LT(stale, ticks / 2);
}

TEST(Resampler, GivesTheSameBitsIfAllSamplesArriveAtOnce) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    TrialLog log = uneven_log(index);
    const TickTable expected = resample(log);
    log.pose.arrival_ns = log.pose.time_ns;
    log.tactile.arrival_ns = log.tactile.time_ns;
    expect_same_ticks(resample(log), expected);
    expect_same_ticks(slow_ticks(log, {}), expected);
  }
}

// A burst of 1.2 s: the touch is old from 0.5 s on, and fresh when the burst is over.
TEST(Resampler, MakesTicksStaleWhileTheNewestSampleThatIsThereIsOld) {
  TrialLog log;
  log.tactile.rays = 1;
  for (std::int64_t t = 0; t <= 4'000'000'000; t += 50'000'000) {
    const bool is_late = t > 1'000'000'000 && t < 2'200'000'000;
    log.pose.time_ns.push_back(t);
    log.pose.poses.push_back({{1e-9 * static_cast<double>(t), 0.0}, 0.0});
    log.tactile.time_ns.push_back(t);
    log.tactile.readings.push_back({1e-9 * static_cast<double>(t), kMissing});
    log.tactile.arrival_ns.push_back(is_late ? 2'200'000'000 : t);
  }
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.size(), 41U);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    EXPECT_EQ(ticks.stale[k], k > 15 && k < 22 ? 1 : 0) << k;
    const double newest = k > 10 && k < 22 ? 1.0 : 0.1 * static_cast<double>(k);
    EXPECT_NEAR(ticks.readings[k].value, k == 0 ? 0.0 : newest - 0.05, 1e-9) << k;
    EXPECT_NEAR(ticks.poses[k].position.x_m, 0.1 * static_cast<double>(k), 1e-9);
  }
}

}  // namespace
}  // namespace tcert
