#include "datasets/values/check_rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "datasets/corpus/micro_study.hpp"
#include "datasets/corpus/simulated_trial.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/travelled_way.hpp"

namespace tcert {
namespace {

constexpr std::size_t kLeft = 0;
constexpr std::size_t kRight = 1;
constexpr std::size_t kFront = 2;

std::vector<std::string> warnings(const TickTable& ticks, const Robot& robot = corpus_robot()) {
  std::vector<std::string> found;
  const std::vector<double> way_m = travelled_way(ticks);
  for (ValueFinding& finding : check_rays(robot, {}, ticks, scan_rays(ticks, way_m))) {
    EXPECT_EQ(finding.diagnostic.severity, table::Severity::warning);
    finding.diagnostic.file = "logs/t";
    found.push_back(table::to_string(finding.diagnostic));
  }
  return found;
}

/// Ticks of a trial of the corpus.
TickTable felt_in(std::uint64_t index, std::uint64_t seed = 1) {
  CorpusOptions options;
  options.seed = seed;
  return resample(simulate_trial(design_trial(options, index)).log);
}

/// Straight on at 0.1 m/s, 10 ticks a second; `bend` and `force` of the left ray at each tick. The
/// others sway a little, as free tentacles do.
template <class Bend, class Force>
TickTable run(std::size_t size, Bend bend, Force force) {
  TickTable ticks;
  ticks.rays = 3;
  for (std::size_t i = 0; i < size; ++i) {
    const double sway = 0.01 * std::abs(std::sin(0.7 * static_cast<double>(i)));
    ticks.time_ns.push_back(static_cast<std::int64_t>(i) * 100'000'000);
    ticks.poses.push_back({{0.01 * static_cast<double>(i), 0.0}, 0.0});
    ticks.readings.insert(
        ticks.readings.end(),
        {{bend(i), force(i)}, {1.5 * sway, 0.0}, {i % 9 == 0 ? kMissing : sway, kMissing}});
  }
  ticks.stale.assign(size, 0);
  ticks.segment_start.assign(size, 0);
  return ticks;
}

double swaying(std::size_t i) { return 0.005 * std::abs(std::sin(static_cast<double>(i))); }

TEST(CheckRays, HaveNothingToSayOfTheCorpus) {
  for (const std::uint64_t seed : {1U, 2U, 7U}) {
    for (std::uint64_t index = 0; index < 660; index += 5) {
      EXPECT_EQ(warnings(felt_in(index, seed)), std::vector<std::string>{}) << seed << ' ' << index;
    }
  }
  for (std::uint64_t index = 0; index < kGatePasses; ++index) {
    EXPECT_EQ(warnings(resample(simulate_gate_pass(1, index).log)), std::vector<std::string>{});
  }
}

// Bend and force of a robot that touches once, from 2 to 4 s, and whose force sensor then hangs.
TEST(CheckRays, NameAContactThatOutlivesItsWall) {
  const auto bend = [](std::size_t i) { return i >= 20 && i < 40 ? 0.6 : swaying(i); };
  const auto held = [](std::size_t i) { return i >= 20 ? 0.7 : 0.02; };
  EXPECT_EQ(warnings(run(400, bend, held)),
            (std::vector<std::string>{
                "logs/t: warning: column 'left_fsr_n': found 'contact from 2.0 s to the end at "
                "39.9 s', expected a contact that ends when its wall is gone: 95 % of the readings "
                "since then are free, over 3.6 m of way; check the zero of the force sensor, raise "
                "contact_off_n, or leave the column out"}));
  const auto released = [](std::size_t i) { return i >= 20 && i < 40 ? 0.7 : 0.02; };
  EXPECT_TRUE(warnings(run(400, bend, released)).empty());
  const auto released_at_last = [](std::size_t i) { return i >= 20 && i < 399 ? 0.7 : 0.02; };
  EXPECT_TRUE(warnings(run(400, bend, released_at_last)).empty());
}

TEST(CheckRays, NameAContactThatWasThereFromTheStart) {
  TickTable ticks = felt_in(3);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ticks.readings[3 * i + kRight].fsr_n = 1.0;
  }
  const auto found = warnings(ticks);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("column 'right_fsr_n': found 'contact from 0.0 s to the end"),
            std::string::npos);
}

// Along a wall, or held in a gate, contact to the end is right: the ray reads the wall.
TEST(CheckRays, LeaveALongContactAloneWhereTheRayReadsAWall) {
  const auto wall = [](std::size_t i) { return 0.5 + swaying(i); };
  EXPECT_TRUE(warnings(run(400, wall, [](std::size_t) { return 0.7; })).empty());
}

TEST(CheckRays, NameAReadingThatNeverMoves) {
  for (const double stuck : {0.0, 0.4}) {
    TickTable ticks = felt_in(3);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      RayReading& reading = ticks.readings[3 * i + kLeft];
      reading.value = i % 7 == 0 ? kMissing : stuck;
    }
    const auto found = warnings(ticks);
    ASSERT_EQ(found.size(), 1U) << stuck;
    EXPECT_NE(found[0].find(stuck == 0.0 ? "column 'left_bend_rad': found '0 at every tick'"
                                         : "column 'left_bend_rad': found '0.4 at every tick'"),
              std::string::npos)
        << found[0];
  }
}

// A beam that meets nothing all along says its reach; one that says less is looking at something.
TEST(CheckRays, LeaveABeamAloneThatSeesNothing) {
  Robot robot = corpus_robot();
  robot.rays[kLeft].kind = RayKind::range;
  const auto no_force = [](std::size_t) { return kMissing; };
  const double reach_m = robot.rays[kLeft].reach_m;
  EXPECT_TRUE(warnings(run(
                           400, [=](std::size_t) { return reach_m; }, no_force),
                       robot)
                  .empty());
  const auto found = warnings(run(
                                  400, [](std::size_t) { return 0.2; }, no_force),
                              robot);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("column 'left_range_m': found '0.2 at every tick'"), std::string::npos);
}

TEST(CheckRays, NameTwoRaysThatAreOne) {
  TickTable ticks = felt_in(3);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ticks.readings[3 * i + kLeft].value = i == 5 ? kMissing : ticks.readings[3 * i + kLeft].value;
    ticks.readings[3 * i + kRight].value = ticks.readings[3 * i + kLeft].value;
    ticks.readings[3 * i + kFront].value = ticks.readings[3 * i + kLeft].value;
  }
  const auto found = warnings(ticks);
  ASSERT_EQ(found.size(), 2U);
  const std::string count = std::to_string(ticks.size());
  EXPECT_NE(
      found[0].find("column 'right_bend_rad': found 'the " + count + " readings of left_bend_rad'"),
      std::string::npos)
      << found[0];
  EXPECT_NE(found[1].find("column 'front_bend_rad'"), std::string::npos);
  ticks.readings[3 * 9 + kFront].value += 1e-4;
  EXPECT_EQ(warnings(ticks).size(), 1U);
}

TEST(CheckRays, NameARayWithoutReadingsBesideOthersThatHaveThem) {
  const auto no_force = [](std::size_t) { return kMissing; };
  const auto rare = [](std::size_t i) { return i % 11 == 0 ? swaying(i) : kMissing; };
  const auto found = warnings(run(400, rare, no_force));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("column 'left_bend_rad': found 'readings at 37 of 400 ticks'"),
            std::string::npos)
      << found[0];
  const auto seldom = [](std::size_t i) { return i % 9 == 0 ? swaying(i) : kMissing; };
  EXPECT_TRUE(warnings(run(400, seldom, no_force)).empty());
  TickTable none = run(400, rare, no_force);
  for (RayReading& reading : none.readings) {
    reading.value = kMissing;
  }
  EXPECT_TRUE(warnings(none).empty()) << "no ray reads anything: the touch is silent, and stale";
}

TEST(CheckRays, SayNothingOfARobotThatHardlyMovedOrOfAShortLog) {
  const auto still = [](std::size_t) { return 0.4; };
  const auto held = [](std::size_t) { return 0.7; };
  EXPECT_EQ(warnings(run(102, still, held)).size(), 1U);
  EXPECT_TRUE(warnings(run(100, still, held)).empty());  // 0.99 m
  TickTable fast = run(49, still, held);
  for (Pose& pose : fast.poses) {
    pose.position.x_m *= 10.0;
  }
  EXPECT_TRUE(warnings(fast).empty());
}

}  // namespace
}  // namespace tcert
