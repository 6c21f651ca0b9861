#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "datasets/corpus/figure_eight.hpp"
#include "datasets/corpus/micro_study.hpp"
#include "datasets/corpus/simulated_trial.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

TrialDesign design_of(std::uint64_t index, double effect = 1.0) {
  CorpusOptions options;
  options.effect = effect;
  return design_trial(options, index);
}

bool same_reading(const RayReading& a, const RayReading& b) {
  return a.value == b.value && a.fsr_n == b.fsr_n;
}

TEST(SimulateTrial, IsAFunctionOfItsDesign) {
  const SimulatedTrial a = simulate_trial(design_of(17));
  const SimulatedTrial b = simulate_trial(design_of(17));
  EXPECT_EQ(a.log.tactile.time_ns, b.log.tactile.time_ns);
  EXPECT_TRUE(std::equal(a.log.tactile.readings.begin(),
                         a.log.tactile.readings.end(),
                         b.log.tactile.readings.begin(),
                         same_reading));
  EXPECT_EQ(to_json(a.world), to_json(b.world));
}

// Whoever reads a null corpus up to the last metres before the wedge cannot tell the outcomes
// apart: the two logs are the same to the bit.
TEST(SimulateTrial, WithoutEffectTheLogTellsNothingBeforeTheWedge) {
  for (std::uint64_t index = 0; index < 12; ++index) {
    SCOPED_TRACE(index);
    TrialDesign design = design_of(index, 0.0);
    design.success = true;
    const SimulatedTrial success = simulate_trial(design);
    design.success = false;
    const SimulatedTrial failure = simulate_trial(design);
    double travelled = 0.0;
    std::size_t i = 0;
    while (travelled < 5.0) {
      ASSERT_EQ(success.log.pose.time_ns[i], failure.log.pose.time_ns[i]);
      ASSERT_EQ(success.log.pose.poses[i].position, failure.log.pose.poses[i].position);
      ASSERT_TRUE(
          same_reading(success.log.tactile.readings[3 * i], failure.log.tactile.readings[3 * i]));
      ASSERT_EQ(success.log.control.speed_cmd_mps[i], failure.log.control.speed_cmd_mps[i]);
      ++i;
      travelled += std::abs(success.log.control.speed_cmd_mps[i]) / 20.0;
    }
    EXPECT_GT(success.log.pose.time_ns[i], 15 * kSecond);
  }
}

TEST(SimulateTrial, ASuccessEndsStandingInGForASecond) {
  const SimulatedTrial trial = [] {
    std::uint64_t index = 0;
    while (!design_of(index).success) {
      ++index;
    }
    return simulate_trial(design_of(index));
  }();
  EXPECT_EQ(trial.row.end_reason, EndReason::goal);
  const auto& times = trial.log.pose.time_ns;
  const auto& poses = trial.log.pose.poses;
  const Point last = poses.back().position;
  for (std::size_t i = times.size(); i-- > 0 && times[i] > times.back() - kSecond;) {
    EXPECT_TRUE(contains(course_goal(), poses[i].position));
    EXPECT_LT(distance(poses[i].position, last), 0.01);
  }
  EXPECT_GT(static_cast<double>(times.back()) * 1e-9, *trial.row.time_s);
}

TEST(SimulateTrial, AFailureNeverReachesGAndLastsLongerThanTheEarlyWindow) {
  int failures = 0;
  for (const TrialDesign& design : design_block({}, 0)) {
    if (design.success || failures == 20) {
      continue;
    }
    ++failures;
    const SimulatedTrial trial = simulate_trial(design);
    EXPECT_TRUE(trial.row.end_reason == EndReason::wedged ||
                trial.row.end_reason == EndReason::collision ||
                trial.row.end_reason == EndReason::timeout);
    EXPECT_GT(*trial.row.time_s, 15.0);
    EXPECT_LE(*trial.row.time_s, 180.0);
    EXPECT_GT(*trial.row.distance_m, 5.0);
    for (const Pose& pose : trial.log.pose.poses) {
      EXPECT_FALSE(contains(course_goal(), pose.position));
    }
  }
  EXPECT_EQ(failures, 20);
}

TEST(SimulateTrial, NativeRatesAre83And50And20Hertz) {
  CorpusOptions options;
  options.native_rates = true;
  const SimulatedTrial trial = simulate_trial(design_trial(options, 3));
  const auto rate = [](const std::vector<std::int64_t>& times) {
    return static_cast<double>(times.size()) * 1e9 / static_cast<double>(times.back());
  };
  EXPECT_NEAR(rate(trial.log.tactile.time_ns), 83.0, 3.0);
  EXPECT_NEAR(rate(trial.log.control.time_ns), 50.0, 2.0);
  EXPECT_NEAR(rate(trial.log.pose.time_ns), 20.0, 1.0);
  for (const auto* times :
       {&trial.log.tactile.time_ns, &trial.log.control.time_ns, &trial.log.pose.time_ns}) {
    EXPECT_TRUE(std::is_sorted(times->begin(), times->end(), std::less_equal<>()));
    for (std::size_t i = 1; i < times->size(); ++i) {
      EXPECT_LT((*times)[i] - (*times)[i - 1], kSecond);
    }
  }
}

// A tentacle held at one clearance: the readings' spread is the white part, their mean the bias.
TEST(TentacleSensors, ReadClearanceWithinTheDeclaredNoise) {
  World world;
  world.bounds = {{-2.0, -2.0}, {40.0, 2.0}};
  world.obstacles = {Polygon{{{-2.0, 0.35}, {40.0, 0.35}, {40.0, 1.0}, {-2.0, 1.0}}}};
  const WallIndex walls(world, 0.7);
  TentacleSensors sensors(0.004, table::RandomStream(5, 1, 1));
  const Ray& left = corpus_robot().rays[0];
  std::vector<double> errors;
  int glitches = 0;
  constexpr int kSamples = 4000;
  for (int i = 0; i < kSamples; ++i) {
    const auto readings = sensors.read(walls, {{0.008 * i, 0.0}, 0.0}, 0.16);
    const double error = calibrated_clearance(left.calibration, readings[0].value) - 0.23;
    if (std::abs(error - 0.004) > 0.035) {
      ++glitches;
    } else {
      errors.push_back(error);
    }
    EXPECT_GT(readings[0].fsr_n, 0.5);
    EXPECT_LT(readings[1].fsr_n, 0.3);
  }
  double mean = 0.0;
  double square = 0.0;
  for (const double error : errors) {
    mean += error / static_cast<double>(errors.size());
    square += error * error / static_cast<double>(errors.size());
  }
  EXPECT_NEAR(mean, 0.004, 0.0015);
  const double sd = std::sqrt(square - mean * mean);
  EXPECT_GT(sd, 0.0045);
  EXPECT_LT(sd, 0.0085);
  EXPECT_NEAR(static_cast<double>(glitches) / kSamples, 0.005, 0.0035);
}

// A wall on the left for 2 m of way, which then is gone; on the right one that comes within reach
// by 3 mm, which is too little to touch, then by 5 mm, then by 1 mm, then not at all.
TEST(TentacleSensors, LetGoAtTheFirstSampleWithoutAWall) {
  const double reach = corpus_robot().rays[0].reach_m;
  const double mount_y = corpus_robot().rays[0].mount.y_m;
  const auto wall = [&](double from, double to, double clearance) {
    const double y = -(mount_y + clearance);
    return Polygon{{{from, y - 1.0}, {to, y - 1.0}, {to, y}, {from, y}}};
  };
  World world;
  world.bounds = {{-2.0, -4.0}, {8.0, 4.0}};
  world.obstacles = {Polygon{{{-1.0, 0.4}, {2.0, 0.4}, {2.0, 2.0}, {-1.0, 2.0}}},
                     wall(-1.0, 1.0, reach - 0.003),
                     wall(1.0, 2.0, reach - 0.005),
                     wall(2.0, 3.0, reach - 0.001)};
  const WallIndex walls(world, 0.7);
  TentacleSensors sensors(0.0, table::RandomStream(6, 1, 1));
  constexpr double kAhead = 0.16;  // of both mounts
  constexpr double kStep = 0.008;
  for (int i = 0; i < 600; ++i) {
    const double x = kStep * (i + 0.5);
    SCOPED_TRACE(x);
    const auto readings = sensors.read(walls, {{x - kAhead, 0.0}, 0.0}, 0.16);
    EXPECT_EQ(readings[0].fsr_n > 0.3, x < 2.0);
    EXPECT_EQ(readings[1].fsr_n > 0.3, x > 1.0 && x < 3.0);
    EXPECT_LT(readings[2].fsr_n, 0.3);
  }
}

TEST(SimulateGatePass, HoldsTwelvePassesOfEachGateHalfFromEachSide) {
  std::map<std::string, std::pair<int, int>> sides;
  int widest = 0;
  int narrowest = 0;
  for (std::uint64_t index = 0; index < kGatePasses; ++index) {
    const SimulatedTrial pass = simulate_gate_pass(1, index);
    auto& [left, right] = sides[pass.row.extra[1]];
    (pass.row.extra[2] == "left" ? left : right) += 1;
    widest += pass.row.extra[1] == "0.4800" && *pass.row.success ? 1 : 0;
    narrowest += pass.row.extra[1] == "0.4200" && *pass.row.success ? 1 : 0;
  }
  ASSERT_EQ(sides.size(), 5U);
  for (const auto& [width, counts] : sides) {
    EXPECT_EQ(counts, (std::pair{6, 6})) << width;
  }
  EXPECT_GE(widest, 9);
  EXPECT_LE(narrowest, 3);
}

}  // namespace
}  // namespace tcert
