// Real benchmark worlds, if their folder is there.

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <table/csv.hpp>

#include "analysis/study/truth/obstacle_distance.hpp"
#include "analysis/study/truth/truth.hpp"
#include "datasets/worlds/world_files.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::study {
namespace {

double number(const std::string& text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

using Paths = std::map<std::string, std::vector<Point>>;

Paths reference_paths(const std::filesystem::path& file) {
  Paths paths;
  const table::TextTableResult read =
      table::read_text_table(file, {"world", "gazebo_x_m", "gazebo_y_m"});
  for (std::size_t row = 0; read.table && row < read.table->rows(); ++row) {
    const auto cell = [&](const char* name) {
      return read.table->at(row, *read.table->find(name));
    };
    paths[cell("world")].push_back({number(cell("gazebo_x_m")), number(cell("gazebo_y_m"))});
  }
  return paths;
}

TEST(BenchmarkWorlds, NoBarnReferencePathBeatsTheTruth) {
  const auto folder = test_support::shared_data() / "barn-worlds";
  if (!std::filesystem::exists(folder / "cylinders.csv")) {
    GTEST_SKIP() << "no " << folder / "cylinders.csv";
  }
  WorldFrame frame;
  frame.start = Disc{{-2.25, 3.0}, 0.25};
  frame.goal = Disc{{-2.25, 13.0}, 1.0};
  const WorldsResult read = read_worlds(folder / "cylinders.csv", frame);
  ASSERT_TRUE(read.diagnostics.empty()) << table::to_string(read.diagnostics.front());
  ASSERT_EQ(read.worlds.size(), 300U);
  const Paths paths = reference_paths(folder / "reference_paths.csv");
  ASSERT_EQ(paths.size(), 300U);
  for (const World& world : read.worlds) {
    const ObstacleDistance obstacles(world);
    const ClearanceValue truth = exact_disc_clearance(world);
    const ClearanceValue grid = grid_clearance(world, 0.025).value;
    EXPECT_LE(truth.clearance_m, grid.upper_m + 1e-12) << world.name;
    EXPECT_GE(truth.clearance_m, grid.lower_m - 1e-12) << world.name;
    double clearance = HUGE_VAL;
    for (const Point p : paths.at(world.name)) {
      clearance = std::min(clearance, obstacles.at(p));
    }
    EXPECT_LE(clearance, truth.clearance_m + 1e-9) << world.name;
  }
}

struct Maze {
  const char* file;
  double width;  ///< Of the corridors, cells.
  int goal_row;
  int goal_column;
};

class Mazes : public testing::TestWithParam<Maze> {};

TEST_P(Mazes, ClearanceIsTheWidthOfTheCorridors) {
  const auto path = test_support::shared_data() / "movingai" / GetParam().file;
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << "no " << path;
  }
  const double width = GetParam().width;
  WorldFrame frame;
  // Corridors alternate with walls of one cell, from the top left corner on; what is left over at
  // the right and at the bottom is narrower or wider, so the goal lies where no way leads through
  // it.
  const auto middle = [&](int corridor) { return 1.0 + (width + 1.0) * corridor + 0.5 * width; };
  frame.start = Disc{{middle(0), 512.0 - middle(0)}, 0.3};
  frame.goal = Disc{{middle(GetParam().goal_column), 512.0 - middle(GetParam().goal_row)}, 0.3};
  const WorldsResult read = read_worlds(path, frame);
  ASSERT_EQ(read.worlds.size(), 1U)
      << (read.diagnostics.empty() ? "" : table::to_string(read.diagnostics.front()));
  const double step = 0.25;
  const ClearanceValue value = grid_clearance(read.worlds.front(), step).value;
  EXPECT_LE(value.lower_m, 0.5 * width);
  EXPECT_GE(value.upper_m, 0.5 * width);
  EXPECT_NEAR(value.clearance_m, 0.5 * width, std::sqrt(2.0) * step);
  Robot robot;
  const double slack =
      clearance_slack(value.clearance_m, robot.body_width_m, SlackConvention::width);
  EXPECT_NEAR(slack, width - robot.body_width_m, 2.0 * std::sqrt(2.0) * step);
}

INSTANTIATE_TEST_SUITE_P(MovingAi,
                         Mazes,
                         testing::Values(Maze{"maze512-1-0.map", 1.0, 7, 227},
                                         Maze{"maze512-8-0.map", 8.0, 16, 50},
                                         Maze{"maze512-32-0.map", 32.0, 6, 14}),
                         [](const auto& test) {
                           return "width" + std::to_string(static_cast<int>(test.param.width));
                         });

}  // namespace
}  // namespace tcert::study
