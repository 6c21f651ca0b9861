#include "datasets/import/carmen_log.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/carmen_text.hpp"

namespace tcert {
namespace {

using test_support::Messages;
using test_support::messages;

constexpr double kDegree = std::numbers::pi / 180.0;

CarmenLog read(std::string_view text, Messages& problems, CarmenReading reading = {}) {
  table::DiagnosticGroups groups;
  CarmenLog log = read_carmen_log(table::Bytes::copy_of(text), "a.log", reading, groups);
  problems = messages(groups.take());
  return log;
}

CarmenReading half_turn() { return {std::numbers::pi, CarmenClock::ipc, 0.0}; }

CarmenReading by_order(double rate_hz) { return {std::numbers::pi, CarmenClock::order, rate_hz}; }

/// Scans of two beams, a second apart but for their stamps.
std::string scans_with(const std::vector<std::string>& stamps) {
  std::string text;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    text += test_support::flaser("2 1 2", 0.5 * static_cast<double>(i), stamps[i], i);
  }
  return text;
}

TEST(ReadCarmenLog, TakesThePosesOfScansAndCountsTheRest) {
  Messages problems;
  const CarmenLog log = read(test_support::kCarmenLog, problems, half_turn());
  EXPECT_EQ(problems, Messages{});
  EXPECT_EQ(log.kind, "FLASER");
  EXPECT_EQ(log.time_ns, (std::vector<std::int64_t>{1'500'000'000, 3'250'000'000}));
  EXPECT_EQ(log.poses[1].position, (Point{1.5, 0.25}));
  EXPECT_EQ(log.poses[1].yaw_rad, 0.125);
  EXPECT_EQ(log.ranges_m, (std::vector<double>{1, 2, 3, 81.83, 1, 2, 3, 8}));
  EXPECT_EQ(log.records, 2U);
  EXPECT_EQ(log.odometry_records, 2U);
  EXPECT_EQ(log.other_records, 1U);
}

TEST(ReadCarmenLog, NamesTheLineAndTheFieldOfARecordThatItCannotUse) {
  Messages problems;
  const CarmenLog log = read(
      "FLASER 2 1 2 0 0 0 0 0 0 1 h 1\n"
      "FLASER 2 1 far 0 0 0 0 0 0 2 h 2\n"
      "FLASER 3 1 2 3 0 0 0 0 0 0 3 h 3\n"
      "FLASER 2 1 -2 0 0 0 0 0 0 4 h 4\n"
      "FLASER 2 1 2 0 0 0 0 0 0 0.5 h 5\n"
      "FLASER 1e9 1 2\n"
      "FLASER 2 1 2 0 0 0 0 0\n",
      problems,
      half_turn());
  EXPECT_EQ(log.scans(), 1U);
  EXPECT_EQ(
      problems,
      (Messages{"a.log:2: warning: column 'range': found 'far', expected a finite number; the "
                "record is not used",
                "a.log:3: warning: column 'number of beams': found '3', expected as many beams "
                "as the first scan has; the record is not used",
                "a.log:4: warning: column 'range': found '-2', expected a range in metres, 0 or "
                "more; the record is not used",
                "a.log:5: warning: column 'ipc_timestamp': found '0.5 after 1', expected a time "
                "after that of the scan before; the record is not used",
                "a.log:6: warning: column 'number of beams': found '1e9', expected a whole "
                "number, 1 to 4096; the record is not used",
                "a.log:7: warning: column 'odom_theta': expected a finite number; the record is "
                "not used",
                "a.log: error: found '1 scans that can be used of 7', expected nine of ten at "
                "least; the warnings say what is wrong with the others"}));
}

TEST(ReadCarmenLog, RejectsALogWithoutScans) {
  Messages problems;
  EXPECT_EQ(read("ODOM 9 9 9 0 0 0 0.5 host 0.5\nRAWLASER1 0 0\n", problems).scans(), 0U);
  EXPECT_EQ(problems,
            (Messages{"a.log: error: found 'no scan', expected at least one FLASER or ROBOTLASER1 "
                      "record"}));
}

TEST(ReadCarmenLog, TakesReadingsThatAreNoNumbersAsWhatTheySay) {
  Messages problems;
  const CarmenLog log = read("FLASER 4 inf -inf nan 1 0 0 0 0 0 0 1 h 1\n", problems, half_turn());
  EXPECT_EQ(problems, Messages{});
  ASSERT_EQ(log.ranges_m.size(), 4U);
  EXPECT_TRUE(std::isinf(log.ranges_m[0])) << "no return within reach";
  EXPECT_EQ(log.ranges_m[1], 0.0) << "nearer than the laser can measure";
  EXPECT_TRUE(std::isnan(log.ranges_m[2])) << "missing";
}

TEST(CarmenBeams, LieWhereCarmensOwnReaderPutsThem) {
  for (const std::size_t count : {180U, 181U, 360U, 361U}) {
    const CarmenBeams beams = flaser_beams(count, {}).value();
    const double step = count < 200 ? 1.0 : 0.5;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(beams.bearing_rad(i), (-90.0 + step * static_cast<double>(i)) * kDegree, 1e-15);
    }
    EXPECT_EQ(beams.bearing_rad(count / 2), 0.0) << count;
  }
  for (const std::size_t count : {1U, 5U, 401U, 541U, 681U, 1081U}) {
    EXPECT_FALSE(flaser_beams(count, {})) << count;
  }
}

TEST(CarmenBeams, SpreadOverAFieldOfViewFromEndToEnd) {
  const CarmenBeams beams = flaser_beams(1081, 270.0 * kDegree).value();
  EXPECT_NEAR(beams.bearing_rad(0), -135.0 * kDegree, 1e-14);
  EXPECT_EQ(beams.bearing_rad(540), 0.0);
  EXPECT_NEAR(beams.bearing_rad(1080), 135.0 * kDegree, 1e-14);
  EXPECT_NEAR(flaser_beams(180, 180.0 * kDegree)->bearing_rad(179), 90.0 * kDegree, 1e-14)
      << "what is asked for goes before what CARMEN guesses";
  EXPECT_EQ(flaser_beams(1, 1.0)->bearing_rad(0), 0.0);
}

TEST(ReadCarmenLog, AsksWhereBeamsPointThatTheLogDoesNotSay) {
  Messages problems;
  static_cast<void>(
      read("FLASER 2 1 2 0 0 0 0 0 0 1 h 1\nFLASER 2 1 2 0 0 0 0 0 0 2 h 2\n", problems));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0],
            "a.log:1: error: column 'number of beams': found '2', expected 180 or 181 beams (from "
            "-90 degrees, 1 degree apart) or 360 or 361 (half a degree apart): where others point "
            "the log does not say; --fov DEG spreads them from -DEG/2 to +DEG/2");
}

TEST(CarmenStamps, ThatCarryNoOrderAreRefusedWithTheWayOut) {
  const std::string rounded = "1.01893e+09";
  const std::string wrapped = "4.29497e+09";
  const struct {
    std::vector<std::string> stamps;
    const char* found;
  } cases[] = {
      {{rounded, rounded, rounded, "1.01894e+09", "1.01894e+09", "1.01895e+09"},
       "3 different stamps in 6 scans"},
      {{"-0.445999", wrapped, wrapped, wrapped, wrapped, wrapped}, "2 different stamps in 6 scans"},
      {{"0", "0", "0", "0", "0", "0"}, "1 different stamp in 6 scans"},
      {{"0", "6.979", "3.44361e-86", "1e-76", "nan", "0"}, "5 different stamps in 6 scans"},
      {{"9e8", "1", "2", "3", "4", "5"}, "6 different stamps in 6 scans"}};
  for (const auto& one : cases) {
    Messages problems;
    const std::string text = scans_with(one.stamps);
    static_cast<void>(read(text, problems, half_turn()));
    ASSERT_FALSE(problems.empty());
    EXPECT_NE(problems.back().find(std::string("error: column 'ipc_timestamp': found '") +
                                   one.found + "', expected stamps that rise"),
              std::string::npos)
        << problems.back();
    EXPECT_NE(problems.back().find("--clock order --rate HZ"), std::string::npos);
    EXPECT_NE(problems.back().find("those of the logger do: --clock logger"), std::string::npos);

    const CarmenLog ordered = read(text, problems, by_order(4.0));
    EXPECT_EQ(problems, Messages{});
    ASSERT_EQ(ordered.scans(), 6U);
    EXPECT_EQ(ordered.time_ns[5], 1'250'000'000);

    CarmenReading logger = half_turn();
    logger.clock = CarmenClock::logger;
    EXPECT_EQ(read(text, problems, logger).time_ns[5], 5'000'000'000);
    EXPECT_EQ(problems, Messages{});
  }
}

TEST(CarmenStamps, OfWhichAFewAreLateStayWarnings) {
  std::vector<std::string> stamps;
  for (int i = 0; i < 20; ++i) {
    stamps.push_back(std::to_string(i % 10 == 5 ? i - 3 : i));
  }
  Messages problems;
  EXPECT_EQ(read(scans_with(stamps), problems, half_turn()).scans(), 18U);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("warning: column 'ipc_timestamp': found '2 after 4'"),
            std::string::npos);
  EXPECT_NE(problems[0].find("(and 1 more)"), std::string::npos);
}

TEST(CarmenStamps, ByOrderKeepThePlaceOfARecordThatCannotBeRead) {
  Messages problems;
  std::string text = scans_with({"0", "0", "0", "0", "0", "0", "0", "0", "0", "0", "0"});
  text.replace(text.find("FLASER 2 1 2", 20), 12, "FLASER 2 1 x");
  const CarmenLog log = read(text, problems, by_order(1.0));
  ASSERT_EQ(log.scans(), 10U);
  EXPECT_EQ(log.time_ns[1], 2'000'000'000);
}

/// laser_type 4, from 0.5 rad on in steps of 0.25 rad, up to 5.6 m; two remissions.
std::string robot_laser(const std::string& laser, const std::string& robot, int stamp) {
  const std::string time = std::to_string(stamp);
  return "ROBOTLASER1 4 0.5 0.5 0.25 5.6 0.01 0 3 1 5.6 9 2 100 200 " + laser + " " + robot +
         " 0 0 0 0 0 " + time + " host " + time + "\n";
}

TEST(ReadCarmenLog, TakesAnglesReachAndTheLasersPlaceFromRobotLaserRecords) {
  Messages problems;
  const CarmenLog log =
      read(robot_laser("1.2 0 0.1", "1 0 0", 1) + "FLASER 2 1 2 0 0 0 0 0 0 1 h 1\n" +
               robot_laser("3 4.2 1.6707963267948966", "3 4 1.5707963267948966", 2),
           problems);
  EXPECT_EQ(problems, Messages{});
  EXPECT_EQ(log.kind, "ROBOTLASER1");
  EXPECT_EQ(log.other_records, 1U);
  EXPECT_NEAR(log.beams.bearing_rad(0), 0.5, 1e-15);
  EXPECT_NEAR(log.beams.bearing_rad(2), 1.0, 1e-15);
  EXPECT_EQ(log.beams.furthest_m, 5.6);
  ASSERT_TRUE(log.mount);
  EXPECT_NEAR(log.mount->position.x_m, 0.2, 1e-12);
  EXPECT_NEAR(log.mount->position.y_m, 0.0, 1e-12);
  EXPECT_NEAR(log.mount->yaw_rad, 0.1, 1e-12);
  EXPECT_NEAR(log.poses[1].position.x_m, 3.0, 1e-12) << "the robot's, not the laser's";
  EXPECT_NEAR(log.poses[1].position.y_m, 4.0, 1e-12);
  EXPECT_NEAR(log.poses[1].yaw_rad, 1.5707963267948966, 1e-12);
}

TEST(ReadCarmenLog, RefusesAnglesOfRobotLaserRecordsThatCannotBeRadians) {
  Messages problems;
  static_cast<void>(
      read("ROBOTLASER1 4 -90 180 0.5 80 0.01 0 1 1 0 0 0 0 0 0 0 0 0 0 0 0 1 h 1\n", problems));
  EXPECT_NE(problems.at(0).find("column 'start_angle': found '-90', expected an angle in radians"),
            std::string::npos);
  std::string text = "ROBOTLASER1 4 -1.57 180 0.5 80 0.01 0 15";
  for (int i = 0; i < 15; ++i) {
    text += " 1";
  }
  static_cast<void>(read(text + " 0 0 0 0 0 0 0 0 0 0 0 0 1 h 1\n", problems));
  EXPECT_NE(problems.at(0).find("column 'angular_resolution': found '0.5'"), std::string::npos)
      << problems.at(0);
  static_cast<void>(read(robot_laser("0 0 0", "0 0 0", 1), problems, half_turn()));
  EXPECT_NE(problems.at(0).find("ROBOTLASER1 records state their angles"), std::string::npos);
}

}  // namespace
}  // namespace tcert
