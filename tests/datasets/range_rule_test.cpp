#include "datasets/range_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "datasets/range_report.hpp"
#include "datasets/tick_table.hpp"

namespace tcert {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

Robot robot_with_a_beam(double reach_m = 8.0) {
  Robot robot;
  robot.rays = {{"b0", {}, 0.0, reach_m, RayKind::range, {}},
                {"left", {}, 1.5, 0.6, RayKind::bend, {{0.0, 1.0}, {0.6, 0.0}}}};
  return robot;
}

TEST(RangeRules, TakeInfForTheReachMinusInfForZeroAndNothingForMissing) {
  const RangeRules rules(robot_with_a_beam(), {});
  EXPECT_EQ(rules.resolve(0, kInf), 8.0);
  EXPECT_EQ(rules.resolve(0, -kInf), 0.0);
  EXPECT_TRUE(std::isnan(rules.resolve(0, kMissing)));
  EXPECT_EQ(rules.resolve(0, 0.0), 0.0);
  EXPECT_EQ(rules.resolve(0, 81.83), 81.83);
  EXPECT_TRUE(std::isnan(rules.resolve(0, -1.0)));
  EXPECT_EQ(rules.resolve(1, -0.05), -0.05) << "a bend stays as it is";
}

TEST(RangeRules, TakeWhatIsDeclared) {
  const std::vector<RangeKeys> keys{{{0.0, -1.0, 65.535}, 0.12, 60.0}};
  const RangeRules rules(robot_with_a_beam(), keys);
  for (const double value : {0.0, -0.0, -1.0, 65.535, 65.53500366}) {
    EXPECT_EQ(rules.resolve(0, value), 8.0) << value;
  }
  EXPECT_TRUE(std::isnan(rules.resolve(0, 0.1)));
  EXPECT_EQ(rules.resolve(0, 0.12), 0.12);
  EXPECT_EQ(rules.resolve(0, 60.0), 60.0);
  EXPECT_TRUE(std::isnan(rules.resolve(0, 61.0)));
  EXPECT_EQ(rules.resolve(0, kInf), 8.0);
  EXPECT_EQ(rules.resolve(0, -kInf), 0.0) << "too near, whatever 0 means";
  RangeCount count;
  for (const double value : {kInf, 0.0, 0.1, 61.0, -2.0, 3.0, kMissing}) {
    rules.resolve(0, value, count);
  }
  EXPECT_EQ(count.stated, 6U);
  EXPECT_EQ(count.below_min, 1U);
  EXPECT_EQ(count.above_max, 1U);
  EXPECT_EQ(count.negative, 1U);
  EXPECT_EQ(count.undeclared, 1U);
}

// A touch that became 0 would be read as nothing within reach when the ticks are read again.
TEST(RangeRules, WriteReadingsSoThatTheyReadBackTheSame) {
  const std::vector<RangeKeys> keys{{{0.0}, 0.12, 5.0}};
  const Robot robot = robot_with_a_beam();
  const RangeRules rules(robot, keys);
  for (const double value : {-kInf, kInf, 0.0, 0.1, 1.5, 7.0, kMissing}) {
    const double reading = rules.resolve(0, value);
    const double again = rules.resolve(0, rules.stated(0, reading));
    EXPECT_TRUE(again == reading || (std::isnan(again) && std::isnan(reading))) << value;
  }
  TickTable ticks;
  ticks.rays = 2;
  ticks.time_ns = {0};
  ticks.poses = {{}};
  ticks.readings = {{0.0, kMissing}, {0.0, kMissing}};
  ticks.stale = {0};
  ticks.segment_start = {0};
  EXPECT_EQ(to_ticks_csv(robot, ticks, keys),
            "time_s,x_m,y_m,yaw_rad,b0_range_m,left_bend_rad,stale,segment_start\n"
            "0,0,0,0,-inf,0,0,0\n");
}

std::vector<std::string> reported(const Robot& robot,
                                  const std::vector<std::vector<double>>& readings,
                                  const std::vector<RangeKeys>& keys = {}) {
  const RangeRules rules(robot, keys);
  std::vector<RangeCount> counts(robot.rays.size());
  for (std::size_t k = 0; k < readings.size(); ++k) {
    for (const double value : readings[k]) {
      rules.resolve(k, value, counts[k]);
    }
  }
  std::vector<std::string> lines;
  for (const table::Diagnostic& one : range_report(robot, counts, "f")) {
    lines.push_back(table::to_string(one));
  }
  return lines;
}

/// A hundred readings from 0.5 to about 1.5 m, `count` of them `value`.
std::vector<double> readings_with(double value, int count) {
  std::vector<double> readings;
  for (int i = 0; i < 100; ++i) {
    readings.push_back(i < count ? value : 0.5 + 0.01 * i);
  }
  return readings;
}

TEST(RangeReport, NamesAValueThatMayBeNoDistance) {
  const Robot robot = robot_with_a_beam(2.0);
  const auto zero = reported(robot, {readings_with(0.0, 6)});
  ASSERT_EQ(zero.size(), 1U);
  EXPECT_EQ(
      zero[0],
      "f: warning: column 'b0_range_m': found '0 in 6 % of the readings', expected distances; "
      "it is read as a wall at the sensor. If it means nothing within reach, say so by "
      "'no_return': [0] of the ray in bundle.json, if no reading, by 'range_min_m'");
  EXPECT_TRUE(reported(robot, {readings_with(0.0, 5)}).empty()) << "not more than 5 %";
  const auto far = reported(robot, {readings_with(65.535, 6)});
  ASSERT_EQ(far.size(), 1U);
  EXPECT_NE(far[0].find("found '65.535 in 6 % of the readings'"), std::string::npos) << far[0];
  EXPECT_NE(far[0].find("it is read as free to the reach"), std::string::npos) << far[0];
  const auto code = reported(robot_with_a_beam(80.0), {readings_with(65.535, 6)});
  ASSERT_EQ(code.size(), 1U);
  EXPECT_NE(code[0].find("it is read as a wall there"), std::string::npos) << code[0];
  const auto negative = reported(robot, {readings_with(-1.0, 1)});
  ASSERT_EQ(negative.size(), 1U);
  EXPECT_NE(negative[0].find("found '1 readings below 0, down to -1'"), std::string::npos);
}

TEST(RangeReport, HasNothingToSayOfDistancesAndOfWhatIsDeclared) {
  const Robot robot = robot_with_a_beam(2.0);
  EXPECT_TRUE(reported(robot, {readings_with(2.0, 40)}).empty())
      << "a sensor that ends at the reach";
  EXPECT_TRUE(reported(robot, {readings_with(kInf, 40)}).empty());
  EXPECT_TRUE(reported(robot, {readings_with(1.0, 90)}).empty()) << "standing before a wall";
  EXPECT_TRUE(reported(robot, {readings_with(1.8, 30)}).empty()) << "the same, far from it";
  const std::vector<RangeKeys> keys{{{0.0, 65.535}, 0.0, kInf}};
  EXPECT_TRUE(reported(robot, {readings_with(0.0, 40)}, keys).empty());
  EXPECT_TRUE(reported(robot, {readings_with(65.535, 40)}, keys).empty());
}

TEST(RangeReport, SaysItOnceForAllBeamsOfAFile) {
  Robot robot;
  std::vector<std::vector<double>> readings;
  for (int beam = 0; beam < 360; ++beam) {
    robot.rays.push_back({"b" + std::to_string(beam), {}, 0.0, 8.0, RayKind::range, {}});
    readings.push_back(readings_with(beam % 2 == 0 ? 0.0 : -1.0, 10));
  }
  const auto lines = reported(robot, readings);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].find("column 'b1_range_m and 179 more': found '1800 readings below 0"),
            std::string::npos)
      << lines[0];
  EXPECT_NE(lines[1].find("column 'b0_range_m and 179 more': found '0 in 10 %"), std::string::npos);
}

}  // namespace
}  // namespace tcert
