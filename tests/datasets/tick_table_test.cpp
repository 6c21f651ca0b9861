#include "datasets/tick_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "datasets/tick_line.hpp"
#include "support/allocations.hpp"

namespace tcert {
namespace {

Robot robot_of_two() {
  Robot robot;
  robot.rays = {{"left", {}, 1.5, 0.6, RayKind::bend, {{0.0, 1.0}, {0.6, 0.0}}},
                {"b0", {}, 0.0, 8.0, RayKind::range, {}}};
  return robot;
}

/// Ticks with any finite value, and many missing ones.
TickTable random_ticks(
    std::mt19937_64& random, std::size_t size, bool force, bool command, bool joint = false) {
  const auto number = [&random]() {
    const auto value = std::bit_cast<double>(random());
    return std::isfinite(value) ? value : 0.25;
  };
  TickTable ticks;
  ticks.rays = 2;
  std::int64_t t = 1'727'800'000'000'000'000;
  for (std::size_t i = 0; i < size; ++i) {
    t += 1 + static_cast<std::int64_t>(random() % 300'000'000);
    ticks.time_ns.push_back(t);
    ticks.poses.push_back({{number(), number()}, number()});
    for (int k = 0; k < 2; ++k) {
      // A range below 0 is missing.
      const double value = k == 0 ? number() : std::abs(number());
      ticks.readings.push_back({random() % 4 == 0 ? kMissing : value,
                                force && k == 0 && random() % 2 == 0 ? number() : kMissing,
                                joint && k == 1 && random() % 3 == 0 ? number() : kMissing});
    }
    const auto now = std::span(ticks.readings).last(2);
    const bool silent = std::ranges::all_of(
        now, [](RayReading r) { return std::isnan(r.value) && std::isnan(r.fsr_n); });
    ticks.stale.push_back(silent || random() % 5 == 0 ? 1 : 0);
    ticks.segment_start.push_back(random() % 9 == 0 ? 1 : 0);
    ticks.speed_cmd_mps.push_back(command ? number() : kMissing);
    ticks.yaw_rate_cmd_rps.push_back(command && i > 0 ? number() : kMissing);
  }
  return ticks;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

void expect_same_tick(const Tick& a, const Tick& b) {
  EXPECT_EQ(a.time_ns, b.time_ns);
  EXPECT_TRUE(same_bits(a.pose.position.x_m, b.pose.position.x_m));
  EXPECT_TRUE(same_bits(a.pose.position.y_m, b.pose.position.y_m));
  EXPECT_TRUE(same_bits(a.pose.yaw_rad, b.pose.yaw_rad));
  ASSERT_EQ(a.rays.size(), b.rays.size());
  for (std::size_t k = 0; k < a.rays.size(); ++k) {
    EXPECT_TRUE(same_bits(a.rays[k].value, b.rays[k].value)) << k;
    EXPECT_TRUE(same_bits(a.rays[k].fsr_n, b.rays[k].fsr_n)) << k;
    EXPECT_TRUE(same_bits(a.rays[k].bearing_rad, b.rays[k].bearing_rad)) << k;
  }
  EXPECT_EQ(a.stale, b.stale);
  EXPECT_EQ(a.segment_start, b.segment_start);
}

TEST(TicksCsv, HasAForceColumnOnlyForARayThatFeelsForce) {
  std::mt19937_64 random(1);
  EXPECT_EQ(TickFormat(robot_of_two(), random_ticks(random, 40, true, false)).header(),
            "time_s,x_m,y_m,yaw_rad,left_bend_rad,left_fsr_n,b0_range_m,stale,segment_start\n");
  EXPECT_EQ(TickFormat(robot_of_two(), random_ticks(random, 40, false, true)).header(),
            "time_s,x_m,y_m,yaw_rad,left_bend_rad,b0_range_m,speed_cmd_mps,yaw_rate_cmd_rps,stale,"
            "segment_start\n");
  EXPECT_EQ(TickFormat(robot_of_two(), random_ticks(random, 40, false, false, true)).header(),
            "time_s,x_m,y_m,yaw_rad,left_bend_rad,b0_range_m,b0_bearing_rad,stale,"
            "segment_start\n");
}

TEST(TicksCsv, WritesOneRowPerTick) {
  TickTable ticks;
  ticks.rays = 2;
  ticks.time_ns = {1'500'000'000};
  ticks.poses = {{{0.1, -2}, 1e-7}};
  ticks.readings = {{0.25, kMissing}, {kMissing, kMissing}};
  ticks.stale = {1};
  ticks.segment_start = {0};
  EXPECT_EQ(to_ticks_csv(robot_of_two(), ticks),
            "time_s,x_m,y_m,yaw_rad,left_bend_rad,b0_range_m,stale,segment_start\n"
            "1.5,0.1,-2,1e-07,0.25,,1,0\n");
}

TEST(TicksCsv, ReadsBackBitForBitAsAFileAndLineByLine) {
  std::mt19937_64 random(2);
  const Robot robot = robot_of_two();
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const TickTable ticks =
        random_ticks(random, 50, round % 2 == 0, round % 3 == 0, round % 5 == 0);
    const std::string text = to_ticks_csv(robot, ticks);
    table::DiagnosticGroups problems;
    const auto read = read_ticks_csv(table::Bytes::copy_of(text), robot, {}, 1.0, problems);
    ASSERT_TRUE(read) << table::to_string(problems.take().front());
    ASSERT_EQ(read->size(), ticks.size());
    EXPECT_EQ(to_ticks_csv(robot, *read), text);

    std::size_t line_begin = text.find('\n') + 1;
    TickLineParser parser(robot, std::string_view(text).substr(0, line_begin), {}, problems);
    ASSERT_TRUE(parser.ready());
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      expect_same_tick((*read)[i], ticks[i]);
      const std::size_t line_end = text.find('\n', line_begin) + 1;
      const auto line =
          parser.parse(std::string_view(text).substr(line_begin, line_end - line_begin), i + 2);
      ASSERT_TRUE(line) << table::to_string(parser.problems().front());
      expect_same_tick(line->tick, ticks[i]);
      EXPECT_TRUE(same_bits(line->speed_cmd_mps, ticks.speed_cmd_mps[i]));
      line_begin = line_end;
    }
  }
}

TEST(TicksCsv, RefusesTimesThatDoNotIncrease) {
  table::DiagnosticGroups problems;
  EXPECT_FALSE(read_ticks_csv(
      table::Bytes::copy_of(
          "time_s,x_m,y_m,yaw_rad,left_bend_rad,b0_range_m\n1,0,0,0,0,0\n1,0,0,0,0,0\n"),
      robot_of_two(),
      {},
      1.0,
      problems));
}

constexpr const char* kHeader = "time_s,x_m,y_m,yaw_rad,left_bend_rad,left_fsr_n,b0_range_m\n";

struct Parsed {
  std::vector<std::string> messages;
  bool good = false;
};

Parsed parse(TickLineParser& parser, std::string_view text, std::size_t line = 2) {
  Parsed parsed;
  parsed.good = parser.parse(text, line).has_value();
  for (const table::Diagnostic& diagnostic : parser.problems()) {
    parsed.messages.push_back(table::to_string(diagnostic));
  }
  return parsed;
}

TEST(TickLineParser, NamesAllThatIsWrongWithALineAndGoesOn) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(), kHeader, {}, problems);
  EXPECT_EQ(
      parse(parser, "0,a,0,,1,1,1\n").messages,
      (std::vector<std::string>{"stdin:2: error: column 'x_m': found 'a', expected a finite number",
                                "stdin:2: error: column 'yaw_rad': expected a finite number"}));
  EXPECT_EQ(parse(parser, "0,1,0\n", 3).messages,
            (std::vector<std::string>{"stdin:3: error: found '3 fields', expected 7 fields"}));
  EXPECT_TRUE(parse(parser, "0,1,0,0,1,1,1\r\n", 4).good);
  EXPECT_EQ(
      parse(parser, "0,1,0,0,1,1,1", 5).messages,
      (std::vector<std::string>{"stdin:5: error: column 'time_s': found '0 after 0', expected "
                                "a time after that of the row before"}));
}

TEST(TickLineParser, AllocatesNothingForAGoodCsvLine) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(), kHeader, {}, problems);
  ASSERT_TRUE(parser.parse("0.123456789,1.25,0.12345678901234567,0,1,1,1\n", 2));
  const std::size_t before = test_support::allocation_count();
  const bool good = parser.parse("0.2,1,0,0,1,1,1\n", 3).has_value() &&
                    parser.parse("0.3,1e-5,0.1234567890123456,0,,,\r\n", 4).has_value();
  EXPECT_EQ(test_support::allocation_count(), before);
  EXPECT_TRUE(good);
}

TEST(TickLineParser, SkipsBlankAndCommentLinesWithoutAProblem) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(), kHeader, {}, problems);
  for (const char* text : {"", "\n", "  \r\n", "# pause"}) {
    const Parsed parsed = parse(parser, text);
    EXPECT_FALSE(parsed.good);
    EXPECT_TRUE(parsed.messages.empty());
  }
}

TEST(TickLineParser, StartsASegmentAfterAGapAsAFileDoes) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(), kHeader, {"stdin", 0.5}, problems);
  EXPECT_FALSE(parser.parse("0,0,0,0,1,1,1", 2)->tick.segment_start);
  EXPECT_FALSE(parser.parse("0.5,0,0,0,1,1,1", 3)->tick.segment_start);
  EXPECT_TRUE(parser.parse("1.1,0,0,0,1,1,1", 4)->tick.segment_start);
}

TEST(TickLineParser, ReadsMissingReadingsAndTruthValuesAsEveryTableDoes) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(),
                        "time_s,x_m,y_m,yaw_rad,left_bend_rad,b0_range_m,stale,segment_start\n",
                        {},
                        problems);
  ASSERT_TRUE(parser.ready());
  const auto line = parser.parse("0,0,0,0,-nan,NA,True,F", 2);
  ASSERT_TRUE(line);
  EXPECT_TRUE(std::isnan(line->tick.rays[0].value));
  EXPECT_TRUE(std::isnan(line->tick.rays[1].value));
  EXPECT_TRUE(line->tick.stale);
  EXPECT_FALSE(line->tick.segment_start);
  EXPECT_TRUE(parser.parse("0.1,0,0,0,1,1,False,nan", 3));
  EXPECT_FALSE(parser.parse("0.2,0,0,0,True,1,0,0", 4)) << "a truth value is no reading";
  EXPECT_FALSE(parser.parse("0.3,0,0,0,null,1,0,0", 5));
  EXPECT_FALSE(parser.parse("0.4,0,0,0,1,1,yes,0", 6));
}

TEST(TickLineParser, IsNotReadyWithoutTheColumns) {
  table::DiagnosticGroups problems;
  const TickLineParser parser(
      robot_of_two(), "time_s,x_m,y_m,yaw_rad,left_bend_rad\n", {}, problems);
  EXPECT_FALSE(parser.ready());
  EXPECT_EQ(problems.take().front().column, "b0_range_m");
}

TEST(TickLineParser, ReadsJsonLinesToTheNanosecond) {
  table::DiagnosticGroups problems;
  const std::string first =
      R"({"time_s":1727800000.123456789,"x_m":0.1,"y_m":-2,"yaw_rad":0,"left_bend_rad":null,)"
      R"("left_fsr_n":1.5,"stale":true})";
  TickLineParser parser(robot_of_two(), first, {}, problems);
  EXPECT_EQ(parser.format(), TickLineFormat::json_lines);
  const auto line = parser.parse(first, 1);
  ASSERT_TRUE(line) << table::to_string(parser.problems().front());
  EXPECT_EQ(line->tick.time_ns, 1'727'800'000'123'456'789);
  EXPECT_EQ(line->tick.pose.position, (Point{0.1, -2}));
  EXPECT_TRUE(std::isnan(line->tick.rays[0].value));
  EXPECT_EQ(line->tick.rays[0].fsr_n, 1.5);
  EXPECT_TRUE(std::isnan(line->tick.rays[1].value));
  EXPECT_TRUE(line->tick.stale);
  EXPECT_TRUE(line->has_footing) << "a later object may have it, and a record is one table";
}

// Nothing within reach, as files say it and as Python writes JSON.
TEST(TickLineParser, TakesInfOfARangeForItsReachAsAFileDoes) {
  table::DiagnosticGroups problems;
  const std::string header = "time_s,x_m,y_m,yaw_rad,left_bend_rad,b0_range_m\n";
  TickLineOptions options;
  options.range_keys = {{}, {{0.0}, 0.05, 60.0}};
  TickLineParser csv(robot_of_two(), header, options, problems);
  TickLineParser json(robot_of_two(), "{}", options, problems);
  const std::vector<std::pair<std::string, double>> readings{
      {"inf", 8.0}, {"-inf", 0.0}, {"0", 8.0}, {"0.01", kMissing}, {"70", kMissing}, {"3", 3.0}};
  int time = 0;
  int json_time = 0;
  for (const auto& [text, expected] : readings) {
    ++time;
    const auto line = csv.parse(std::to_string(time) + ",0,0,0,0.1," + text, 2);
    ASSERT_TRUE(line) << text;
    EXPECT_TRUE(same_bits(line->tick.rays[1].value, expected)) << text;
    const std::string bare = text == "inf" ? "Infinity" : text == "-inf" ? "-Infinity" : text;
    const std::string quoted = text.ends_with("inf") ? '"' + text + '"' : text;
    for (const std::string& value : {bare, quoted}) {
      const std::string stamp = std::to_string(++json_time);
      const auto same = json.parse(R"({"time_s":)" + stamp +
                                       R"(,"x_m":0,"y_m":0,"yaw_rad":0,"left_bend_rad":NaN,)" +
                                       R"("b0_range_m":)" + value + "}",
                                   2);
      ASSERT_TRUE(same) << value;
      EXPECT_TRUE(same_bits(same->tick.rays[1].value, expected)) << value;
      EXPECT_TRUE(std::isnan(same->tick.rays[0].value));
    }
  }
  EXPECT_EQ(csv.range_counts()[1].below_min, 1U);
  EXPECT_EQ(csv.range_counts()[1].above_max, 1U);
  EXPECT_FALSE(csv.parse("50,0,0,0,inf,1", 3)) << "no bend is infinite";
  EXPECT_FALSE(json.parse(R"({"time_s":60,"x_m":Infinity,"y_m":0,"yaw_rad":0})", 4));
}

TEST(TickLineParser, CallsATickStaleAtWhichNoRayReadsAnything) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(), kHeader, {}, problems);
  EXPECT_FALSE(parser.parse("0,0,0,0,,,1", 2)->tick.stale);
  EXPECT_FALSE(parser.parse("0.1,0,0,0,,0.2,", 3)->tick.stale) << "a force is a reading";
  EXPECT_TRUE(parser.parse("0.2,0,0,0,,,", 4)->tick.stale);
  EXPECT_TRUE(parser.parse("0.3,0,0,0,,,-1", 5)->tick.stale) << "no distance";
}

TEST(TickLineParser, NamesAllThatIsWrongWithAJsonLine) {
  table::DiagnosticGroups problems;
  TickLineParser parser(robot_of_two(), "{}", {}, problems);
  EXPECT_EQ(parse(parser, R"({"time_s":"now","x_m":1e999,"y_m":0,"yaw":1,"stale":2})").messages,
            (std::vector<std::string>{
                "stdin:2: error: found '{\"time_s\":\"now\",\"x_m\":1e999,\"y_m\":0,\"yaw...', "
                "expected one "
                "JSON object without nesting, each key once"}));
  EXPECT_EQ(parse(parser, R"({"time_s":"now","x_m":"a","y_m":0,"yaw":1})").messages,
            (std::vector<std::string>{
                "stdin:2: error: column 'time_s': found 'now', expected a time in seconds",
                "stdin:2: error: column 'x_m': found 'a', expected a finite number",
                "stdin:2: error: column 'yaw': expected a known key; did you mean 'yaw_rad'?",
                "stdin:2: error: column 'yaw_rad': expected a finite number"}));
  EXPECT_EQ(parse(parser, R"({"time_s":1,"x_m":0,"y_m":0,"yaw_rad":1,"stale":2})").messages,
            (std::vector<std::string>{"stdin:2: error: column 'stale': expected 0 or 1"}));
  for (const char* text : {"{", "[1]", R"({"time_s":[1]})", R"({"x_m":1,"x_m":2})", "{} {}"}) {
    EXPECT_EQ(parse(parser, text).messages.size(), 1U) << text;
  }
}

}  // namespace
}  // namespace tcert
