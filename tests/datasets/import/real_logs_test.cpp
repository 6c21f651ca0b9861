// Other people's recordings, from their bytes to the ticks of a bundle. Where a recording has no
// sensor that feels walls, one of its columns stands for a ray: what is tested is the way in.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "datasets/bundle.hpp"
#include "datasets/import/import_log.hpp"
#include "datasets/trial_reader.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;

struct Imported {
  LogImportResult result;
  TickTable ticks;  ///< Of the first trial.
};

class RealLogs : public testing::Test {
 protected:
  test_support::TemporaryFolder folder;

  static fs::path log(const std::string& name) {
    return test_support::shared_data() / "logs" / name;
  }

  Imported import(const std::string& source, const std::string& map) const {
    Imported imported;
    const fs::path output = folder.path() / "bundle";
    imported.result = import_log({log(source)}, folder.write("map.json", map), output);
    for (const table::Diagnostic& problem : imported.result.diagnostics) {
      EXPECT_NE(problem.severity, table::Severity::error) << table::to_string(problem);
    }
    if (imported.result.is_written) {
      const BundleResult opened = open_bundle(output);
      const TrialResult read = read_trial(*opened.bundle, opened.bundle->trials.front());
      EXPECT_TRUE(read.log) << (read.diagnostics.empty() ? ""
                                                         : table::to_string(read.diagnostics[0]));
      imported.ticks = read.log ? resample(*read.log) : TickTable{};
    }
    return imported;
  }

  static const StreamUse& use(const Imported& imported, std::size_t stream) {
    return imported.result.trials.front().streams[stream].use;
  }
};

#define SKIP_WITHOUT(name)                                   \
  if (!fs::exists(log(name))) {                              \
    GTEST_SKIP() << "no real log at " << log(name).string(); \
  }

constexpr const char* kTumMap = R"({"pose": {"time": "#1", "x_m": "#2", "y_m": "#3",
  "yaw_rad": {"quaternion": ["#5", "#6", "#7", "#8"]}}, "max_gap_s": 5,
  "rays": {"time": "#1", "rays": [{"name": "z", "kind": "range", "bearing_rad": 0, "reach_m": 9,
                                   "range_m": {"column": "#4", "add": 3}}]}})";

TEST_F(RealLogs, TumTrajectory) {
  SKIP_WITHOUT("evo/V102.txt");
  const Imported imported = import("evo/V102.txt", kTumMap);
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).rows, 807U);
  EXPECT_EQ(use(imported, 0).same_time, 4U);  // the file has four times twice
  EXPECT_EQ(imported.ticks.time_ns.front(), 1403715529112143517);
  EXPECT_NEAR(imported.ticks.poses.front().position.x_m, -0.06151, 1e-9);
  EXPECT_NEAR(imported.ticks.readings.front().value, 3.17712, 1e-9);
}

TEST_F(RealLogs, TumTrajectoryWithNamesInAComment) {
  SKIP_WITHOUT("evo/freiburg1_xyz-groundtruth.txt");
  const Imported imported = import("evo/freiburg1_xyz-groundtruth.txt",
                                   R"({"pose": {"x_m": "tx", "y_m": "ty",
    "yaw_rad": {"quaternion": ["qx", "qy", "qz", "qw"]}},
    "rays": {"rays": [{"name": "z", "kind": "range", "bearing_rad": 0, "reach_m": 9,
                       "range_m": "tz"}]}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).used, 3000U);
  EXPECT_GT(imported.ticks.size(), 290U);
}

TEST_F(RealLogs, EurocTrajectory) {
  SKIP_WITHOUT("evo/V102_groundtruth_first2000.csv");
  const Imported imported = import("evo/V102_groundtruth_first2000.csv",
                                   R"({"pose": {"x_m": "p_RS_R_x [m]", "y_m": "p_RS_R_y [m]",
    "yaw_rad": {"quaternion": ["q_RS_x []", "q_RS_y []", "q_RS_z []", "q_RS_w []"]}},
    "rays": {"rays": [{"name": "z", "kind": "range", "bearing_rad": 0, "reach_m": 9,
                       "range_m": "p_RS_R_z [m]"}]}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).used, 1999U);
  EXPECT_EQ(imported.ticks.time_ns.front(), 1403715524907143168);
  EXPECT_NEAR(imported.ticks.poses.front().position.x_m, 0.515356, 1e-9);
}

TEST_F(RealLogs, McapOfTwoClocks) {
  SKIP_WITHOUT("evo/nav2_turtlebot.mcap");
  const std::string map = R"({"clock": "log", "pose": {"from": "/odom"},
    "rays": {"from": "/odom", "rays": [{"name": "z", "kind": "range", "bearing_rad": 0,
      "reach_m": 9, "range_m": {"column": "pose.pose.position.z", "add": 1}}]}})";
  const Imported imported = import("evo/nav2_turtlebot.mcap", map);
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).rows, 2639U);
  EXPECT_NEAR(1e-9 * static_cast<double>(imported.ticks.time_ns.front()), 1778234353, 2);
  std::string header = map;
  header.replace(header.find("\"log\""), 5, "\"header\"");
  fs::remove_all(folder.path() / "bundle");
  const Imported simulated = import("evo/nav2_turtlebot.mcap", header);
  ASSERT_TRUE(simulated.result.is_written);
  EXPECT_NEAR(1e-9 * static_cast<double>(simulated.ticks.time_ns.front()), 928.8, 1);
}

TEST_F(RealLogs, DatabaseOfTransforms) {
  SKIP_WITHOUT("evo/tf_example.db3");
  const Imported imported =
      import("evo/tf_example.db3",
             R"({"pose": {"from": "/tf", "frame": "base_footprint"}, "max_gap_s": 5,
    "rays": {"from": "/tf", "rays": [{"name": "z", "kind": "range", "bearing_rad": 0,
      "reach_m": 9, "range_m": {"column": "transforms[0].transform.translation.z", "add": 5}}]}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).rows, 517U);
  EXPECT_GT(imported.ticks.size(), 100U);
}

// Its quaternions are (5, 6, 7, 8), no heading: the map names another field.
TEST_F(RealLogs, DatabaseWithoutDefinitions) {
  SKIP_WITHOUT("plotjuggler/rosbag2_test_0.db3");
  const Imported imported = import("plotjuggler/rosbag2_test_0.db3",
                                   R"({"pose": {"from": "/pose", "yaw_rad": "pose.position.z"},
    "rays": {"from": "/pose", "rays": [{"name": "z", "kind": "range", "bearing_rad": 0,
      "reach_m": 99, "range_m": {"column": "pose.position.z", "add": 50}}]}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).used, 1565U);
}

TEST_F(RealLogs, ExportOfRostopic) {
  SKIP_WITHOUT("plotjuggler/fake_joints_first3000.csv");
  const Imported imported = import("plotjuggler/fake_joints_first3000.csv",
                                   R"({"pose": {"x_m": "field.position1", "y_m": "field.position2",
      "yaw_rad": "field.position3"},
    "rays": {"rays": [{"name": "j", "kind": "range", "bearing_rad": 0, "reach_m": 9,
                       "range_m": {"column": "field.position0", "add": 3}}]}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(imported.ticks.time_ns.front(), 1486559106139796569);
}

TEST_F(RealLogs, SparseExportOfPlotJuggler) {
  SKIP_WITHOUT("plotjuggler/turtle.csv");
  const Imported imported = import("plotjuggler/turtle.csv",
                                   R"({"pose": {"x_m": "/turtle1/cmd_vel/linear/x",
      "y_m": "/turtle1/cmd_vel/linear/y", "yaw_rad": "/turtle1/cmd_vel/angular/z"}, "max_gap_s": 60,
    "rays": {"rays": [{"name": "t", "kind": "range", "bearing_rad": 0, "reach_m": 9,
                       "range_m": "/turtle2/cmd_vel/linear/x"}]}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_EQ(use(imported, 0).rows, 356U);
  EXPECT_EQ(use(imported, 0).empty, 207U);
  EXPECT_EQ(use(imported, 1).rows, 207U);
}

// 17 names over 14 values: by their place the values can be had all the same.
TEST_F(RealLogs, FilesOfBagpyOneATopic) {
  SKIP_WITHOUT("bagpy/gps_odom.csv");
  const Imported imported = import("bagpy",
                                   R"({"pose": {"file": "gps_odom.csv", "time": "#1", "x_m": "#5",
      "y_m": "#6", "yaw_rad": {"quaternion": ["#8", "#9", "#10", "#11"]}},
    "rays": {"file": "catvehicle-distanceEstimator-dist.csv", "rays": [{"name": "front",
      "kind": "range", "bearing_rad": 0, "reach_m": 80, "range_m": "data"}]},
    "control": {"file": "catvehicle-cmd_vel.csv", "speed_cmd_mps": "linear.x",
      "yaw_rate_cmd_rps": "angular.z"}})");
  ASSERT_TRUE(imported.result.is_written);
  EXPECT_GT(imported.ticks.size(), 400U);
  EXPECT_NEAR(imported.ticks.poses.front().position.x_m, 505759.7, 1.0);
  // The yaw rate is nan in every row: the speeds are there.
  EXPECT_TRUE(std::ranges::any_of(imported.ticks.speed_cmd_mps,
                                  [](double speed) { return std::isfinite(speed); }));
}

}  // namespace
}  // namespace tcert::recording
