#include <table/time_unit.hpp>

#include <gtest/gtest.h>

#include <table/clock_column.hpp>
#include <table/date_cell.hpp>
#include <vector>

namespace tcert::table {
namespace {

std::int64_t time_of(std::string_view cell, TimeUnit unit) {
  std::int64_t time_ns = -1;
  EXPECT_TRUE(read_time(cell, unit, '.', time_ns)) << cell;
  return time_ns;
}

std::int64_t date_of(std::string_view cell) {
  std::int64_t time_ns = -1;
  EXPECT_TRUE(read_date(cell, time_ns)) << cell;
  return time_ns;
}

TEST(ReadTime, IsExactInEveryUnit) {
  EXPECT_EQ(time_of("1486559106139796569", TimeUnit::nanoseconds), 1486559106139796569);
  EXPECT_EQ(time_of("1486559106139796.5", TimeUnit::microseconds), 1486559106139796500);
  EXPECT_EQ(time_of("1486559106139", TimeUnit::milliseconds), 1486559106139000000);
  EXPECT_EQ(time_of("1.403715529112143517e+09", TimeUnit::seconds), 1403715529112143517);
  EXPECT_EQ(time_of("1.5e3", TimeUnit::milliseconds), 1500000000);
  EXPECT_EQ(time_of("-2.5", TimeUnit::seconds), -2500000000);
}

TEST(ReadTime, RefusesWhatIsNone) {
  std::int64_t time_ns = 0;
  for (const char* const cell : {"", "x", "1e", "1e+", "1.5x", "nan", "9e99", "1e5000"}) {
    EXPECT_FALSE(read_time(cell, TimeUnit::milliseconds, '.', time_ns)) << cell;
  }
}

// By GNU date: date -u -d '2021-01-20T10:11:32.332Z' +%s.%N
TEST(ReadDate, ReadsDatesOfIsoAndOfSlashes) {
  EXPECT_EQ(date_of("2021-01-20T10:11:32.332Z"), 1611137492332000000);
  EXPECT_EQ(date_of("2021-01-20 10:11:32.332"), 1611137492332000000);
  EXPECT_EQ(date_of("2021-01-20T11:11:32.332+01:00"), 1611137492332000000);
  EXPECT_EQ(date_of(" 01/20/2021 10:11:32.332"), 1611137492332000000);
  EXPECT_EQ(date_of("20.1.2021 10:11:32"), 1611137492000000000);
  std::int64_t none_ns = 0;
  EXPECT_FALSE(read_date("2021-02-30T00:00:00Z", none_ns));
  EXPECT_FALSE(read_date("2100-02-29T00:00:00Z", none_ns));
  EXPECT_EQ(date_of("2000-02-29T00:00:00Z"), 951782400000000000);
  EXPECT_EQ(date_of("1970-01-01T00:00:00Z"), 0);
}

TEST(ReadDate, RefusesWhatIsNone) {
  std::int64_t time_ns = 0;
  for (const char* const cell : {"",
                                 "2021",
                                 "2021-01-20",
                                 "2021-13-20T10:00:00Z",
                                 "2021-01-20T25:00:00Z",
                                 "12.5",
                                 "2021-01-20T10:11:32.Z",
                                 "2021-01-20T10:11:32+1",
                                 "run 7"}) {
    EXPECT_FALSE(read_date(cell, time_ns)) << cell;
  }
}

TEST(GuessTimeUnit, GoesBySizeSince1970) {
  const auto unit = [](double time) {
    return guess_time_unit(std::nullopt, std::vector<double>{time, time + 1}).unit;
  };
  EXPECT_EQ(unit(1.6e9), TimeUnit::seconds);
  EXPECT_EQ(unit(1.6e12), TimeUnit::milliseconds);
  EXPECT_EQ(unit(1.6e15), TimeUnit::microseconds);
  EXPECT_EQ(unit(1.6e18), TimeUnit::nanoseconds);
}

TEST(GuessTimeUnit, GoesByTheStepOfWholeNumbersSinceTheStart) {
  const auto unit = [](double step) {
    return guess_time_unit(std::nullopt, std::vector<double>{0, step, 2 * step, 3 * step}).unit;
  };
  EXPECT_EQ(unit(100000), TimeUnit::microseconds);
  EXPECT_EQ(unit(20), TimeUnit::milliseconds);
  EXPECT_EQ(unit(100000000), TimeUnit::nanoseconds);
  EXPECT_EQ(unit(5), TimeUnit::milliseconds);
  EXPECT_EQ(unit(1), TimeUnit::seconds);
  EXPECT_EQ(guess_time_unit(TimeUnit::seconds, std::vector<double>{0, 20, 40}).unit,
            TimeUnit::seconds);
}

TEST(GuessTimeUnit, BelievesTheNameWhereThatIsPossible) {
  const auto unit = [](TimeUnit named, double time) {
    return guess_time_unit(named, std::vector<double>{time, time + 1e5}).unit;
  };
  EXPECT_EQ(unit(TimeUnit::microseconds, 1.5e9), TimeUnit::microseconds);
  EXPECT_EQ(unit(TimeUnit::nanoseconds, 1.5e12), TimeUnit::nanoseconds);
  EXPECT_EQ(unit(TimeUnit::seconds, 1.6e18), TimeUnit::nanoseconds);
}

TEST(FindClock, KnowsTheNamesOfTheTools) {
  for (const char* const name : {"time",
                                 "time_s",
                                 "Time (s)",
                                 "%time",
                                 "__time",
                                 "time [s]",
                                 "header.stamp",
                                 "field.header.stamp",
                                 "TimeUS",
                                 "rosbagTimestamp",
                                 "timestamp",
                                 "t",
                                 "t_ms",
                                 "Timestamp",
                                 "stamp",
                                 "millis"}) {
    EXPECT_TRUE(is_clock_name(name)) << name;
  }
  for (const char* const name : {"x",
                                 "travel_time_s",
                                 "uptime",
                                 "theta",
                                 "ms",
                                 "s",
                                 "",
                                 "nsec",
                                 "response_time",
                                 "lifetime"}) {
    EXPECT_FALSE(is_clock_name(name)) << name;
  }
}

TEST(FindClock, FindsTheUnitAndTheNanoseconds) {
  EXPECT_EQ(find_clock({"x", "TimeUS"})->named_unit, TimeUnit::microseconds);
  const auto pair = find_clock({"header.stamp.sec", "header.stamp.nanosec", "x"});
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->column, 0U);
  EXPECT_EQ(pair->nanoseconds, 1U);
  EXPECT_FALSE(find_clock({"time_s", "time_ns"})->nanoseconds);
  EXPECT_FALSE(find_clock({"x", "y"}));
}

}  // namespace
}  // namespace tcert::table
