#include "datasets/resampler.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tcert
