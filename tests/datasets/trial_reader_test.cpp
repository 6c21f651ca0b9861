#include "datasets/trial_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/trial_folder.hpp"

namespace tcert {
namespace {

using Messages = std::vector<std::string>;

/// A good log that each test spoils in one place.
class ReadTrial : public test_support::TrialFolder {
 protected:
  ReadTrial() {
    write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,1,0,0\n1,2,0,0\n");
    write("tactile.csv", "time_s,left_bend_rad,left_fsr_n\n0,0.1,\n0.5,0.2,1\n1,0.3,2\n");
    Ray left{"left", {}, 1.5, 0.6, RayKind::bend, {{0.0, 1.0}, {0.6, 0.0}}};
    bundle_.info.robot.rays = {left};
  }
};

TEST_F(ReadTrial, ReadsTheStreamsOfAGoodLog) {
  write("control.csv", "time_s,speed_cmd_mps,yaw_rate_cmd_rps\n0,0.2,0.1\n");
  EXPECT_EQ(read(), Messages{});
  EXPECT_EQ(log_->pose.time_ns, (std::vector<std::int64_t>{0, 500'000'000, 1'000'000'000}));
  EXPECT_EQ(log_->pose.poses[2].position, (Point{2, 0}));
  EXPECT_EQ(log_->tactile.readings[1].value, 0.2);
  EXPECT_EQ(log_->tactile.readings[1].fsr_n, 1.0);
  EXPECT_TRUE(std::isnan(log_->tactile.readings[0].fsr_n));
  EXPECT_EQ(log_->control.speed_cmd_mps, (std::vector<double>{0.2}));
  EXPECT_TRUE(std::isnan(log_->control.loop_latency_ms[0]));
  EXPECT_GT(log_->bytes, 100U);
}

TEST_F(ReadTrial, ReadsWhenSamplesArriveToTheNanosecond) {
  write("pose.csv",
        "x_m,arrival_s,y_m,yaw_rad,time_s\n0,1700000000.123456789,0,0,1700000000.123456789\n"
        "1,1700000000.623456792,0,0,1700000000.623456790\n");
  write("tactile.csv",
        "time_s,left_bend_rad,arrival_s\n1700000000.2,0.1,NA\n1700000000.3,,1700000000.3\n"
        "1700000000.4,0.2,1700000000.9\n");
  write("control.csv", "time_s,speed_cmd_mps,arrival_s\n1700000000.1,0.2,1700000000.1\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/tactile.csv: note: column 'arrival_s': found '1 of 2 cells missing', "
                      "expected a time; these samples count as there at once",
                      "logs/t/tactile.csv: note: found '1 of 3 rows without a value', expected "
                      "rows with one; the others are no samples of this stream"}));
  EXPECT_EQ(log_->pose.time_ns,
            (std::vector<std::int64_t>{1'700'000'000'123'456'789, 1'700'000'000'623'456'790}));
  EXPECT_EQ(log_->pose.arrival_ns,
            (std::vector<std::int64_t>{1'700'000'000'123'456'789, 1'700'000'000'623'456'792}));
  EXPECT_EQ(log_->tactile.arrival_ns,
            (std::vector<std::int64_t>{1'700'000'000'200'000'000, 1'700'000'000'900'000'000}));
  EXPECT_EQ(log_->tactile.readings.size(), 2U);
  EXPECT_EQ(log_->control.arrival_ns, (std::vector<std::int64_t>{1'700'000'000'100'000'000}));
}

TEST_F(ReadTrial, ArrivalBeforeItsTimeRejectsRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad,arrival_s\n0,0,0,0,0\n0.5,1,0,0,0.4\n1,2,0,0,1\n");
  const Messages expected{
      "logs/t/pose.csv:3: error: column 'arrival_s': found '0.4 before 0.5', expected a time at or "
      "after time_s, on the same clock"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  write("pose.csv", "time_s,x_m,y_m,yaw_rad,arrival_s\n0,0,0,0,soon\n0.5,1,0,0,0.5\n1,2,0,0,1\n");
  EXPECT_EQ(
      read(),
      Messages{"logs/t/pose.csv:2: error: column 'arrival_s': found 'soon', expected a time in "
               "seconds (a missing cell is empty, NA or nan); --repair drops such rows"});
}

TEST_F(ReadTrial, CommandsThatArriveBeforeTheirTimeAreLeftOut) {
  write("control.csv", "time_s,speed_cmd_mps,arrival_s\n0.5,0.2,0.2\n");
  ASSERT_EQ(read().size(), 2U);
  ASSERT_TRUE(log_.has_value());
  EXPECT_TRUE(log_->control.time_ns.empty());
}

TEST_F(ReadTrial, MissingFileRejectsRepairedOrNot) {
  remove("pose.csv");
  remove("tactile.csv");
  const Messages expected{
      "logs/t/pose.csv: error: expected this file, or it with .gz or .zst, or ticks.csv instead",
      "logs/t/tactile.csv: error: expected this file, or it with .gz or .zst, or ticks.csv "
      "instead"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
}

TEST_F(ReadTrial, MissingColumnRejectsRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_deg\n0,0,0,0\n");
  const Messages expected{
      "logs/t/pose.csv:1: error: column 'yaw_rad': found 'yaw_deg', expected a column of this name "
      "in the header; rename a foreign one under 'columns' in bundle.json"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
}

TEST_F(ReadTrial, EqualColumnNamesRejectRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad,X_m\n0,0,0,0,1\n");
  const Messages expected{
      "logs/t/pose.csv:1: error: column 'X_m': found 'x_m', expected column names that differ when "
      "case is folded"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
}

TEST_F(ReadTrial, UnreadableHeaderRejectsRepairedOrNot) {
  write("pose.csv", "");
  const Messages expected{"logs/t/pose.csv: error: expected a header line and rows"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
}

TEST_F(ReadTrial, NotANumberIsAnErrorAndRepairDropsTheRow) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,nan,0,0\n0.7,-inf,0,0\n1,2,0,here\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/pose.csv:3: error: column 'x_m': found 'nan', expected a "
                      "finite number; --repair drops such rows (and 1 more)",
                      "logs/t/pose.csv:5: error: column 'yaw_rad': found 'here', expected a "
                      "finite number; --repair drops such rows"}));
  EXPECT_EQ(read(true)[0],
            "logs/t/pose.csv:3: warning: column 'x_m': found 'nan', expected a finite number; the "
            "row is dropped (and 1 more)");
  EXPECT_EQ(log_->pose.time_ns, (std::vector<std::int64_t>{0}));
}

TEST_F(ReadTrial, EmptyPoseCellIsAnErrorAndEmptyForceIsMissing) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,,0,0\n1,2,0,0\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/pose.csv:2: error: column 'x_m': expected a finite number; "
                      "--repair drops such rows"}));
}

TEST_F(ReadTrial, RepairIsNotAdvisedWhereNoRowWouldBeLeft) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,,0,0\n1,2,a,0\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/pose.csv:2: error: column 'x_m': expected a finite number",
                      "logs/t/pose.csv:3: error: column 'y_m': found 'a', expected a finite "
                      "number"}));
  EXPECT_EQ(read(true).back(),
            "logs/t/pose.csv: error: found 'no rows', expected at least one row");
}

TEST_F(ReadTrial, TimeNotIncreasingIsAnErrorAndRepairSortsAndMerges) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n1,2,0,0\n0.1,0,0,0\n0.5,1,0,0\n0.5,1,0,0\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/pose.csv:3: error: column 'time_s': found '0.1 after 1', "
                      "expected a time after that of the row before; --repair sorts the "
                      "rows (and 2 more)",
                      "logs/t/pose.csv:5: error: column 'time_s': found '1 row equal to another', "
                      "expected each row once; --repair merges these"}));
  EXPECT_EQ(read(true),
            (Messages{"logs/t/pose.csv:3: warning: column 'time_s': found '3 rows late by up to "
                      "0.9 s', expected rows in order of time; they are sorted",
                      "logs/t/pose.csv: warning: column 'time_s': found '1 row equal to another', "
                      "expected each row once; exact duplicates are merged"}));
  EXPECT_EQ(log_->pose.time_ns,
            (std::vector<std::int64_t>{100'000'000, 500'000'000, 1'000'000'000}));
}

TEST_F(ReadTrial, RepairKeepsRowsOfOneTimeThatDifferInFileOrder) {
  write("pose.csv",
        "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,1,0,0\n0.5,1.5,0,0\n0.5,1,0,0\n1,2,0,0\n");
  EXPECT_EQ(read(true).back(),
            "logs/t/pose.csv:4: warning: column 'time_s': found '0.5 after 0.5', expected one row "
            "for each time; these differ in their values and stay in file order");
  ASSERT_EQ(log_->pose.poses.size(), 4U);
  EXPECT_EQ(log_->pose.poses[2].position.x_m, 1.5);
}

TEST_F(ReadTrial, ClockJumpIsAWarningAndABreakRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,1,0,0\n2,2,0,0\n");
  write("tactile.csv", "time_s,left_bend_rad\n0,0.1\n1,0.2\n2,0.3\n");
  const Messages expected{
      "logs/t/pose.csv:4: warning: column 'time_s': found 'a step of 1.5 s', expected steps of at "
      "most 1 s; the path is broken here"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  EXPECT_EQ(log_->breaks_ns, (std::vector<std::int64_t>{2'000'000'000}));
}

TEST_F(ReadTrial, TimeBeyondTenTrialLimitsIsAWarningAndABreak) {
  bundle_.info.trial_limit_s = 0.06;
  const Messages expected{
      "logs/t/pose.csv:4: warning: column 'time_s': found '1 s after the first row', expected at "
      "most ten times the trial limit; the path is broken here",
      "logs/t/tactile.csv:4: warning: column 'time_s': found '1 s after the first row', expected "
      "at "
      "most ten times the trial limit; the path is broken here"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  EXPECT_EQ(log_->breaks_ns, (std::vector<std::int64_t>{1'000'000'000, 1'000'000'000}));
}

TEST_F(ReadTrial, LastLineCutShortIsAWarningRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,1,0,0\n1,2");
  const Messages expected{
      "logs/t/pose.csv:4: warning: found 'a line cut short', expected a whole last line with its "
      "line end; the row is not used"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  EXPECT_EQ(log_->pose.time_ns.size(), 2U);
}

TEST_F(ReadTrial, NoTrailingLineEndIsAWarningRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,1,0,0\n1,2,0,0");
  const Messages expected{
      "logs/t/pose.csv: warning: found 'no line end after the last row', expected one; the row "
      "looks "
      "whole and is used"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  EXPECT_EQ(log_->pose.time_ns.size(), 3U);
}

TEST_F(ReadTrial, StreamThatEndsEarlyIsAWarningRepairedOrNot) {
  write("tactile.csv", "time_s,left_bend_rad\n0,0.1\n1,0.2\n2,0.3\n3,0.3\n");
  const Messages expected{
      "logs/t/pose.csv:4: warning: column 'time_s': found 'its end 2 s before the other stream's', "
      "expected streams that end together; the ticks end where this one does"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  EXPECT_EQ(resample(*log_).time_ns.back(), 1'000'000'000);
}

TEST_F(ReadTrial, StreamsWithoutACommonInstantReject) {
  write("tactile.csv", "time_s,left_bend_rad\n100,0.1\n101,0.2\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/tactile.csv: error: column 'time_s': found 'no instant in common', "
                      "expected times that overlap those of the pose: streams share one clock"}));
}

TEST_F(ReadTrial, ZeroRowsRejectRepairedOrNot) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n");
  const Messages expected{"logs/t/pose.csv: error: found 'no rows', expected at least one row"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
}

TEST_F(ReadTrial, ZeroRowsLeftByRepairReject) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,a,0,0\n");
  EXPECT_EQ(read(true).back(),
            "logs/t/pose.csv: error: found 'no rows', expected at least one row");
}

TEST_F(ReadTrial, NamesTheProblemsOfAllFilesAtOnce) {
  write("pose.csv", "time_s,x_m,y_m,yaw_rad\n0,a,0,0\n");
  write("tactile.csv", "time_s,left_bend_rad\n0,b\n");
  write("control.csv", "time_s,speed_cmd_mps\n0,c\n");
  EXPECT_EQ(read().size(), 4U);  // the last says that the commands are not used
}

TEST_F(ReadTrial, RenamesForeignColumns) {
  write("pose.csv", "stamp,x,y,yaw_rad\n0,0,0,0\n1,2,0,0\n");
  bundle_.info.columns["pose.csv"] = {{"stamp", "time_s"}, {"x", "x_m"}, {"y", "y_m"}};
  EXPECT_EQ(read(), Messages{});
  EXPECT_EQ(log_->pose.poses[1].position.x_m, 2.0);
}

TEST_F(ReadTrial, ReadsMergedTicksAndBreaksThemAtGaps) {
  write("ticks.csv",
        "time_s,x_m,y_m,yaw_rad,left_bend_rad,stale,segment_start\n"
        "0,0,0,0,0.1,0,0\n0.1,1,0,0,,1,0\n5,2,0,0,0.3,0,0\n5.1,2,0,0,0.3,0,1\n");
  EXPECT_EQ(read(),
            (Messages{"logs/t/ticks.csv:4: warning: column 'time_s': found 'a step of 4.9 s', "
                      "expected steps of at most 1 s; the path is broken here"}));
  ASSERT_TRUE(log_->merged);
  const TickTable& ticks = *log_->merged;
  EXPECT_EQ(ticks.stale, (std::vector<std::uint8_t>{0, 1, 0, 0}));
  EXPECT_EQ(ticks.segment_start, (std::vector<std::uint8_t>{0, 0, 1, 1}));
  EXPECT_TRUE(std::isnan(ticks.readings[1].value));
  EXPECT_TRUE(std::isnan(ticks.speed_cmd_mps[0]));
  EXPECT_EQ(resample(*log_).time_ns, ticks.time_ns);
}

TEST_F(ReadTrial, RejectsAFlagThatIsNeitherZeroNorOne) {
  write("ticks.csv", "time_s,x_m,y_m,yaw_rad,left_bend_rad,stale\n0,0,0,0,0.1,2\n");
  EXPECT_EQ(read(), (Messages{"logs/t/ticks.csv:2: error: column 'stale': expected 0 or 1"}));
}

}  // namespace
}  // namespace tcert
