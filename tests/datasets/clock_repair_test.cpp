// Times that do not rise: which are put in order, how, and which reject the trial.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "datasets/clock_faults.hpp"
#include "datasets/clock_steps.hpp"
#include "datasets/trial_reader.hpp"
#include "support/trial_folder.hpp"

namespace tcert {
namespace {

using Messages = std::vector<std::string>;

constexpr std::int64_t kMs = 1'000'000;

/// A robot that drives at 0.2 m/s for 20 s, poses at 10 Hz, touches at 20 Hz whose value says when
/// they were; `stamp` turns true milliseconds into what the log says.
class ClockRepair : public test_support::TrialFolder {
 protected:
  using Stamp = std::function<std::string(std::int64_t)>;

  ClockRepair() {
    bundle_.info.robot.rays = {{"front", {}, 0.0, 100.0, RayKind::range, {}}};
    write_both(as_it_is);
  }

  static std::string text_of(std::int64_t ms) {
    const std::string sign = ms < 0 ? "-" : "";
    const std::int64_t size = ms < 0 ? -ms : ms;
    std::string fraction = std::to_string(size % 1000);
    fraction.insert(0, 3 - fraction.size(), '0');
    return sign + std::to_string(size / 1000) + "." + fraction;
  }
  static std::string as_it_is(std::int64_t ms) { return text_of(ms); }
  static std::string pose_row(std::int64_t ms, const std::string& stamp) {
    return stamp + "," + text_of(ms / 5) + ",0,0\n";
  }
  static std::string touch_row(std::int64_t ms, const std::string& stamp) {
    return stamp + "," + text_of(ms) + "\n";
  }
  void write_poses(const Stamp& stamp) {
    std::string text = "time_s,x_m,y_m,yaw_rad\n";
    for (std::int64_t ms = 0; ms <= 20'000; ms += 100) {
      text += pose_row(ms, stamp(ms));
    }
    write("pose.csv", text);
  }
  void write_touches(const Stamp& stamp) {
    std::string text = "time_s,front_range_m\n";
    for (std::int64_t ms = 20; ms <= 20'000; ms += 50) {
      text += touch_row(ms, stamp(ms));
    }
    write("tactile.csv", text);
  }
  void write_both(const Stamp& stamp) {
    write_poses(stamp);
    write_touches(stamp);
  }

  /// Poses and touches of every fresh tick belong together: x is 0.2 times the touch's second, to
  /// within a hold and half a median's window.
  void expect_streams_to_agree() {
    const TickTable ticks = resample(*log_);
    double last_x_m = -1.0;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_GE(ticks.poses[i].position.x_m, last_x_m) << i;
      last_x_m = ticks.poses[i].position.x_m;
      if (ticks.stale[i] == 0) {
        EXPECT_NEAR(ticks.poses[i].position.x_m, 0.2 * ticks.readings[i].value, 0.2 * 0.21) << i;
      }
    }
  }
};

/// The clock is set back by 5 s after 9.95 s.
std::string set_back(std::int64_t ms) {
  const std::int64_t said = ms > 9950 ? ms - 5000 : ms;
  return std::to_string(said / 1000) + "." + std::to_string(1000 + said % 1000).substr(1);
}

TEST_F(ClockRepair, AClockSetBackIsNamedAndRepairMakesANewSegment) {
  write_both(set_back);
  EXPECT_EQ(
      read(),
      (Messages{"logs/t/pose.csv:102: error: column 'time_s': found 'the clock set back by 4.9 "
                "s', expected times that increase; --repair makes a new segment of the rows "
                "from here on",
                "logs/t/tactile.csv:201: error: column 'time_s': found 'the clock set back by "
                "4.95 s', expected times that increase; --repair makes a new segment of the "
                "rows from here on"}));
  EXPECT_EQ(
      read(true),
      (Messages{"logs/t/pose.csv:102: warning: column 'time_s': found 'the clock set back by "
                "4.9 s, set ahead by 5 s', expected times that increase; the rows from here on "
                "are a new segment",
                "logs/t/tactile.csv:201: warning: column 'time_s': found 'the clock set back by "
                "4.95 s, set ahead by 5 s', expected times that increase; the rows from here "
                "on are a new segment"}));
  EXPECT_EQ(log_->breaks_ns, (std::vector<std::int64_t>{9970 * kMs, 10'000 * kMs}));
  EXPECT_EQ(log_->pose.time_ns.back(), 20'000 * kMs);
  expect_streams_to_agree();
  const TickTable ticks = resample(*log_);
  EXPECT_EQ(std::ranges::count(ticks.stale, 1), 0);
  EXPECT_GE(std::ranges::count(ticks.segment_start, 1), 1);
}

// The streams' last rows before the step lie apart; whatever the true step was, one shift is right
// for both or for neither.
TEST_F(ClockRepair, BothStreamsAreSetAheadByTheSame) {
  for (const std::int64_t back : {1700, 5000, 86'400'000}) {
    for (const std::int64_t at : {9910, 9950, 10'012, 10'090}) {
      write_both([=](std::int64_t ms) { return text_of(ms > at ? ms - back : ms); });
      read(true);
      ASSERT_TRUE(log_) << back << ' ' << at;
      expect_streams_to_agree();
    }
  }
}

TEST_F(ClockRepair, AStepOfOneStreamAloneRejectsRepairedOrNot) {
  write_poses(set_back);
  const Messages expected{
      "logs/t/pose.csv:102: error: column 'time_s': found 'the clock set back by 4.9 s', expected "
      "times that increase, or a step alike at the same instant in both pose.csv and tactile.csv: "
      "what was logged after it cannot be placed"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
  // Steps of both, but not at the same instant, or not by as much.
  write_touches([](std::int64_t ms) { return text_of(ms > 14'000 ? ms - 5000 : ms); });
  read(true);
  EXPECT_FALSE(log_);
  write_touches([](std::int64_t ms) { return text_of(ms > 9950 ? ms - 8000 : ms); });
  read(true);
  EXPECT_FALSE(log_);
}

TEST_F(ClockRepair, AStepOfMergedTicksIsANewSegment) {
  std::string text = "time_s,x_m,y_m,yaw_rad,front_range_m\n";
  for (std::int64_t ms = 0; ms <= 20'000; ms += 100) {
    text += set_back(ms) + "," + text_of(ms / 5) + ",0,0," + text_of(ms) + "\n";
  }
  write("ticks.csv", text);
  read(false);
  EXPECT_FALSE(log_);
  read(true);
  ASSERT_TRUE(log_);
  EXPECT_EQ(log_->merged->time_ns.back(), 20'000 * kMs);
  EXPECT_EQ(std::ranges::count(log_->merged->segment_start, 1), 1);
  EXPECT_EQ(log_->merged->segment_start[100], 1);
}

TEST_F(ClockRepair, ACounterThatBeganAnewIsCountedOn) {
  for (const std::int64_t per_second : {1000, 1'000'000}) {
    const std::int64_t wrap = std::int64_t{1} << 32U;
    const auto stamp = [=](std::int64_t ms) {
      const std::int64_t count =
          (wrap - 10'000 * per_second / 1000 + ms * per_second / 1000) % wrap;
      return std::to_string(count / per_second) + "." +
             std::to_string(per_second + count % per_second).substr(1);
    };
    write_both(stamp);
    const Messages without = read();
    ASSERT_EQ(without.size(), 2U);
    EXPECT_NE(without[0].find(per_second == 1000 ? "counter of milliseconds began anew; --repair"
                                                 : "counter of microseconds began anew; --repair"),
              std::string::npos)
        << without[0];
    read(true);
    ASSERT_TRUE(log_);
    EXPECT_TRUE(log_->breaks_ns.empty()) << "nothing is known to be missing";
    EXPECT_EQ(log_->pose.time_ns.back() - log_->pose.time_ns.front(), 20'000 * kMs);
    expect_streams_to_agree();
  }
}

TEST_F(ClockRepair, NanosecondsJoinedWithoutZerosAreReadAsSuch) {
  const auto unpadded = [](std::int64_t ms) {
    return std::to_string(100 + ms / 1000) + "." + std::to_string(ms % 1000 * 1'000'000 + 3);
  };
  write_both(unpadded);
  const Messages found = read();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0],
            "logs/t/pose.csv:3: error: column 'time_s': found '100.100000003 after 100.3', "
            "expected seconds as "
            "decimals; here seconds and nanoseconds are joined without the zeros between (1.5 for "
            "1.000000005); --repair reads them so");
  read(true);
  ASSERT_TRUE(log_);
  EXPECT_EQ(log_->pose.time_ns[1], 100'100 * kMs + 3);
  EXPECT_EQ(log_->pose.time_ns.back(), 120'000 * kMs + 3);
  expect_streams_to_agree();
}

TEST_F(ClockRepair, WholeSecondsRejectRepairedOrNot) {
  write_poses([](std::int64_t ms) { return std::to_string(ms / 1000); });
  const Messages expected{
      "logs/t/pose.csv:3: error: column 'time_s': found '180 of 201 rows with the time of "
      "another', "
      "expected a time for each row; these are whole seconds: is there a column of nanoseconds, or "
      "of the seconds' fraction?"};
  EXPECT_EQ(read(false), expected);
  EXPECT_EQ(read(true), expected);
}

TEST_F(ClockRepair, RowsInNoOrderRejectRepairedOrNot) {
  write_both([](std::int64_t ms) { return text_of(20'000 - ms); });
  for (const bool repair : {false, true}) {
    const Messages found = read(repair);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NE(found[0].find("expected rows in order of time: sort the file by this column"),
              std::string::npos)
        << found[0];
    EXPECT_EQ(found[0].find("--repair"), std::string::npos);
  }
}

TEST_F(ClockRepair, OnlyPacketsOutOfOrderAreSorted) {
  std::string text = "time_s,x_m,y_m,yaw_rad\n";
  for (std::int64_t ms = 0; ms <= 20'000; ms += 100) {
    const std::int64_t at = ms == 3000 ? 3900 : ms == 3900 ? 3000 : ms;  // 0.9 s late
    text += pose_row(at, text_of(at));
  }
  write("pose.csv", text);
  EXPECT_EQ(
      read(true),
      (Messages{"logs/t/pose.csv:33: warning: column 'time_s': found '9 rows late by up to 0.9 "
                "s', expected rows in order of time; they are sorted"}));
  expect_streams_to_agree();
  bundle_.info.max_gap_s = 0.9;  // a row that late is no packet out of order any more
  read(true);
  EXPECT_FALSE(log_);
}

TEST_F(ClockRepair, RepairIsNotAdvisedWhereItWouldNotHelp) {
  std::string text = "time_s,x_m,y_m,yaw_rad,front_range_m\n0,0,0,0,1\n0.1,0,0,0,1\n0.1,1,0,0,1\n";
  write("ticks.csv", text);
  for (const bool repair : {false, true}) {
    EXPECT_EQ(
        read(repair),
        (Messages{"logs/t/ticks.csv:4: error: column 'time_s': found '0.1 after 0.1', expected "
                  "one row for each time"}));
  }
}

TEST_F(ClockRepair, CommandsOfAClockThatDoesNotStepAreNotUsed) {
  write_both(set_back);
  write("control.csv", "time_s,speed_cmd_mps\n0,0.2\n8,0.1\n");
  read(true);
  ASSERT_TRUE(log_);
  EXPECT_TRUE(log_->control.time_ns.empty());
  std::string control = "time_s,speed_cmd_mps\n";
  for (std::int64_t ms = 0; ms <= 20'000; ms += 200) {
    control += set_back(ms) + ",0.2\n";
  }
  write("control.csv", control);
  read(true);
  ASSERT_TRUE(log_);
  EXPECT_EQ(log_->control.time_ns.back(), log_->pose.time_ns.back());
}

TEST_F(ClockRepair, TimesInMillisecondsAreNamed) {
  write_both([](std::int64_t ms) { return std::to_string(ms); });
  const Messages found = read();
  const auto named = std::ranges::find_if(found, [](const std::string& line) {
    return line.find("a median step") != std::string::npos;
  });
  ASSERT_NE(named, found.end());
  EXPECT_EQ(*named,
            "logs/t/pose.csv:3: warning: column 'time_s': found 'a median step of 100 s', expected "
            "seconds, in steps of at most 1 s; the path is broken at each: milliseconds? If the "
            "stream is so slow, raise max_gap_s (and 199 more)");
  bundle_.info.max_gap_s = 200.0;
  EXPECT_EQ(read(), Messages{});
}

TEST(ShiftsAfterSteps, NeverLeaveTheRangeOfTimes) {
  constexpr std::int64_t kFar = 4'000'000'000'000'000'000;
  for (const std::vector<std::int64_t>& times :
       {std::vector<std::int64_t>{kFar, -kFar, kFar, -kFar},
        std::vector<std::int64_t>{0, kFar, -kFar, 0, kFar},
        std::vector<std::int64_t>{kFar - 1, 0, kFar - 1, 0, kFar - 1}}) {
    const ClockFaults faults = find_clock_faults(times, 1'000'000'000);
    const StreamSteps alone{&faults, median_step_ns(times)};
    EXPECT_FALSE(shifts_after_steps(std::span(&alone, 1), 1'000'000'000));
  }
}

}  // namespace
}  // namespace tcert
