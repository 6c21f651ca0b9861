// What a stranger would expect of driven logs, before looking: each bound is reasoned from the
// robot and the sensors, not read off the logs.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "datasets/driven/watched.hpp"
#include "support/correlation.hpp"

namespace tcert {
namespace {

using namespace driven_test;

// Free tips read their noise, 0.03 N; a touching one rubs with 0.58 N at least, and at 0.3 m/s with
// 9 (0.3 - 0.04) N. Bends are within the calibration, give or take a noise of 8 mm.
TEST(DrivenLogs, HaveTheUnitsAndRangesOfTheirSensors) {
  for (const Watched& trial : study()) {
    const TrialLog& log = trial.driven.trial.log;
    for (const RayReading& reading : log.tactile.readings) {
      ASSERT_GE(reading.fsr_n, 0.0);
      ASSERT_TRUE(reading.fsr_n < 0.2 || reading.fsr_n > 0.4) << reading.fsr_n;
      ASSERT_LT(reading.fsr_n, 9.0 * 0.26 + 0.2);
      ASSERT_GT(reading.value, -0.15);
      ASSERT_LT(reading.value, 1.35);
    }
    for (std::size_t i = 0; i < log.control.time_ns.size(); ++i) {
      ASSERT_LE(std::abs(log.control.speed_cmd_mps[i]), 0.3);
      ASSERT_GT(log.control.loop_latency_ms[i], 15.0);
      ASSERT_LT(log.control.loop_latency_ms[i], 25.0);
    }
    const TrialRow& row = trial.driven.trial.row;
    EXPECT_GT(*row.time_s, 1.0);
    EXPECT_LE(*row.time_s, 60.0);
    EXPECT_LE(*row.distance_m, 0.3 * *row.time_s);
    EXPECT_EQ(row.extra.size(), driven_extra_columns().size());
    EXPECT_NE(row.end_reason, EndReason::unknown);
  }
}

TEST(DrivenLogs, HaveTheirRates) {
  const auto rate = [](const std::vector<std::int64_t>& times) {
    return static_cast<double>(times.size() - 1) * 1e9 /
           static_cast<double>(times.back() - times.front());
  };
  for (const Watched& trial : study()) {
    const TrialLog& log = trial.driven.trial.log;
    EXPECT_NEAR(rate(log.control.time_ns), 50.0, 0.01);
    for (const auto* times : {&log.tactile.time_ns, &log.pose.time_ns, &log.control.time_ns}) {
      EXPECT_TRUE(std::is_sorted(times->begin(), times->end(), std::less_equal<>()));
    }
    EXPECT_LT(rate(log.tactile.time_ns), 84.0);
    EXPECT_GT(rate(log.tactile.time_ns), 70.0);  // silences of up to 0.7 s
    EXPECT_LT(rate(log.pose.time_ns), 20.3);
    EXPECT_GT(rate(log.pose.time_ns), 17.0);
  }
}

// The frontal tentacle is free (bend 0, noise below 0.05 rad) where nothing is within its reach;
// a glitch is uniform over 0 to 1.2 rad, so above 0.2 rad in 0.005 / 1.2. It goes neither with
// how tight the world is nor with the speed.
TEST(DrivenLogs, HaveTheGlitchesOfTheCorpusAndNoneThatTellsAnything) {
  std::array<double, 2> free_samples{};
  std::array<double, 2> glitches{};
  std::array<double, 2> free_fast{};
  std::array<double, 2> glitches_fast{};
  for (const Watched& trial : study()) {
    const TactileStream& tactile = trial.driven.trial.log.tactile;
    const std::size_t tight = *trial.design.world.margin_m < 0.03 ? 1 : 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < tactile.time_ns.size(); ++i) {
      const RayReading& front = tactile.readings[i * kTentacles + 2];
      if (front.fsr_n >= kContactOff) {
        continue;
      }
      while (at + 1 < trial.track.size() && trial.track[at].time_ns < tactile.time_ns[i]) {
        ++at;
      }
      const std::size_t fast = trial.track[at].speed_mps > 0.15 ? 1 : 0;
      // A wall 4 mm within reach is not touched yet, and bends by 0.012 rad at most.
      const double glitch = front.value > 0.2 ? 1.0 : 0.0;
      free_samples[tight] += 1.0;
      glitches[tight] += glitch;
      free_fast[fast] += 1.0;
      glitches_fast[fast] += glitch;
    }
  }
  constexpr double kShare = 0.005 / 1.2;
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_GT(free_samples[i], 5000.0);
    EXPECT_NEAR(glitches[i], kShare * free_samples[i], 4.0 * std::sqrt(kShare * free_samples[i]));
    EXPECT_NEAR(glitches_fast[i], kShare * free_fast[i], 4.0 * std::sqrt(kShare * free_fast[i]));
  }
}

// What is drawn of a trial apart from its gates says nothing of them, nor of one another: how weak
// the body is, how slow the loop, how far off the tentacles are that day, when samples are lost.
// Each trial here is one of a day of its own, and over after a second.
TEST(DrivenLogs, HaveNoDrawThatTellsOfAnother) {
  constexpr std::uint64_t kTrials = 2000;
  DriveParameters parameters;
  parameters.time_limit_s = 1.0;
  parameters.choice = WorldChoice::any;
  const std::array names{"margin", "crash force", "bias", "latency", "samples", "first gate"};
  std::array<std::vector<double>, names.size()> drawn;
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    DrivenDesign design = design_driven(parameters, 21, kTrialsPerDay * i);
    design.native_rates = true;
    const DrivenTrial trial = drive_trial(design, Steady{0.05, 0.0});
    const std::vector<double>& latencies = trial.trial.log.control.loop_latency_ms;
    drawn[0].push_back(*design.world.margin_m);
    drawn[1].push_back(std::log(trial.events.crash_force_n));
    drawn[2].push_back(design.world.calibration_bias_m);
    drawn[3].push_back(std::accumulate(latencies.begin(), latencies.end(), 0.0) /
                       static_cast<double>(latencies.size()));
    drawn[4].push_back(static_cast<double>(trial.trial.log.tactile.time_ns.size()));
    drawn[5].push_back(design.world.gate_margins_m.front());
  }
  const double most = 4.0 / std::sqrt(static_cast<double>(kTrials));
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a + 1; b < names.size(); ++b) {
      if (a == 0 && b == 5) {
        EXPECT_GT(test_support::correlation(drawn[a], drawn[b]), most)
            << "a gate is part of the way";
      } else {
        EXPECT_LT(std::abs(test_support::correlation(drawn[a], drawn[b])), most)
            << names[a] << ", " << names[b];
      }
    }
  }
}

// A contact of the body stops it or slows it; a trial without one has no force, no bump, no time
// above, and one with it has all that goes with it.
TEST(DrivenEvents, AgreeWithOneAnother) {
  std::size_t with_contact = 0;
  for (const Watched& trial : study()) {
    const DrivenEvents& events = trial.driven.events;
    EXPECT_EQ(events.bumps == 0, events.peak_force_n == 0.0);
    EXPECT_EQ(events.bumps == 0, trial.bumps_given == 0);
    EXPECT_TRUE(events.recoveries == 0 || events.bumps > 0);
    EXPECT_LE(events.peak_force_n, 300.0 * 0.2 + 15.0 + 1e-9);  // commanded 0.2 m/s at most
    EXPECT_EQ(events.time_above_s > 0.0, events.peak_force_n > 40.0);
    with_contact += events.bumps > 0 ? 1 : 0;
  }
  EXPECT_GT(with_contact, 10U);
}

}  // namespace
}  // namespace tcert
