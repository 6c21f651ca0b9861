#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "datasets/check_trial.hpp"
#include "datasets/corpus/write_bundle.hpp"
#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using namespace driven_test;

namespace fs = std::filesystem;

/// Of every other trial a joint moves the frontal tentacle.
DrivenTrial trial_number(std::uint64_t index, bool native_rates) {
  DriveParameters parameters;
  parameters.sweep_rad = index % 2 == 1 ? 1.2 : 0.0;
  DrivenDesign design = design_driven(parameters, 1, index);
  design.algorithm = "line";
  design.native_rates = native_rates;
  return drive_trial(design, LineDriver(design.world));
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void expect_same_ticks(const TickTable& a, const TickTable& b) {
  ASSERT_EQ(a.time_ns, b.time_ns);
  ASSERT_EQ(a.stale, b.stale);
  ASSERT_EQ(a.segment_start, b.segment_start);
  ASSERT_EQ(a.readings.size(), b.readings.size());
  for (std::size_t i = 0; i < a.readings.size(); ++i) {
    ASSERT_TRUE(same(a.readings[i].value, b.readings[i].value));
    ASSERT_TRUE(same(a.readings[i].fsr_n, b.readings[i].fsr_n));
    ASSERT_TRUE(same(a.readings[i].bearing_rad, b.readings[i].bearing_rad));
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.poses[i].position, b.poses[i].position);
    ASSERT_EQ(a.poses[i].yaw_rad, b.poses[i].yaw_rad);
    ASSERT_TRUE(same(a.speed_cmd_mps[i], b.speed_cmd_mps[i]));
    ASSERT_TRUE(same(a.yaw_rate_cmd_rps[i], b.yaw_rate_cmd_rps[i]));
  }
}

class DrivenBundle : public ::testing::TestWithParam<bool> {};

TEST_P(DrivenBundle, ReadsBackWithTheSameTicksAndWithoutADiagnostic) {
  constexpr std::uint64_t kTrials = 8;
  const bool native_rates = GetParam();
  const test_support::TemporaryFolder folder;
  const fs::path path = folder.path() / "driven";
  SimulatedBundle bundle;
  bundle.info = driven_info(1, {}, native_rates);
  bundle.extra_columns = driven_extra_columns();
  bundle.trials = kTrials;
  bundle.simulate = [&](std::uint64_t i) { return trial_number(i, native_rates).trial; };
  write_simulated_bundle(path, bundle, {}, false);

  const BundleResult result = open_bundle(path);
  ASSERT_TRUE(result.bundle);
  EXPECT_TRUE(result.diagnostics.empty()) << table::to_string(result.diagnostics.front());
  EXPECT_TRUE(result.bundle->info.synthetic);
  EXPECT_EQ(result.bundle->extra_columns, driven_extra_columns());
  ASSERT_EQ(result.bundle->trials.size(), kTrials);
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    SCOPED_TRACE(i);
    const SimulatedTrial made = trial_number(i, native_rates).trial;
    const TrialRow& row = result.bundle->trials[i];
    EXPECT_EQ(row.trial_id, made.row.trial_id);
    EXPECT_EQ(row.success, made.row.success);
    EXPECT_EQ(row.time_s, made.row.time_s);
    EXPECT_EQ(row.distance_m, made.row.distance_m);
    EXPECT_EQ(row.end_reason, made.row.end_reason);
    EXPECT_EQ(row.extra, made.row.extra);
    const TrialResult read = read_trial(*result.bundle, row);
    ASSERT_TRUE(read.log);
    EXPECT_TRUE(read.diagnostics.empty()) << table::to_string(read.diagnostics.front());
    expect_same_ticks(resample(made.log), resample(*read.log));
    const TrialCheckResult check = check_trial(*result.bundle, row);
    EXPECT_TRUE(check.diagnostics.empty()) << table::to_string(check.diagnostics.front());
    EXPECT_EQ(check.check.starts_in_start, true);
    EXPECT_EQ(check.check.ends_in_goal, made.row.success);
    const std::string world =
        test_support::read_text(path / "worlds" / (row.extra.front() + ".json"));
    EXPECT_EQ(to_json(world_from_json(world)), world);
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, DrivenBundle, ::testing::Values(false, true));

// The logger changes nothing of the drive, and what it keeps is what was sensed.
TEST(DrivenLogger, KeepsTwentySamplesASecondOfTheSameDrive) {
  const DrivenTrial all = trial_number(3, true);
  const DrivenTrial some = trial_number(3, false);
  EXPECT_EQ(all.trial.row.time_s, some.trial.row.time_s);
  EXPECT_EQ(all.trial.row.extra, some.trial.row.extra);
  const auto rate = [](const std::vector<std::int64_t>& times) {
    return static_cast<double>(times.size() - 1) * 1e9 /
           static_cast<double>(times.back() - times.front());
  };
  EXPECT_NEAR(rate(some.trial.log.tactile.time_ns), 20.0, 1.0);
  EXPECT_NEAR(rate(some.trial.log.control.time_ns), 20.0, 0.1);
  EXPECT_EQ(some.trial.log.pose.time_ns, all.trial.log.pose.time_ns);
  const TactileStream& native = all.trial.log.tactile;
  const TactileStream& thin = some.trial.log.tactile;
  std::size_t at = 0;
  for (std::size_t i = 0; i < thin.time_ns.size(); ++i) {
    while (at < native.time_ns.size() && native.time_ns[at] < thin.time_ns[i]) {
      ++at;
    }
    ASSERT_LT(at, native.time_ns.size());
    ASSERT_EQ(native.time_ns[at], thin.time_ns[i]);
    for (std::size_t k = 0; k < kTentacles; ++k) {
      ASSERT_EQ(native.readings[at * kTentacles + k].value,
                thin.readings[i * kTentacles + k].value);
      ASSERT_EQ(native.readings[at * kTentacles + k].fsr_n,
                thin.readings[i * kTentacles + k].fsr_n);
    }
  }
}

}  // namespace
}  // namespace tcert
