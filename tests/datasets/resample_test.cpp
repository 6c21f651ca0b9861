#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "datasets/trial_reader.hpp"

namespace tcert {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Pose x = time in seconds, every `pose_ms`; one ray whose value is the sample's index.
TrialLog steady_log(std::int64_t pose_ms, std::int64_t tactile_ms, std::int64_t end_ms) {
  TrialLog log;
  for (std::int64_t t = 0; t <= end_ms; t += pose_ms) {
    log.pose.time_ns.push_back(t * kMs);
    log.pose.poses.push_back({{static_cast<double>(t) / 1000.0, 0.0}, 0.0});
  }
  log.tactile.rays = 1;
  for (std::int64_t t = 0; t <= end_ms; t += tactile_ms) {
    log.tactile.readings.push_back({static_cast<double>(log.tactile.time_ns.size()), kMissing});
    log.tactile.time_ns.push_back(t * kMs);
  }
  return log;
}

TEST(Resample, PutsTicksOnTheGridFromTheFirstCommonInstantToTheFirstEnd) {
  TrialLog log = steady_log(20, 12, 1000);
  for (std::int64_t& t : log.tactile.time_ns) {
    t += 37 * kMs + 1;
  }
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.size(), 10U);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    EXPECT_EQ(ticks.time_ns[k], 37 * kMs + 1 + static_cast<std::int64_t>(k) * 100 * kMs);
  }
}

TEST(Resample, HoldsPoseAndCommandFromTheNewestSample) {
  TrialLog log = steady_log(30, 10, 200);
  log.control.time_ns = {50 * kMs, 200 * kMs};
  log.control.speed_cmd_mps = {0.1, 0.2};
  log.control.yaw_rate_cmd_rps = {1.0, 2.0};
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.size(), 2U);  // the pose ends at 180 ms
  EXPECT_EQ(ticks.poses[1].position.x_m, 0.09);
  EXPECT_TRUE(std::isnan(ticks.speed_cmd_mps[0]));
  EXPECT_EQ(ticks.speed_cmd_mps[1], 0.1);
  EXPECT_EQ(ticks.yaw_rate_cmd_rps[1], 1.0);
}

TEST(Resample, TakesTheMedianOfTheThreeNewestSamplesAtOrBeforeTheTick) {
  TrialLog log = steady_log(50, 50, 200);
  log.tactile.readings = {{5, 1}, {1, kMissing}, {9, 3}, {2, kMissing}, {7, kMissing}};
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_EQ(ticks.readings[0].value, 5.0);  // {5}
  EXPECT_EQ(ticks.readings[1].value, 5.0);  // {5, 1, 9}
  EXPECT_EQ(ticks.readings[2].value, 7.0);  // {9, 2, 7}
  EXPECT_EQ(ticks.readings[1].fsr_n, 2.0);  // {1, missing, 3}: the mean of two
  EXPECT_EQ(ticks.readings[2].fsr_n, 2.0);  // the same: further samples are missing
}

/// What a joint's ray felt stays with where it pointed: nothing is a mean of two directions.
TEST(Resample, TakesTheBearingOfTheSampleThatIsTheMedian) {
  TrialLog log = steady_log(50, 50, 200);
  log.tactile.readings = {{5, 1, 0.5}, {1, 1, 0.1}, {9, 1, 0.9}, {kMissing, 1, 0.2}, {7, 1, 0.7}};
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_EQ(ticks.readings[1].value, 5.0);  // {5, 1, 9}
  EXPECT_EQ(ticks.readings[1].bearing_rad, 0.5);
  EXPECT_EQ(ticks.readings[2].value, 7.0);  // {1, 9, 7}
  EXPECT_EQ(ticks.readings[2].bearing_rad, 0.7);
  log.tactile.readings = {{5, 1, 0.5}, {kMissing}, {9, 1, 0.9}, {kMissing}, {kMissing}};
  EXPECT_EQ(resample(log).readings[1].value, 9.0);  // {5, 9}
  EXPECT_EQ(resample(log).readings[1].bearing_rad, 0.9);
}

/// A joint's ray that sees nothing states its reach in every direction: of equal values the newer
/// one comes first, whatever is sorted in before it.
TEST(Resample, KeepsEqualValuesInTheOrderOfTheirAge) {
  TrialLog log = steady_log(50, 50, 200);
  log.tactile.readings = {{1, 1, 0.1}, {5, 1, 0.9}, {5, 1, 0.7}, {5, 1, 0.3}, {1, 1, 0.2}};
  const TickTable ticks = resample(log);
  EXPECT_EQ(ticks.readings[1].bearing_rad, 0.7);  // {5, 5, 1}
  EXPECT_EQ(ticks.readings[2].bearing_rad, 0.3);  // {1, 5, 5}
}

TEST(Resample, CallsATickStaleWhenTheNewestSampleIsOlderThanTheHold) {
  TrialLog log = steady_log(100, 100, 2000);
  const auto drop = [](std::int64_t t) { return t > 500 * kMs && t < 1300 * kMs; };
  PoseStream pose;
  for (std::size_t i = 0; i < log.pose.time_ns.size(); ++i) {
    if (!drop(log.pose.time_ns[i])) {
      pose.time_ns.push_back(log.pose.time_ns[i]);
      pose.poses.push_back(log.pose.poses[i]);
    }
  }
  log.pose = pose;
  const TickTable ticks = resample(log);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    EXPECT_EQ(ticks.stale[k] != 0, k == 11 || k == 12) << k;  // 1.0 s is exactly the hold
  }
}

TEST(Resample, StartsASegmentAtTheFirstTickAtOrAfterABreak) {
  TrialLog log = steady_log(20, 20, 1000);
  log.breaks_ns = {300 * kMs, 420 * kMs, 480 * kMs, 2000 * kMs};
  const TickTable ticks = resample(log);
  std::vector<std::size_t> starts;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    if (ticks.segment_start[k] != 0) {
      starts.push_back(k);
    }
  }
  EXPECT_EQ(starts, (std::vector<std::size_t>{3, 5}));
}

TEST(Resample, DoesNotMixSamplesFromBeforeABreakIntoTheMedian) {
  TrialLog log = steady_log(100, 100, 200);
  log.tactile.time_ns = {0, 100 * kMs, 2000 * kMs};
  log.tactile.readings = {{1, kMissing}, {2, kMissing}, {9, kMissing}};
  log.pose.time_ns = {0, 100 * kMs, 2000 * kMs};
  log.breaks_ns = {2000 * kMs};
  const TickTable ticks = resample(log);
  ASSERT_EQ(ticks.size(), 21U);
  EXPECT_EQ(ticks.readings[19].value, 1.5);
  EXPECT_EQ(ticks.readings[20].value, 9.0);
}

TEST(Resample, SkipsASilenceThatAWrongClockMakes) {
  TrialLog log = steady_log(100, 100, 1000);
  constexpr std::int64_t kFar = 3'000'000'000'000'000'000 + 50 * kMs;
  for (auto* times : {&log.pose.time_ns, &log.tactile.time_ns}) {
    times->push_back(kFar);
    times->push_back(kFar + 100 * kMs);
  }
  log.pose.poses.resize(13);
  log.tactile.readings.resize(13, {1.0, kMissing});
  log.breaks_ns = {kFar};
  const TickTable ticks = resample(log);
  EXPECT_LT(ticks.size(), 700U);
  EXPECT_EQ(ticks.time_ns.back(), kFar + 50 * kMs);
  EXPECT_EQ(ticks.segment_start.back(), 1);
  EXPECT_EQ(ticks.stale.back(), 0);
  for (const std::int64_t t : ticks.time_ns) {
    ASSERT_EQ(t % (100 * kMs), 0);
  }
}

/// Each tick from its definition, by looking at all samples.
TickTable resample_by_definition(TrialLog log) {
  for (std::size_t i = log.tactile.time_ns.size(); i-- > 0;) {
    const auto first = log.tactile.readings.begin() + static_cast<std::ptrdiff_t>(2 * i);
    if (std::isnan(first[0].value) && std::isnan(first[1].value)) {
      log.tactile.time_ns.erase(log.tactile.time_ns.begin() + static_cast<std::ptrdiff_t>(i));
      log.tactile.readings.erase(first, first + 2);
    }
  }
  TickTable ticks;
  ticks.rays = log.tactile.rays;
  const auto& pose = log.pose.time_ns;
  const auto& touch = log.tactile.time_ns;
  const auto newest = [](const std::vector<std::int64_t>& times, std::int64_t t) {
    return static_cast<std::size_t>(std::ranges::upper_bound(times, t) - times.begin()) - 1;
  };
  std::int64_t previous = -1;
  for (std::int64_t t = std::max(pose[0], touch[0]); t <= std::min(pose.back(), touch.back());
       t += 100 * kMs) {
    const std::size_t p = newest(pose, t);
    const std::size_t s = newest(touch, t);
    const auto broke =
        std::ranges::any_of(log.breaks_ns, [&](std::int64_t b) { return b <= t && b > previous; });
    std::int64_t last_break = INT64_MIN;
    for (const std::int64_t b : log.breaks_ns) {
      last_break = b <= t ? std::max(last_break, b) : last_break;
    }
    ticks.time_ns.push_back(t);
    ticks.poses.push_back(log.pose.poses[p]);
    ticks.stale.push_back(t - pose[p] > 500 * kMs || t - touch[s] > 500 * kMs ? 1 : 0);
    ticks.segment_start.push_back(broke ? 1 : 0);
    for (std::size_t k = 0; k < ticks.rays; ++k) {
      std::vector<double> values;
      for (std::size_t i = s + 1; i-- > 0 && values.size() < 3;) {
        const double value = log.tactile.readings[i * ticks.rays + k].value;
        const bool recent = i + 3 > s || t - touch[i] <= 500 * kMs;
        if (recent && (i == s || touch[i] >= last_break) && !std::isnan(value)) {
          values.push_back(value);
        }
      }
      std::ranges::sort(values);
      const std::size_t n = values.size();
      ticks.readings.push_back(
          {n == 0 ? kMissing : 0.5 * (values[(n - 1) / 2] + values[n / 2]), kMissing});
    }
    previous = t;
  }
  return ticks;
}

TEST(Resample, GivesWhatTheDefinitionSaysOnRandomStreams) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    TrialLog log;
    log.tactile.rays = 2;
    std::int64_t t = static_cast<std::int64_t>(random() % 1000) * kMs;
    for (int i = 0; i < 60; ++i) {
      t += 1 + static_cast<std::int64_t>(random() % (random() % 8 == 0 ? 1500 : 90)) * kMs;
      log.pose.time_ns.push_back(t);
      log.pose.poses.push_back({{static_cast<double>(i), 0.0}, 0.0});
      if (random() % 10 == 0) {
        log.breaks_ns.push_back(t);
      }
    }
    t = static_cast<std::int64_t>(random() % 1000) * kMs;
    for (int i = 0; i < 90; ++i) {
      t += 1 + static_cast<std::int64_t>(random() % (random() % 9 == 0 ? 1200 : 40)) * kMs;
      log.tactile.time_ns.push_back(t);
      for (int k = 0; k < 2; ++k) {
        const double value = random() % 5 == 0 ? kMissing : static_cast<double>(random() % 100);
        log.tactile.readings.push_back({value, kMissing});
      }
    }
    const TickTable fast = resample(log);
    const TickTable slow = resample_by_definition(log);
    ASSERT_EQ(fast.time_ns, slow.time_ns);
    EXPECT_EQ(fast.stale, slow.stale);
    EXPECT_EQ(fast.segment_start, slow.segment_start);
    for (std::size_t i = 0; i < fast.readings.size(); ++i) {
      const double a = fast.readings[i].value;
      const double b = slow.readings[i].value;
      ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << i << ": " << a << " " << b;
    }
  }
}

TEST(Resample, TakesASampleWithoutAnyReadingForNone) {
  TrialLog log = steady_log(100, 100, 3000);
  TrialLog without = log;
  without.tactile.time_ns.clear();
  without.tactile.readings.clear();
  for (std::size_t i = 0; i < log.tactile.time_ns.size(); ++i) {
    if (i < 3 || (i > 8 && i < 20) || i % 5 == 0) {
      log.tactile.readings[i] = {kMissing, kMissing};
    } else {
      without.tactile.time_ns.push_back(log.tactile.time_ns[i]);
      without.tactile.readings.push_back(log.tactile.readings[i]);
    }
  }
  const TickTable ticks = resample(log);
  const TickTable expected = resample(without);
  EXPECT_EQ(ticks.time_ns, expected.time_ns);
  EXPECT_EQ(ticks.time_ns.front(), 300 * kMs);
  EXPECT_EQ(ticks.stale, expected.stale);
  EXPECT_EQ(std::ranges::count(ticks.stale, 1), 7);  // 1.4 to 2.0 s: the last reading is of 0.8 s
  log.tactile.readings[9].fsr_n = 0.2;               // a force alone is a reading
  EXPECT_LT(std::ranges::count(resample(log).stale, 1), 7);
}

TEST(Resample, StartsWithThePoseIfTheLogSaysSo) {
  TrialLog log = steady_log(100, 100, 2000);
  log.tactile.time_ns.erase(log.tactile.time_ns.begin(), log.tactile.time_ns.begin() + 8);
  log.tactile.readings.erase(log.tactile.readings.begin(), log.tactile.readings.begin() + 8);
  EXPECT_EQ(resample(log).time_ns.front(), 800 * kMs);
  log.starts_with_pose = true;
  const TickTable ticks = resample(log);
  EXPECT_EQ(ticks.time_ns.front(), 0);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    EXPECT_EQ(ticks.stale[k], k < 8 ? 1 : 0) << k;
    EXPECT_EQ(std::isnan(ticks.readings[k].value), k < 8) << k;
  }
}

TEST(Resample, RefusesOptionsOutOfRange) {
  const TrialLog log = steady_log(100, 100, 1000);
  EXPECT_THROW(static_cast<void>(resample(log, {0.0, 0.5, 3})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(resample(log, {0.1, 0.0, 3})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(resample(log, {0.1, 0.5, 2})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(resample(log, {0.1, 0.5, 11})), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
