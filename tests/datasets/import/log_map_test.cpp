#include "datasets/import/log_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace tcert::recording {
namespace {

struct Parsed {
  std::optional<LogMap> map;
  std::vector<table::Diagnostic> problems;

  [[nodiscard]] bool names(std::string_view column, std::string_view expectation = "") const {
    return std::ranges::any_of(problems, [&](const table::Diagnostic& problem) {
      return problem.column == column && problem.expectation.find(expectation) != std::string::npos;
    });
  }
};

Parsed parse(const std::string& text) {
  table::DiagnosticGroups problems;
  Parsed parsed;
  parsed.map = parse_log_map(text, "map.json", problems);
  parsed.problems = problems.take();
  return parsed;
}

constexpr const char* kBag = R"({"clock": "header", "pose": {"from": "/odom"},
  "rays": {"from": "/scan", "every": 4, "no_return": ["inf", 0], "offset": "tf_static"},
  "control": {"from": "/cmd_vel"}, "robot": {"body_width_m": 0.3}, "max_gap_s": 2})";

TEST(LogMap, ReadsTopics) {
  const Parsed parsed = parse(kBag);
  ASSERT_TRUE(parsed.map) << parsed.problems.size();
  const LogMap& map = *parsed.map;
  EXPECT_TRUE(map.header_clock);
  EXPECT_EQ(map.pose.topic, "/odom");
  ASSERT_EQ(map.rays.size(), 1U);
  ASSERT_TRUE(map.rays[0].scan);
  EXPECT_EQ(map.rays[0].scan->every, 4U);
  EXPECT_TRUE(map.rays[0].scan->offset.by_transforms);
  EXPECT_EQ(map.rays[0].no_return.values, std::vector<double>{0.0});
  EXPECT_EQ(map.control->topic, "/cmd_vel");
  EXPECT_EQ(map.bundle.at("robot").at("body_width_m"), 0.3);
  EXPECT_EQ(map.bundle.at("max_gap_s"), 2);
}

TEST(LogMap, ReadsColumnsWithUnits) {
  const Parsed parsed = parse(R"({"pose": {"file": "{trial}/odom.csv",
    "time": {"column": ["sec", "nanosec"]}, "x_m": {"column": "x", "unit": "mm"},
    "y_m": {"column": "#3", "scale": 2, "add": -1}, "yaw_rad": {"quaternion": ["a", "b", "c", "d"]}},
    "rays": [{"file": "{trial}/t.csv", "time": {"column": "t", "unit": "iso", "origin": "first"},
      "rays": [{"name": "l", "kind": "bend", "bearing_deg": 90, "reach_m": 0.3,
                "bend_rad": {"column": "lb", "unit": "deg"}, "fsr_n": {"column": "lf", "unit": "g"},
                "calibration": {"bend_rad": [0, 1], "clearance_m": [0.3, 0]}}]}],
    "trials": {"table": "o.csv", "id": "run", "success": {"column": "r", "true": ["ok"]},
               "time_s": {"column": "ms", "unit": "ms"}}})");
  ASSERT_TRUE(parsed.map);
  const LogMap& map = *parsed.map;
  EXPECT_EQ(map.pose.time.columns.size(), 2U);
  EXPECT_DOUBLE_EQ(map.pose.values[0].scale, 0.001);
  EXPECT_DOUBLE_EQ(map.pose.values[1].scale, 2.0);
  EXPECT_DOUBLE_EQ(map.pose.values[1].add, -1.0);
  EXPECT_TRUE(map.pose.values[2].is_quaternion());
  const MappedRay& ray = map.rays[0].rays[0];
  EXPECT_TRUE(map.rays[0].time.dates);
  EXPECT_TRUE(map.rays[0].time.from_first);
  EXPECT_DOUBLE_EQ(ray.ray.at("bearing_rad").get<double>(), std::numbers::pi / 2);
  EXPECT_FALSE(ray.ray.contains("bearing_deg"));
  EXPECT_FALSE(ray.ray.contains("bend_rad"));
  EXPECT_TRUE(ray.ray.contains("calibration"));
  EXPECT_DOUBLE_EQ(ray.value.scale, std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(ray.force.scale, 0.00980665);
  EXPECT_DOUBLE_EQ(map.trials.outcomes[1].scale, 0.001);
}

TEST(LogMap, NamesEveryKeyThatIsWrong) {
  const Parsed parsed = parse(R"({"clock": "both", "pose": {"from": "/odom", "file": "x.csv"},
    "rays": {"from": "/scan", "evry": 4, "no_return": "inf"},
    "control": {"from": "/c", "speed_cmd_mps": {"column": "v", "unit": "deg"}}})");
  EXPECT_FALSE(parsed.map);
  EXPECT_TRUE(parsed.names("clock"));
  EXPECT_TRUE(parsed.names("pose.file"));
  EXPECT_TRUE(parsed.names("rays.evry", "'every'"));
  EXPECT_TRUE(parsed.names("rays.no_return"));
  EXPECT_TRUE(parsed.names("control.speed_cmd_mps.unit", "m/s, cm/s"));
}

TEST(LogMap, RefusesAMixtureOfTopicsAndFiles) {
  const Parsed parsed = parse(R"({"pose": {"from": "/odom"}, "rays": {"file": "r.csv",
    "ranges": "r{i}"}})");
  EXPECT_TRUE(parsed.names("pose", "all topics"));
}

TEST(LogMap, RefusesKeysThatWouldNotCount) {
  const Parsed bags = parse(R"({"pose": {"from": "/odom", "time": "t"}, "rays": {"from": "/scan",
    "every": 2, "rays": [{"name": "l", "kind": "range", "range_m": "range"}]},
    "trials": {"split": {"column": "run"}}})");
  EXPECT_TRUE(bags.names("pose.time", "the clock of topics"));
  EXPECT_TRUE(bags.names("rays.every", "these rays are listed"));
  EXPECT_TRUE(bags.names("trials", "each bag"));
  const Parsed files = parse(R"({"pose": {"file": "{trial}/p.csv", "x_m": "x", "y_m": "y",
    "yaw_rad": "h", "frame": "b", "time": {"column": ["s", "n"], "unit": "ms"}},
    "rays": {"file": "r.csv", "offset": {"x_m": 1}, "reach_m": 2, "rays": [
      {"name": "l", "kind": "range", "range_m": "l"}]}, "trials": {"split": {"column": "run"}}})");
  EXPECT_TRUE(files.names("pose.frame", "only topics"));
  EXPECT_TRUE(files.names("pose.time.unit", "no unit"));
  EXPECT_TRUE(files.names("rays.offset", "these rays are listed"));
  EXPECT_TRUE(files.names("rays.reach_m", "these rays are listed"));
  EXPECT_TRUE(files.names("trials", "each file of a pattern"));
}

TEST(LogMap, RefusesAPoseOrARayWithoutItsColumnAndFilesElsewhere) {
  const Parsed parsed = parse(R"({"pose": {"file": "/tmp/p.csv", "x_m": "x", "y_m": "y"},
    "rays": {"file": "../r.csv", "rays": [{"name": "l", "kind": "range", "reach_m": 1}]}})");
  EXPECT_TRUE(parsed.names("pose.yaw_rad", "a column"));
  EXPECT_TRUE(parsed.names("pose.file", "below the source"));
  EXPECT_TRUE(parsed.names("rays.file", "below the source"));
  EXPECT_TRUE(parsed.names("rays.rays[0]", "range_m"));
}

TEST(LogMap, RequiresPoseAndRays) {
  const Parsed parsed = parse("{}");
  EXPECT_TRUE(parsed.names("pose"));
  EXPECT_TRUE(parsed.names("rays"));
  EXPECT_FALSE(parse("[]").map);
  EXPECT_FALSE(parse("{").map);
}

}  // namespace
}  // namespace tcert::recording
