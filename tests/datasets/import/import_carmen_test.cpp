#include "datasets/import/import_carmen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "datasets/check_trial.hpp"
#include "datasets/trial_reader.hpp"
#include "support/carmen_text.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using test_support::kCarmenLog;
using test_support::Messages;
using test_support::messages;
using test_support::TemporaryFolder;

CarmenImportOptions four_beams() {
  CarmenImportOptions options;
  options.reading.fov_rad = std::numbers::pi;
  return options;
}

TEST(ImportCarmen, WritesABundleThatReadsBack) {
  const TemporaryFolder folder;
  const auto log = folder.write("a.log", kCarmenLog);
  CarmenImportOptions options = four_beams();
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
  const auto log = folder.write("a.log", kCarmenLog);
  EXPECT_FALSE(import_carmen(log, folder.path() / "bundle").summary) << "no field of view";
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "bundle"));
  CarmenImportOptions options = four_beams();
  EXPECT_TRUE(import_carmen(log, folder.path() / "bundle", options).summary);
  EXPECT_THROW(static_cast<void>(import_carmen(log, folder.path() / "bundle", options)),
               table::WriteError);
  options.trial_id = "../x";
  EXPECT_THROW(static_cast<void>(import_carmen(log, folder.path() / "b", options)),
               std::invalid_argument);
}

/// A raw log: each pose is the record of the odometry before it, in both places of the record.
TEST(ImportCarmen, SaysOfPosesThatAreTheOdometryThatTheyAreNotScanMatched) {
  std::string raw;
  for (int i = 0; i < 12; ++i) {
    const std::string x = std::to_string(0.5 * i);
    const std::string second = std::to_string(i + 1);
    raw += "ODOM " + x + " 0 0 0.5 0 0 " + second + ".0 host 1\n";
    raw += test_support::flaser("5 1.5 1.5 2.5 1.5 1.5", 0.5 * i, second + ".1", 1);
  }
  const TemporaryFolder folder;
  const CarmenImportResult imported =
      import_carmen(folder.write("raw.log", raw), folder.path() / "raw", four_beams());
  ASSERT_TRUE(imported.summary);
  ASSERT_EQ(imported.diagnostics.size(), 1U);
  const std::string said = table::to_string(imported.diagnostics[0]);
  EXPECT_NE(said.find("warning: found 'poses that lie on the way of its 12 ODOM records'"),
            std::string::npos);
  EXPECT_NE(said.find("these poses are the odometry: not scan-matched"), std::string::npos);
  const std::string provenance = open_bundle(folder.path() / "raw").bundle->info.provenance;
  EXPECT_EQ(provenance.find("corrected"), std::string::npos) << provenance;
  EXPECT_NE(provenance.find("they were not scan-matched"), std::string::npos) << provenance;
}

TEST(ImportCarmen, ClaimsNothingOfPosesWithoutOdometry) {
  const TemporaryFolder folder;
  const auto log = folder.write("a.log", test_support::flaser("2 1 1", 0.0, "1", 1));
  ASSERT_TRUE(import_carmen(log, folder.path() / "a", four_beams()).summary);
  const std::string provenance = open_bundle(folder.path() / "a").bundle->info.provenance;
  EXPECT_EQ(provenance.find("corrected"), std::string::npos) << provenance;
  EXPECT_NE(provenance.find("cannot be told"), std::string::npos) << provenance;
}

TEST(ImportCarmen, WritesNothingWhereStampsCarryNoOrderAndMakesThemFromTheOrderIfAsked) {
  std::string rounded;
  for (std::size_t i = 0; i < 20; ++i) {
    rounded += test_support::flaser("2 1 inf", 0.5 * static_cast<double>(i), "1.01893e+09", 7);
  }
  const TemporaryFolder folder;
  const auto log = folder.write("rounded.log", rounded);
  CarmenImportOptions options = four_beams();
  const CarmenImportResult refused = import_carmen(log, folder.path() / "a", options);
  EXPECT_FALSE(refused.summary);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a"));
  options.reading.clock = CarmenClock::order;
  options.reading.rate_hz = 5.0;
  const CarmenImportResult made = import_carmen(log, folder.path() / "a", options);
  ASSERT_TRUE(made.summary);
  EXPECT_EQ(made.summary->scans, 20U);
  EXPECT_EQ(made.summary->clamped_readings, 20U) << "no return is the reach";
  EXPECT_NEAR(made.summary->duration_s, 3.8, 1e-12);
  const BundleResult opened = open_bundle(folder.path() / "a");
  EXPECT_NE(opened.bundle->info.provenance.find("from the order of its records, 5 a second"),
            std::string::npos);
  const TrialResult trial = read_trial(*opened.bundle, opened.bundle->trials[0]);
  ASSERT_TRUE(trial.log);
  EXPECT_EQ(trial.log->merged->size(), 20U);
}

TEST(ImportCarmen, MountsTheRaysWhereTheLaserIsAndTrustsItNoFurtherThanItReaches) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const std::string x = std::to_string(i);
    text += "ROBOTLASER1 4 -0.5 1 0.5 5.6 0.01 0 3 1 9 2 0 " + std::to_string(i + 0.25) +
            " 0.1 0.25 " + x + " 0 0 0 0 0 0 0 " + x + " h " + x + "\n";
  }
  const TemporaryFolder folder;
  const CarmenImportResult made = import_carmen(folder.write("a.log", text), folder.path() / "a");
  ASSERT_TRUE(made.summary) << ::testing::PrintToString(messages(made.diagnostics));
  EXPECT_EQ(made.summary->reach_m, 5.6);
  EXPECT_EQ(made.summary->clamped_readings, 3U);
  const Robot robot = open_bundle(folder.path() / "a").bundle->info.robot;
  ASSERT_EQ(robot.rays.size(), 3U);
  EXPECT_NEAR(robot.rays[0].bearing_rad, -0.25, 1e-12);
  EXPECT_NEAR(robot.rays[2].bearing_rad, 0.75, 1e-12);
  EXPECT_NEAR(robot.rays[1].mount.x_m, 0.25, 1e-12);
  EXPECT_NEAR(robot.rays[1].mount.y_m, 0.1, 1e-12);
  EXPECT_EQ(robot.rays[1].reach_m, 5.6);
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
