// Slope, step and slip as columns of ticks.csv, in files and line by line.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/tick_line.hpp"
#include "datasets/tick_table.hpp"

namespace tcert {
namespace {

Robot robot_of_one_ray() {
  Robot robot;
  robot.rays = {{"left", {}, 0.5 * std::numbers::pi, 1.0, RayKind::range, {}}};
  return robot;
}

std::optional<TickTable> read(const std::string& text) {
  table::DiagnosticGroups problems;
  table::CsvOptions csv;
  csv.file = "ticks.csv";
  return read_ticks_csv(table::Bytes::copy_of(text), robot_of_one_ray(), csv, 1.0, problems);
}

constexpr const char* kText =
    "slip,time_s,x_m,left_range_m,y_m,yaw_rad,pitch_rad,left_fsr_n\n"
    "0.25,0,1,0.5,2,0.1,-0.2,0\n"
    ",0.1,1.02,0.5,2,0.1,,0\n";

TEST(FootingColumns, AreReadByTheirNamesAndWrittenWhereThereAreAny) {
  const std::optional<TickTable> ticks = read(kText);
  ASSERT_TRUE(ticks);
  ASSERT_EQ(ticks->footing.size(), 2U);
  EXPECT_EQ(ticks->footing[0].slip, 0.25);
  EXPECT_EQ(ticks->footing[0].pitch_rad, -0.2);
  EXPECT_TRUE(std::isnan(ticks->footing[0].roll_rad) && std::isnan(ticks->footing[0].step_m));
  EXPECT_TRUE(std::isnan(ticks->footing[1].slip) && std::isnan(ticks->footing[1].pitch_rad));
  EXPECT_EQ((*ticks)[0].footing.slip, 0.25);
  EXPECT_EQ((*ticks)[0].rays[0].value, 0.5);
  EXPECT_EQ((*ticks)[1].pose.position.x_m, 1.02);
  const std::string written = to_ticks_csv(robot_of_one_ray(), *ticks);
  EXPECT_TRUE(written.starts_with("time_s,x_m,y_m,yaw_rad,pitch_rad,roll_rad,step_m,slip,"))
      << written;
  const std::optional<TickTable> again = read(written);
  ASSERT_TRUE(again);
  EXPECT_EQ(to_ticks_csv(robot_of_one_ray(), *again), written);
}

TEST(FootingColumns, AreNotThereWhereNothingIsMeasured) {
  const std::optional<TickTable> without =
      read("time_s,x_m,y_m,yaw_rad,left_range_m\n0,1,2,0.1,0.5\n");
  ASSERT_TRUE(without);
  EXPECT_TRUE(without->footing.empty());
  EXPECT_TRUE(std::isnan((*without)[0].footing.pitch_rad));
  const std::optional<TickTable> empty =
      read("time_s,x_m,y_m,yaw_rad,left_range_m,step_m\n0,1,2,0.1,0.5,\n");
  ASSERT_TRUE(empty);
  EXPECT_TRUE(empty->footing.empty());
  EXPECT_EQ(to_ticks_csv(robot_of_one_ray(), *empty).find("step_m"), std::string::npos);
}

TEST(FootingColumns, AreTheSameLineByLine) {
  table::DiagnosticGroups problems;
  const std::string text = kText;
  const std::size_t first = text.find('\n');
  const std::size_t second = text.find('\n', first + 1);
  TickLineParser csv(robot_of_one_ray(), text.substr(0, first), {}, problems);
  ASSERT_TRUE(csv.ready());
  const auto line = csv.parse(text.substr(first + 1, second - first - 1), 2);
  ASSERT_TRUE(line);
  EXPECT_TRUE(line->has_footing);
  EXPECT_EQ(line->tick.footing.slip, 0.25);
  EXPECT_EQ(line->tick.footing.pitch_rad, -0.2);
  EXPECT_EQ(line->tick.rays[0].value, 0.5);
  const std::string json =
      R"({"time_s": 0, "x_m": 1, "y_m": 2, "yaw_rad": 0.1, "left_range_m": 0.5, "step_m": 0.04})";
  TickLineParser lines(robot_of_one_ray(), json, {}, problems);
  const auto object = lines.parse(json, 1);
  ASSERT_TRUE(object);
  EXPECT_TRUE(object->has_footing);
  EXPECT_EQ(object->tick.footing.step_m, 0.04);
  EXPECT_TRUE(std::isnan(object->tick.footing.slip));
}

}  // namespace
}  // namespace tcert
