#include "datasets/import_carmen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "datasets/check_trial.hpp"
#include "datasets/trial_reader.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using Messages = std::vector<std::string>;
using test_support::TemporaryFolder;

Messages messages(const std::vector<table::Diagnostic>& diagnostics) {
  Messages out;
  for (const table::Diagnostic& diagnostic : diagnostics) {
    out.push_back(table::to_string(diagnostic));
  }
  return out;
}

/// Four beams; corrected poses beside other odometry.
constexpr const char* kLog =
    "# written by hand\n"
    "PARAM robot_width 0.5 0 host 0\n"
    "ODOM 9 9 9 0 0 0 0.5 host 0.5\n"
    "FLASER 4 1 2 3 81.83 0.5 0 0 9 9 9 1.5 host 1.6\n"
    "FLASER 4 1 2 3 8 1.5 0.25 0.125 9 9 9 3.25 host 3.3\n"
    "ODOM 9 9 9 0 0 0 4 host 4\n";

CarmenLog read(std::string_view text, Messages& problems) {
  table::DiagnosticGroups groups;
  CarmenLog log = read_carmen_log(table::Bytes::copy_of(text), "a.log", groups);
  problems = messages(groups.take());
  return log;
}

TEST(ReadCarmenLog, TakesCorrectedPosesAndCountsTheRest) {
  Messages problems;
  const CarmenLog log = read(kLog, problems);
  EXPECT_EQ(problems, Messages{});
  EXPECT_EQ(log.time_ns, (std::vector<std::int64_t>{1'500'000'000, 3'250'000'000}));
  EXPECT_EQ(log.poses[1].position, (Point{1.5, 0.25}));
  EXPECT_EQ(log.poses[1].yaw_rad, 0.125);
  EXPECT_EQ(log.ranges_m, (std::vector<double>{1, 2, 3, 81.83, 1, 2, 3, 8}));
  EXPECT_EQ(log.odometry_records, 2U);
  EXPECT_EQ(log.other_records, 1U);
}

TEST(ReadCarmenLog, NamesTheLineAndTheFieldOfARecordThatItCannotUse) {
  Messages problems;
  const CarmenLog log = read(
      "FLASER 2 1 2 0 0 0 0 0 0 1 h 1\n"
      "FLASER 2 1 far 0 0 0 0 0 0 2 h 2\n"
      "FLASER 3 1 2 3 0 0 0 0 0 0 3 h 3\n"
      "FLASER 2 1 -2 0 0 0 0 0 0 4 h 4\n"
      "FLASER 2 1 2 0 0 0 0 0 0 0.5 h 5\n"
      "FLASER 1e9 1 2\n"
      "FLASER 2 1 2 0 0 0 0 0\n",
      problems);
  EXPECT_EQ(log.scans(), 1U);
  EXPECT_EQ(
      problems,
      (Messages{"a.log:2: warning: column 'range': found 'far', expected a finite number; the "
                "record is not used",
                "a.log:3: warning: column 'number of beams': found '3', expected as many beams "
                "as the first scan has; the record is not used",
                "a.log:4: warning: column 'range': found '-2', expected a range in metres, 0 or "
                "more; the record is not used",
                "a.log:5: warning: column 'ipc_timestamp': found '0.5 after 1', expected a time "
                "after that of the scan before; the record is not used",
                "a.log:6: warning: column 'number of beams': found '1e9', expected a whole "
                "number, 1 to 4096; the record is not used",
                "a.log:7: warning: column 'odom_theta': expected a finite number; the record is "
                "not used"}));
}

TEST(ReadCarmenLog, RejectsALogWithoutScans) {
  Messages problems;
  EXPECT_EQ(read("ODOM 9 9 9 0 0 0 0.5 host 0.5\n", problems).scans(), 0U);
  EXPECT_EQ(problems,
            (Messages{"a.log: error: found 'no scan', expected at least one FLASER record"}));
}

TEST(CarmenBearing, SpreadsTheBeamsFromRightToLeft) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  EXPECT_NEAR(carmen_bearing_rad(0, 180), -89.5 * kDegree, 1e-12);
  EXPECT_NEAR(carmen_bearing_rad(179, 180), 89.5 * kDegree, 1e-12);
  EXPECT_EQ(carmen_bearing_rad(1, 3), 0.0);
}

TEST(ImportCarmen, WritesABundleThatReadsBack) {
  const TemporaryFolder folder;
  const auto log = folder.write("a.log", kLog);
  CarmenImportOptions options;
  options.trial_id = "lap";
  options.goal = Disc{{1.5, 0.25}, 0.4};
  const CarmenImportResult imported = import_carmen(log, folder.path() / "bundle", options);
  ASSERT_TRUE(imported.summary);
  EXPECT_EQ(messages(imported.diagnostics),
            (Messages{log.string() + ": note: found '2 ODOM records', expected poses from FLASER "
                                     "records; raw odometry is in another frame and is not used"}));
  EXPECT_EQ(imported.summary->clamped_readings, 2U);
  EXPECT_EQ(imported.summary->distance_m, std::hypot(1.0, 0.25));

  const BundleResult opened = open_bundle(folder.path() / "bundle");
  ASSERT_TRUE(opened.bundle) << ::testing::PrintToString(messages(opened.diagnostics));
  EXPECT_TRUE(opened.diagnostics.empty());
  const Bundle& bundle = *opened.bundle;
  EXPECT_EQ(bundle.info.robot.rays.size(), 4U);
  EXPECT_EQ(bundle.info.robot.rays[3].name, "b003");
  EXPECT_EQ(bundle.info.parameters.at("curvature"), "none");
  EXPECT_EQ(std::get<Disc>(*bundle.info.course.start).centre, (Point{0.5, 0}));
  ASSERT_EQ(bundle.trials.size(), 1U);
  EXPECT_EQ(bundle.trials[0].trial_id, "lap");
  EXPECT_EQ(bundle.trials[0].success, std::nullopt);
  EXPECT_EQ(bundle.trials[0].time_s, 1.75);

  const TrialResult trial = read_trial(bundle, bundle.trials[0]);
  ASSERT_TRUE(trial.log);
  EXPECT_TRUE(trial.diagnostics.empty());
  const TickTable ticks = resample(*trial.log);
  ASSERT_EQ(ticks.size(), 2U);
  EXPECT_EQ(ticks[0].rays[3].value, 8.0);
  EXPECT_EQ(ticks[1].time_ns, 3'250'000'000);
  EXPECT_FALSE(ticks[1].segment_start);
}

TEST(ImportCarmen, WritesNothingFromALogWithoutScansAndReplacesNothing) {
  const TemporaryFolder folder;
  const auto empty = folder.write("empty.log", "ODOM 1 2 3\n");
  EXPECT_FALSE(import_carmen(empty, folder.path() / "bundle").summary);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "bundle"));
  EXPECT_FALSE(import_carmen(folder.path() / "none.log", folder.path() / "bundle").summary);
  const auto log = folder.write("a.log", kLog);
  EXPECT_TRUE(import_carmen(log, folder.path() / "bundle").summary);
  EXPECT_THROW(static_cast<void>(import_carmen(log, folder.path() / "bundle")), table::WriteError);
  CarmenImportOptions options;
  options.trial_id = "../x";
  EXPECT_THROW(static_cast<void>(import_carmen(log, folder.path() / "b", options)),
               std::invalid_argument);
}

TEST(ImportCarmen, ReadsTheIntelResearchLabLog) {
  const auto log = test_support::shared_data() / "carmen-intel" / "intel.gfs.log.gz";
  if (!std::filesystem::exists(log)) {
    GTEST_SKIP() << "missing: " << log;
  }
  const TemporaryFolder folder;
  const CarmenImportResult imported = import_carmen(log, folder.path() / "intel");
  ASSERT_TRUE(imported.summary);
  // Four of the 910 scans carry a time before that of the scan above them.
  EXPECT_EQ(imported.summary->scans, 906U);
  EXPECT_EQ(imported.summary->beams, 180U);
  EXPECT_EQ(imported.summary->odometry_records, 14541U);
  ASSERT_EQ(imported.diagnostics.size(), 2U);
  EXPECT_EQ(imported.diagnostics[0].line, 5643U);
  EXPECT_EQ(imported.diagnostics[0].count, 4U);
  EXPECT_GT(imported.summary->median_step_m, 0.5);
  EXPECT_LT(imported.summary->longest_step_m, 1.5);

  const BundleResult opened = open_bundle(folder.path() / "intel");
  ASSERT_TRUE(opened.bundle);
  const TrialResult trial = read_trial(*opened.bundle, opened.bundle->trials[0]);
  ASSERT_TRUE(trial.log);
  EXPECT_TRUE(trial.diagnostics.empty()) << table::to_string(trial.diagnostics.front());
  EXPECT_EQ(trial.log->merged->size(), 906U);
  const TrialCheckResult checked = check_trial(*opened.bundle, opened.bundle->trials[0]);
  EXPECT_TRUE(checked.diagnostics.empty()) << table::to_string(checked.diagnostics.front());
}

}  // namespace
}  // namespace tcert
