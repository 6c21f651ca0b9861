// Logs in columns of foreign names and units, from the bytes to the ticks of a bundle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "datasets/bundle.hpp"
#include "datasets/import/import_log.hpp"
#include "datasets/trial_reader.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kEpochNs = 1'700'000'000'000'000'000;

/// A run straight on at 0.2 m/s, 0.4 m off either wall, heading 30 degrees, as another program
/// writes it: epoch nanoseconds, millimetres, degrees.
void write_run(const test_support::TemporaryFolder& folder, const std::string& name, int rows) {
  std::string odometry = "stamp,pos_x_mm,pos_y_mm,heading_deg\n";
  std::string touch = "stamp,left_mm,right_mm\n";
  for (int i = 0; i < rows; ++i) {
    const std::int64_t time_ns = kEpochNs + i * std::int64_t{100'000'000};
    const double way_mm = 20.0 * i;
    odometry += std::to_string(time_ns) + ',' +
                std::to_string(way_mm * std::cos(std::numbers::pi / 6)) + ',' +
                std::to_string(way_mm * std::sin(std::numbers::pi / 6)) + ",30\n";
    touch += std::to_string(time_ns + 1'000'000) + ",400," + (i % 5 == 0 ? "0" : "410") + "\n";
  }
  folder.write(name + "/odometry.csv", odometry);
  folder.write(name + "/touch.csv", touch);
}

constexpr const char* kMap = R"({
  "robot": {"body_width_m": 0.3},
  "course": {"goal": {"disc": {"x_m": 3.4, "y_m": 2.0, "radius_m": 0.5}}},
  "pose": {"file": "{trial}/odometry.csv",
           "x_m": {"column": "pos_x_mm", "unit": "mm"}, "y_m": {"column": "pos_y_mm", "unit": "mm"},
           "yaw_rad": {"column": "heading_deg", "unit": "deg"}},
  "rays": {"file": "{trial}/touch.csv", "no_return": ["inf", 0], "rays": [
    {"name": "left", "kind": "range", "bearing_deg": 90, "reach_m": 0.5,
     "range_m": {"column": "left_mm", "unit": "mm"}},
    {"name": "right", "kind": "range", "bearing_deg": -90, "reach_m": 0.5,
     "range_m": {"column": "right_mm", "unit": "mm"}}]},
  "trials": {"table": "runs.csv", "id": "run", "success": {"column": "verdict", "true": ["ok"]},
             "time_s": {"column": "took_ms", "unit": "ms"}, "day": "day"}})";

bool says(const std::vector<table::Diagnostic>& all, std::string_view part) {
  return std::ranges::any_of(all, [&](const table::Diagnostic& one) {
    return to_string(one).find(part) != std::string::npos;
  });
}

class ImportCsv : public testing::Test {
 protected:
  test_support::TemporaryFolder folder;
  fs::path output = folder.path() / "bundle";

  LogImportResult import(const std::string& map, const std::string& source = "runs") {
    return import_log({folder.path() / source}, folder.write("map.json", map), output);
  }

  TickTable ticks_of(const std::string& trial_id) const {
    const BundleResult opened = open_bundle(output);
    const auto trial = std::ranges::find(opened.bundle->trials, trial_id, &TrialRow::trial_id);
    const TrialResult log = read_trial(*opened.bundle, *trial);
    EXPECT_TRUE(log.log) << trial_id;
    return log.log ? resample(*log.log) : TickTable{};
  }
};

TEST_F(ImportCsv, MakesMetresRadiansAndSecondsOfWhatItFinds) {
  for (int run = 1; run <= 3; ++run) {
    write_run(folder, "runs/run_0" + std::to_string(run), 200);
  }
  folder.write(
      "runs.csv",
      "run,verdict,took_ms,day\nrun_01,ok,19900,mon\nrun_02,stuck,15000,mon\nrun_03,ok,,tue\n");
  const LogImportResult result = import(kMap);
  ASSERT_TRUE(result.is_written) << (result.diagnostics.empty()
                                         ? ""
                                         : to_string(result.diagnostics.front()));
  EXPECT_FALSE(table::has_error(result.diagnostics));
  ASSERT_EQ(result.trials.size(), 3U);
  EXPECT_EQ(result.trials[0].streams[0].use.used, 200U);
  EXPECT_EQ(result.trials[0].streams[1].ranges.no_return, 40U);

  const BundleResult opened = open_bundle(output);
  ASSERT_TRUE(opened.bundle);
  EXPECT_EQ(opened.bundle->trials[0].success, true);
  EXPECT_EQ(opened.bundle->trials[1].success, false);
  EXPECT_EQ(opened.bundle->trials[1].time_s, 15.0);
  EXPECT_FALSE(opened.bundle->trials[2].time_s);
  EXPECT_EQ(opened.bundle->trials[2].day, "tue");
  EXPECT_TRUE(fs::exists(output / "map.json"));

  const TickTable ticks = ticks_of("run_01");
  ASSERT_GE(ticks.size(), 198U);
  EXPECT_EQ(ticks.time_ns.front(), kEpochNs + 1'000'000);
  EXPECT_NEAR(ticks.poses[100].position.x_m, 2.0 * std::cos(std::numbers::pi / 6), 0.02);
  EXPECT_NEAR(ticks.poses[100].yaw_rad, std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(ticks.readings[2 * 100].value, 0.4, 1e-12);
  // Zeros, which the map declares, are the reach: the median of 0.41 and them is 0.41.
  EXPECT_NEAR(ticks.readings[2 * 100 + 1].value, 0.41, 1e-12);
}

TEST_F(ImportCsv, TakesZerosThatAreNotDeclaredForMissing) {
  write_run(folder, "runs/a", 100);
  std::string map = kMap;
  map.replace(map.find(", 0]"), 4, "]");
  map.replace(map.find(",\n  \"trials\""), map.rfind('}') - map.find(",\n  \"trials\""), "");
  const LogImportResult result = import(map);
  ASSERT_TRUE(result.is_written);
  EXPECT_EQ(result.trials[0].streams[1].ranges.not_ranges, 20U);
  EXPECT_FALSE(result.trials[0].success);
  const TickTable ticks = ticks_of("a");
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_FALSE(ticks.readings[2 * i + 1].value < 0.4) << i;
  }
}

TEST_F(ImportCsv, TellsTrialsByAColumnOfOneFile) {
  std::string text = "run,t,x,y,th,l,r\n";
  for (const char* const run : {"a", "b"}) {
    for (int i = 0; i < 50; ++i) {
      text += std::string(run) + ',' + std::to_string(0.1 * i) + ',' + std::to_string(0.02 * i) +
              ",0,0,0.4,0.4\n";
    }
  }
  folder.write("all.csv", text);
  const LogImportResult result = import(R"({"pose": {"x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"rays": [
      {"name": "l", "kind": "range", "bearing_deg": 90, "reach_m": 1, "range_m": "l"},
      {"name": "r", "kind": "range", "bearing_deg": -90, "reach_m": 1, "range_m": "r"}]},
    "trials": {"split": {"column": "run"}}})",
                                        "all.csv");
  ASSERT_TRUE(result.is_written);
  ASSERT_EQ(result.trials.size(), 2U);
  EXPECT_EQ(ticks_of("a").size(), 50U);
  EXPECT_EQ(ticks_of("b").size(), 50U);
}

TEST_F(ImportCsv, EmptyRowsOfAWideFileAreNoSamples) {
  std::string text = "t,x,y,th,l\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(0.1 * i) + ',' + std::to_string(0.02 * i) + ",0,0,\n";
    if (i < 40 || i >= 60) {
      text += std::to_string(0.1 * i + 0.03) + ",,,,0.4\n";
    }
  }
  folder.write("wide.csv", text);
  const LogImportResult result = import(R"({"pose": {"x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"rays": [{"name": "l", "kind": "range", "bearing_deg": 90, "reach_m": 1,
                       "range_m": "l"}]}})",
                                        "wide.csv");
  ASSERT_TRUE(result.is_written);
  EXPECT_EQ(result.trials[0].streams[0].use.used, 100U);
  EXPECT_EQ(result.trials[0].streams[0].use.empty, 80U);
  EXPECT_EQ(result.trials[0].streams[1].use.used, 80U);
  const TickTable ticks = ticks_of("wide");
  EXPECT_GT(std::ranges::count(ticks.stale, 1), 10);
}

TEST_F(ImportCsv, RejectsATrialWhoseClockIsSetBackAndSaysWhere) {
  std::string text = "t,x,y,th,l\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(0.1 * i - (i >= 50 ? 5.0 : 0.0)) + ',' + std::to_string(0.02 * i) +
            ",0,0,0.4\n";
  }
  folder.write("wide.csv", text);
  const LogImportResult result = import(R"({"pose": {"x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"rays": [{"name": "l", "kind": "range", "bearing_deg": 90, "reach_m": 1,
                       "range_m": "l"}]}})",
                                        "wide.csv");
  EXPECT_FALSE(result.is_written);
  EXPECT_FALSE(fs::exists(output));
  EXPECT_TRUE(says(result.diagnostics, "the clock is set back by 4.9"));
  EXPECT_TRUE(says(result.diagnostics, "at row 52"));
}

TEST_F(ImportCsv, RejectsWholeSeconds) {
  std::string text = "t,x,y,th,l\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(i / 10) + ',' + std::to_string(0.02 * i) + ",0,0,0.4\n";
  }
  folder.write("wide.csv", text);
  const LogImportResult result = import(R"({"pose": {"x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"rays": [{"name": "l", "kind": "range", "bearing_deg": 90, "reach_m": 1,
                       "range_m": "l"}]}})",
                                        "wide.csv");
  EXPECT_FALSE(result.is_written);
  EXPECT_TRUE(says(result.diagnostics, "is there a column of nanoseconds?"));
}

TEST_F(ImportCsv, LosesCommandsOfAnotherClockAndKeepsTheTrial) {
  write_run(folder, "runs/a", 100);
  std::string commands = "t,v,w\n";
  for (int i = 0; i < 100; ++i) {
    commands += std::to_string(0.1 * i) + ",0.2,0\n";
  }
  folder.write("runs/a/cmd.csv", commands);
  std::string map = kMap;
  map.replace(map.find(",\n  \"trials\""),
              map.rfind('}') - map.find(",\n  \"trials\""),
              R"(, "control": {"file": "{trial}/cmd.csv", "speed_cmd_mps": "v",
                 "yaw_rate_cmd_rps": "w"})");
  const LogImportResult result = import(map);
  ASSERT_TRUE(result.is_written);
  EXPECT_TRUE(says(result.diagnostics, "commands of the clock of the pose"));
  EXPECT_FALSE(fs::exists(output / "logs" / "a" / "control.csv"));
}

TEST_F(ImportCsv, NamesColumnsThatAreNotThere) {
  write_run(folder, "runs/a", 100);
  std::string map = kMap;
  map.replace(map.find("pos_x_mm"), 8, "pos_x_m");
  folder.write("runs.csv", "run,verdict,took_ms,day\na,ok,1000,mon\n");
  const LogImportResult result = import(map);
  EXPECT_FALSE(result.is_written);
  EXPECT_TRUE(says(result.diagnostics, "column 'pos_x_m'"));
  EXPECT_TRUE(says(result.diagnostics, "pos_x_mm"));
}

TEST_F(ImportCsv, RejectsTheTrialWhoseFileIsMissingAlone) {
  write_run(folder, "runs/a", 100);
  write_run(folder, "runs/b", 100);
  fs::remove(folder.path() / "runs/a/touch.csv");
  folder.write("runs.csv", "run,verdict,took_ms,day\na,ok,1000,mon\nb,ok,1000,mon\n");
  const LogImportResult result = import(kMap);
  ASSERT_TRUE(result.is_written);
  EXPECT_TRUE(result.trials[0].rejected);
  EXPECT_FALSE(result.trials[1].rejected);
  EXPECT_TRUE(says(result.diagnostics, "touch.csv"));
}

TEST_F(ImportCsv, ARaysOwnNoReturnIsUsedUp) {
  write_run(folder, "runs/a", 100);
  std::string map = kMap;
  map.replace(map.find(", 0]"), 4, "]");
  map.replace(map.find("\"name\": \"right\","), 16, "\"name\": \"right\", \"no_return\": [0],");
  folder.write("runs.csv", "run,verdict,took_ms,day\na,ok,1000,mon\n");
  const LogImportResult result = import(map);
  ASSERT_TRUE(result.is_written);
  EXPECT_EQ(result.trials[0].streams[1].ranges.no_return, 20U);
  EXPECT_EQ(test_support::read_text(output / "bundle.json").find("no_return"), std::string::npos);
}

TEST_F(ImportCsv, SaysReadingsThatAreNoRangeAndWordsThatNoCellHas) {
  write_run(folder, "runs/a", 100);
  std::string map = kMap;
  map.replace(map.find(", 0]"), 4, "]");
  map.replace(map.find("[\"ok\"]"), 6, "[\"okk\"]");
  folder.write("runs.csv", "run,verdict,took_ms,day\na,ok,1000,mon\n");
  const LogImportResult result = import(map);
  EXPECT_TRUE(says(result.diagnostics, "10 % of the readings of rays that are no range"));
  EXPECT_TRUE(says(result.diagnostics, "did you mean 'ok'?"));
}

TEST_F(ImportCsv, RowsOfAnotherLengthCountAsRows) {
  std::string text = "t,x,y,th,l\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(0.1 * i) + (i % 3 == 0 ? ",1\n" : ",1,0,0,0.4\n");
  }
  folder.write("wide.csv", text);
  const LogImportResult result = import(R"({"pose": {"x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"rays": [{"name": "l", "kind": "range", "bearing_deg": 90, "reach_m": 1,
                       "range_m": "l"}]}})",
                                        "wide.csv");
  EXPECT_FALSE(result.is_written);
  EXPECT_TRUE(says(result.diagnostics, "66 of 100 rows of pose"));
}

/// A scan as `rostopic echo -p` writes it, of two beams on either side.
void write_scan(const test_support::TemporaryFolder& folder,
                const std::string& name,
                const std::string& angle_min,
                const std::string& range_max) {
  std::string text =
      "t,x,y,th,field.angle_min,field.angle_increment,field.range_max,field.ranges0,"
      "field.ranges1\n";
  for (int i = 0; i < 60; ++i) {
    text += std::to_string(0.1 * i) + ',' + std::to_string(0.02 * i) + ",0,0," + angle_min +
            ",3.0," + range_max + ",0.4,0.5\n";
  }
  folder.write(name, text);
}

TEST_F(ImportCsv, RejectsATrialOfAnotherScanner) {
  write_scan(folder, "runs/a.csv", "-1.5", "8");
  write_scan(folder, "runs/b.csv", "-1.4", "8");
  write_scan(folder, "runs/c.csv", "-1.5", "4");
  write_scan(folder, "runs/d.csv", "-1.5", "8");
  const LogImportResult result = import(R"({"robot": {"body_width_m": 0.3},
    "pose": {"file": "{trial}.csv", "x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"file": "{trial}.csv", "ranges": "field.ranges{i}", "reach_m": 2}})");
  ASSERT_TRUE(result.is_written);
  ASSERT_EQ(result.trials.size(), 4U);
  EXPECT_FALSE(result.trials[0].rejected);
  EXPECT_TRUE(result.trials[1].rejected);
  EXPECT_TRUE(result.trials[2].rejected);
  EXPECT_FALSE(result.trials[3].rejected);
  EXPECT_TRUE(says(result.diagnostics, "another scanner: 2 beams from -1.4 rad by 3, ? to 8 m"));
  EXPECT_TRUE(says(result.diagnostics, "? to 4 m"));
}

TEST_F(ImportCsv, LeavesOutALastRowThatIsCutInsideANumber) {
  std::string text = "t,x,y,th,l\n";
  for (int i = 0; i < 60; ++i) {
    text += std::to_string(0.1 * i) + ',' + std::to_string(0.02 * i) + ",0,0,0.400\n";
  }
  const std::string map = R"({"pose": {"x_m": "x", "y_m": "y", "yaw_rad": "th"},
    "rays": {"rays": [{"name": "l", "kind": "range", "bearing_deg": 90, "reach_m": 1,
                       "range_m": "l"}]}})";
  text.pop_back();
  folder.write("whole.csv", text);
  LogImportResult result = import(map, "whole.csv");
  ASSERT_TRUE(result.is_written);
  EXPECT_EQ(result.trials[0].streams[1].use.used, 60U) << "a last line may lack its end";
  fs::remove_all(output);
  text.resize(text.size() - 2);
  folder.write("cut.csv", text);
  result = import(map, "cut.csv");
  ASSERT_TRUE(result.is_written);
  EXPECT_EQ(result.trials[0].streams[1].use.used, 59U);
  EXPECT_TRUE(says(result.diagnostics, "cut inside its number"));
}

TEST_F(ImportCsv, ATableThatRefusesTheImportIsSaidBeforeAnyStreamIsRead) {
  write_run(folder, "runs/a", 100);
  folder.write("runs.csv", "run,verdict,took_ms,day\na,ok,soon,mon\n");
  output = folder.path() / "new" / "bundle";
  const LogImportResult result = import(kMap);
  EXPECT_FALSE(result.is_written);
  EXPECT_TRUE(result.trials.empty());
  EXPECT_TRUE(says(result.diagnostics, "found 'soon'"));
  EXPECT_FALSE(fs::exists(folder.path() / "new")) << "nor is anything left behind";
}

TEST_F(ImportCsv, LeavesNoFolderBehindWhenAllTrialsAreRejected) {
  write_run(folder, "runs/a", 5);
  folder.write("runs.csv", "run,verdict,took_ms,day\na,ok,1,mon\n");
  output = folder.path() / "new" / "deeper" / "bundle";
  EXPECT_FALSE(import(kMap).is_written);
  EXPECT_FALSE(fs::exists(folder.path() / "new"));
}

TEST_F(ImportCsv, TakesRowsOfOutcomesByTheNumberInTheName) {
  write_run(folder, "runs/run_07", 100);
  write_run(folder, "runs/run_08", 100);
  folder.write("runs.csv", "run,verdict,took_ms,day\n7,ok,1000,mon\n8,no,1000,mon\n9,ok,1,mon\n");
  const LogImportResult result = import(kMap);
  ASSERT_TRUE(result.is_written);
  EXPECT_EQ(result.trials[0].success, true);
  EXPECT_EQ(result.trials[1].success, false);
  EXPECT_TRUE(says(result.diagnostics, "rows are taken by the number"));
}

}  // namespace
}  // namespace tcert::recording
