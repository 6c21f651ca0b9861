// What a trial's files may hold besides good rows: readings of nothing, empty rows, commands that
// are not whole, streams that begin late.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "datasets/trial_reader.hpp"
#include "support/trial_folder.hpp"

namespace tcert {
namespace {

using Messages = std::vector<std::string>;

/// Two range rays, 10 Hz for 4 s; tests write what they change.
class TrialValues : public test_support::TrialFolder {
 protected:
  TrialValues() {
    bundle_.info.robot.rays = {{"left", {}, 1.5, 2.0, RayKind::range, {}},
                               {"right", {}, -1.5, 2.0, RayKind::range, {}}};
    write_poses(0, 40);
    write_touches([](int i) { return row(i, "0.5", "0.6"); });
  }

  static std::string seconds(int tenths) {
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }
  static std::string row(int i, const std::string& left, const std::string& right) {
    return seconds(i) + "," + left + "," + right + "\n";
  }
  void write_poses(int first, int last) {
    std::string text = "time_s,x_m,y_m,yaw_rad\n";
    for (int i = first; i <= last; ++i) {
      text += seconds(i) + "," + std::to_string(0.02 * i) + ",0,0\n";
    }
    write("pose.csv", text);
  }
  template <class Row>
  void write_touches(Row row_of) {
    std::string text = "time_s,left_range_m,right_range_m\n";
    for (int i = 0; i <= 40; ++i) {
      text += row_of(i);
    }
    write("tactile.csv", text);
  }
  void write_control(const std::string& rows) { write("control.csv", rows); }
};

TEST_F(TrialValues, NoReadingOfARangeRejectsTheTrial) {
  for (const char* word : {"inf", "+Inf", "Infinity", "1e999"}) {
    write_touches([&](int i) { return row(i, i % 4 == 0 ? word : "0.5", "0.6"); });
    EXPECT_EQ(read(), Messages{}) << word;
    EXPECT_EQ(log_->tactile.readings[0].value, 2.0) << word;
  }
  write_touches([](int i) { return row(i, i % 4 == 0 ? "nan" : "0.5", i == 1 ? "-inf" : "0.6"); });
  EXPECT_EQ(read(), Messages{});
  EXPECT_TRUE(std::isnan(log_->tactile.readings[0].value));
  EXPECT_EQ(log_->tactile.readings[3].value, 0.0);
  write_touches([](int i) { return row(i, i % 4 == 0 ? "-1" : "0.5", "0.6"); });
  EXPECT_EQ(
      read(),
      (Messages{"logs/t/tactile.csv: warning: column 'left_range_m': found '11 readings below "
                "0, down to -1', expected distances; these are missing. If they mean nothing "
                "within reach, say so by 'no_return' of the ray in bundle.json"}));
  EXPECT_TRUE(std::isnan(log_->tactile.readings[0].value));
}

TEST_F(TrialValues, DeclaredValuesMeanNothingWithinReach) {
  bundle_.info.range_keys = {{{0.0, -1.0}, 0.0, std::numeric_limits<double>::infinity()}};
  write_touches([](int i) { return row(i, i % 4 == 0 ? "0" : i % 4 == 1 ? "-1" : "0.5", "0.6"); });
  EXPECT_EQ(read(), Messages{});
  EXPECT_EQ(log_->tactile.readings[0].value, 2.0);
  EXPECT_EQ(log_->tactile.readings[2].value, 2.0);
  bundle_.info.range_keys[0].range_min_m = 0.55;
  const Messages counted = read();
  ASSERT_EQ(counted.size(), 1U);
  EXPECT_NE(counted[0].find("note: column 'left_range_m': found '20 readings below range_min_m'"),
            std::string::npos)
      << counted[0];
}

TEST_F(TrialValues, WordsAmongManyBeamsAreSaidOnce) {
  std::string header = "time_s";
  std::string cells;
  bundle_.info.robot.rays.clear();
  for (int beam = 0; beam < 100; ++beam) {
    const std::string name = "b" + std::to_string(beam);
    bundle_.info.robot.rays.push_back({name, {}, 0.0, 2.0, RayKind::range, {}});
    header += "," + name + "_range_m";
    cells += ",off";
  }
  write("tactile.csv", header + "\n0" + cells + "\n1" + cells + "\n2" + cells + "\n");
  const Messages found = read();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0],
            "logs/t/tactile.csv:2: error: column 'b0_range_m and 99 more': found 'off', expected a "
            "number or inf (a missing cell is empty, NA or nan) (and 299 more)");
}

// A wide table has a row for every instant of every stream.
TEST_F(TrialValues, RowsWithoutAValueAreNoSamples) {
  std::string pose = "time_s,x_m,y_m,yaw_rad,left_range_m,right_range_m\n";
  std::string narrow_pose = "time_s,x_m,y_m,yaw_rad\n";
  std::string narrow_touch = "time_s,left_range_m,right_range_m\n";
  for (int i = 0; i <= 40; ++i) {
    const std::string at = seconds(i);
    pose += at + ",0.1,0,0,,\n" + at + "5,,,,0.5,0.6\n";
    narrow_pose += at + ",0.1,0,0\n";
    narrow_touch += at + "5,0.5,0.6\n";
  }
  write("pose.csv", pose);
  write("tactile.csv", pose);
  const Messages notes = read();
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0],
            "logs/t/pose.csv: note: found '41 of 82 rows without a value', expected rows with one; "
            "the others are no samples of this stream");
  const TrialLog wide = *log_;
  write("pose.csv", narrow_pose);
  write("tactile.csv", narrow_touch);
  EXPECT_EQ(read(), Messages{});
  EXPECT_EQ(wide.pose.time_ns, log_->pose.time_ns);
  EXPECT_EQ(wide.tactile.time_ns, log_->tactile.time_ns);
}

TEST_F(TrialValues, ADeadSensorIsAGapOfItsStream) {
  write_touches([](int i) { return i > 10 && i < 30 ? row(i, "", "nan") : row(i, "0.5", "0.6"); });
  const Messages found = read();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[1].find("found 'a step of 2 s'"), std::string::npos) << found[1];
  const TickTable ticks = resample(*log_);
  EXPECT_EQ(std::ranges::count(ticks.stale, 1), 14);  // 1.6 to 2.9 s
  EXPECT_EQ(ticks.segment_start[30], 1);
  // The same in merged ticks, which have no newest sample: a tick without any reading is stale.
  write("ticks.csv",
        "time_s,x_m,y_m,yaw_rad,left_range_m,right_range_m\n0,0,0,0,1,1\n0.1,0,0,0,,nan\n");
  EXPECT_EQ(read(), Messages{});
  EXPECT_EQ(log_->merged->stale, (std::vector<std::uint8_t>{0, 1}));
}

TEST_F(TrialValues, ATouchWithoutAnyReadingRejectsTheTrial) {
  write_touches([](int i) { return row(i, "", ""); });
  EXPECT_EQ(read(),
            (Messages{"logs/t/tactile.csv: error: found '41 rows, none with a value', expected at "
                      "least one row with a value"}));
  write_touches([](int i) { return row(i, "-1", "-1"); });
  EXPECT_EQ(
      read().back(),
      "logs/t/tactile.csv: error: found '41 rows, none with a reading', expected at least one "
      "reading of a ray");
}

TEST_F(TrialValues, CommandsMayBeMissing) {
  write_control("time_s,speed_cmd_mps\n0,0.2\n1,\n2,nan\n");
  EXPECT_EQ(read(), Messages{});
  EXPECT_EQ(log_->control.speed_cmd_mps.size(), 1U) << "rows without a command are none";
  write_control("time_s,speed_cmd_mps,yaw_rate_cmd_rps\n0,0.2,nan\n1,,0.1\n");
  EXPECT_EQ(read(), Messages{});
  EXPECT_TRUE(std::isnan(log_->control.yaw_rate_cmd_rps[0]));
  EXPECT_TRUE(std::isnan(log_->control.speed_cmd_mps[1]));
}

TEST_F(TrialValues, WhateverIsWrongWithCommandsCostsThemAndNotTheTrial) {
  const std::string header = "time_s,speed_cmd_mps,yaw_rate_cmd_rps\n";
  for (const std::string& control : {std::string(),
                                     std::string("time_s\n1\n"),
                                     header,
                                     header + "0,fast,0\n",
                                     header + "1,0.2,0\n0.5,0.2,0\n",
                                     header + "900,0.2,0\n901,0.2,0\n",
                                     header + "0,0.2,0\n1,0.2,0\n,\"\n"}) {
    write_control(control);
    const Messages found = read();
    EXPECT_TRUE(log_.has_value()) << control;
    ASSERT_FALSE(found.empty()) << control;
    for (const std::string& line : found) {
      EXPECT_NE(line.find("control.csv"), std::string::npos) << line;
      EXPECT_NE(line.find("warning"), std::string::npos) << line;
    }
    EXPECT_TRUE(log_->control.time_ns.empty()) << control;
  }
  write_control(header + "1,0.2,0\n0.5,0.2,0\n");
  EXPECT_EQ(read().back(),
            "logs/t/control.csv: warning: found 'a file with errors', expected commands; the trial "
            "is used without them");
  read(true);
  EXPECT_EQ(log_->control.time_ns, (std::vector<std::int64_t>{500'000'000, 1'000'000'000}));
  write_control(header + "900,0.2,0\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/control.csv: warning: column 'time_s': found 'no instant in common, "
                      "896 s apart', expected times that overlap those of the pose: another clock? "
                      "The commands are not used"}));
}

TEST_F(TrialValues, AStreamThatBeginsLateIsSaidWithSeconds) {
  write_touches([](int i) { return i < 12 ? std::string() : row(i, "0.5", "0.6"); });
  EXPECT_EQ(
      read(),
      (Messages{"logs/t/tactile.csv:2: warning: column 'time_s': found 'its begin 1.2 s after "
                "the other stream's', expected streams that begin together; ticks and early "
                "window begin there, unless bundle.json says 'start_at': \"pose\""}));
  EXPECT_EQ(resample(*log_).size(), 29U);
  bundle_.info.start_at = StartAt::pose;
  EXPECT_NE(read().at(0).find("ticks begin with the pose and are stale until there"),
            std::string::npos);
  EXPECT_EQ(resample(*log_).size(), 41U);
  write_touches([](int i) { return row(i, "0.5", "0.6"); });
  write_poses(12, 40);
  EXPECT_EQ(read(),
            (Messages{"logs/t/pose.csv:2: warning: column 'time_s': found 'its begin 1.2 s after "
                      "the other stream's', expected streams that begin together; ticks and early "
                      "window begin there"}));
  write_poses(10, 40);
  EXPECT_EQ(read(), Messages{}) << "within the gap";
}

TEST_F(TrialValues, ADecimalCommaIsNamedWhereItsOptionHelps) {
  std::string pose = "time_s;x_m;y_m;yaw_rad\n";
  for (int i = 0; i < 10; ++i) {
    pose += "0," + std::to_string(i) + ";0,1;0,0;0,0\n";
  }
  write("pose.csv", pose);
  const Messages found = read();
  EXPECT_EQ(found.back(),
            "logs/t/pose.csv: error: column 'time_s and 3 more': found '0,0', expected a decimal "
            "point; --decimal-comma reads these");
  for (const std::string& line : found) {
    EXPECT_EQ(line.find("--repair"), std::string::npos) << line;
  }
  bundle_.decimal_comma = true;
  read();
  EXPECT_TRUE(log_);
}

TEST_F(TrialValues, TimesThatAreNoSecondsAreNamed) {
  std::string pose = "time_s,x_m,y_m,yaw_rad\n";
  std::string dates = pose;
  for (int i = 0; i < 10; ++i) {
    pose += "172780000012345678" + std::to_string(i) + ",0,0,0\n";
    dates += "2021-03-04T05:06:0" + std::to_string(i) + "Z,0,0,0\n";
  }
  write("pose.csv", pose);
  EXPECT_EQ(read().back(),
            "logs/t/pose.csv: error: column 'time_s': found '1727800000123456780', expected "
            "seconds; these are nanoseconds?");
  write("pose.csv", dates);
  EXPECT_EQ(read().back(),
            "logs/t/pose.csv: error: column 'time_s': found '2021-03-04T05:06:00Z', expected "
            "seconds as a number, not dates");
}

}  // namespace
}  // namespace tcert
