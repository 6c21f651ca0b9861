// What changing one number does in closed loop: each direction is what physics says of it, written
// down before it was tried, but for the forces of a faster robot and of a blind camera, of which
// more had been expected. All worlds are met by both sides of a change.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/study/driven/drive_case.hpp"

namespace tcert::study {
namespace {

constexpr std::uint64_t kWorlds = 40;

/// What one arm did in the worlds, in all.
struct Totals {
  double arrived = 0.0;
  double collided = 0.0;
  double timed_out = 0.0;
  double bumps = 0.0;
  double recoveries = 0.0;
  double peak_force_n = 0.0;  ///< Sum of the trials'.
  double hardest_n = 0.0;     ///< The largest of them.
  double seconds = 0.0;       ///< Of trials that arrived under both.
  double above_s = 0.0;
  std::vector<TrialLog> logs;
  std::vector<bool> arrives;
  std::vector<double> times;
};

using Change = std::function<void(ParameterSet&)>;

Totals drive_all(const std::string& arm, Lighting lighting, const Change& change) {
  DrivenExperiment experiment;
  experiment.arms = parse_arms(arm, {});
  experiment.seed = 12;
  experiment.parameters.drive.time_limit_s = 120.0;
  change(experiment.parameters);
  Totals totals;
  for (std::uint64_t world = 0; world < kWorlds; ++world) {
    DrivenTrial driven = drive_case(experiment, {0, lighting, world}, world);
    const TrialRow& row = driven.trial.row;
    totals.arrived += row.end_reason == EndReason::goal ? 1.0 : 0.0;
    totals.collided += row.end_reason == EndReason::collision ? 1.0 : 0.0;
    totals.timed_out += row.end_reason == EndReason::timeout ? 1.0 : 0.0;
    totals.bumps += driven.events.bumps;
    totals.recoveries += driven.events.recoveries;
    totals.peak_force_n += driven.events.peak_force_n;
    totals.hardest_n = std::max(totals.hardest_n, driven.events.peak_force_n);
    totals.above_s += driven.events.time_above_s;
    totals.arrives.push_back(row.end_reason == EndReason::goal);
    totals.times.push_back(*row.time_s);
    totals.logs.push_back(std::move(driven.trial.log));
  }
  return totals;
}

/// Mean time of the worlds in which both arrive.
std::pair<double, double> times_of(const Totals& a, const Totals& b) {
  double one = 0.0;
  double two = 0.0;
  double both = 0.0;
  for (std::size_t i = 0; i < kWorlds; ++i) {
    if (a.arrives[i] && b.arrives[i]) {
      one += a.times[i];
      two += b.times[i];
      both += 1.0;
    }
  }
  return {one / both, two / both};
}

bool same_drive(const Totals& a, const Totals& b) {
  for (std::size_t i = 0; i < kWorlds; ++i) {
    const TrialLog& one = a.logs[i];
    const TrialLog& two = b.logs[i];
    if (one.pose.time_ns != two.pose.time_ns ||
        one.control.speed_cmd_mps != two.control.speed_cmd_mps ||
        one.control.yaw_rate_cmd_rps != two.control.yaw_rate_cmd_rps) {
      return false;
    }
  }
  return true;
}

class ParameterChanges : public ::testing::Test {
 protected:
  const Totals& as_it_is(const std::string& arm, Lighting lighting = Lighting::indoor) {
    static std::map<std::pair<std::string, Lighting>, Totals> kept;
    const std::pair key(arm, lighting);
    if (!kept.contains(key)) {
      kept.emplace(key, drive_all(arm, lighting, [](ParameterSet&) {}));
    }
    return kept.at(key);
  }
  static void say(const char* what, const Totals& before, const Totals& after) {
    const auto [time, later] = times_of(before, after);
    std::cout << what << ": arrived " << before.arrived << " -> " << after.arrived << ", collided "
              << before.collided << " -> " << after.collided << ", timeouts " << before.timed_out
              << " -> " << after.timed_out << ", bumps " << before.bumps << " -> " << after.bumps
              << ", recoveries " << before.recoveries << " -> " << after.recoveries
              << ", peak force " << before.peak_force_n / kWorlds << " -> "
              << after.peak_force_n / kWorlds << " N, time " << time << " -> " << later << " s\n";
  }
};

TEST_F(ParameterChanges, AWeakerBodyBreaksMoreOften) {
  const Totals& before = as_it_is("M1");
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.drive.crash_force_n = 50.0; });
  say("crash force 120 to 50 N", before, after);
  EXPECT_GT(after.collided, before.collided);
  EXPECT_LT(after.arrived, before.arrived);
}

TEST_F(ParameterChanges, AStifferContactHitsHarder) {
  const Totals& before = as_it_is("M1");
  const Totals after = drive_all(
      "M1", Lighting::indoor, [](ParameterSet& set) { set.drive.contact_damping = 900.0; });
  say("damping of a contact 300 to 900 N s/m", before, after);
  EXPECT_GT(after.peak_force_n, 1.5 * before.peak_force_n);
  EXPECT_GT(after.collided, before.collided);
}

TEST_F(ParameterChanges, ASlowLoopBumpsMore) {
  const Totals& before = as_it_is("M1");
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.drive.latency_ms = 500.0; });
  say("latency 19.6 to 500 ms", before, after);
  EXPECT_GT(after.bumps, before.bumps);
}

TEST_F(ParameterChanges, NoisySensorsBumpMoreAndArriveLess) {
  const Totals& before = as_it_is("TVFH");
  const Totals after =
      drive_all("TVFH", Lighting::indoor, [](ParameterSet& set) { set.drive.noise_scale = 8.0; });
  say("noise 1 to 8, TVFH", before, after);
  EXPECT_LT(after.arrived, before.arrived);
}

TEST_F(ParameterChanges, TooMuchMemoryKeepsM3OutOfGates) {
  const Totals& before = as_it_is("M3");
  const Totals after =
      drive_all("M3", Lighting::indoor, [](ParameterSet& set) { set.policy.risk_weight = 20.0; });
  say("memory weight 0.5 to 20, M3", before, after);
  EXPECT_LT(after.arrived, before.arrived);
}

TEST_F(ParameterChanges, MemoryIsNothingToM1) {
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.policy.risk_weight = 20.0; });
  EXPECT_TRUE(same_drive(as_it_is("M1"), after));
}

TEST_F(ParameterChanges, RoughWallsCostTime) {
  const Totals& before = as_it_is("M1");
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.drive.friction = 2.0; });
  say("friction 0.3 to 2", before, after);
  const auto [time, later] = times_of(before, after);
  EXPECT_GT(later, time);
  EXPECT_GE(after.recoveries, before.recoveries);
}

TEST_F(ParameterChanges, TheStepOfTheBodyIsNoMatter) {
  const Totals& before = as_it_is("M1");
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.drive.step_s = 0.0025; });
  say("step 10 to 2.5 ms", before, after);
  EXPECT_NEAR(after.arrived, before.arrived, 4.0);
  EXPECT_NEAR(after.peak_force_n, before.peak_force_n, 0.1 * before.peak_force_n);
  const auto [time, later] = times_of(before, after);
  EXPECT_NEAR(later, time, 0.05 * time);
}

TEST_F(ParameterChanges, WiderGatesAreFasterAndSafer) {
  const Totals& before = as_it_is("M1");
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.drive.gate_margin_m = 0.2; });
  say("gates 0.06 to 0.2 m wider than the body", before, after);
  EXPECT_GE(after.arrived, before.arrived);
  EXPECT_LT(after.bumps, before.bumps);
  const auto [time, later] = times_of(before, after);
  EXPECT_LT(later, time);
}

TEST_F(ParameterChanges, ABlindCameraHitsHarder) {
  const Totals& before = as_it_is("CB-V", Lighting::dark);
  const Change blind = [](ParameterSet& set) { set.drive.seen_dark = 0.0; };
  const Totals after = drive_all("CB-V", Lighting::dark, blind);
  say("the camera sees 0.6 to 0, CB-V in the dark", before, after);
  EXPECT_GT(after.peak_force_n, before.peak_force_n);
  const auto [time, later] = times_of(before, after);
  EXPECT_LT(later, time) << "it slows for nothing";
  EXPECT_TRUE(same_drive(as_it_is("M1", Lighting::dark), drive_all("M1", Lighting::dark, blind)))
      << "who only feels does not see";
}

TEST_F(ParameterChanges, FasterIsSoonerAndHarder) {
  const Totals& before = as_it_is("M1");
  const Totals after = drive_all(
      "M1", Lighting::indoor, [](ParameterSet& set) { set.policy_overrides.cruise_mps = 0.25; });
  say("cruise 0.177 to 0.25 m/s", before, after);
  const auto [time, later] = times_of(before, after);
  EXPECT_LT(later, 0.9 * time);
  // Most peaks are those of reversals, at 0.1 m/s whatever the cruise. The hardest is a wall met
  // head-on: 300 N s/m times the cruise, and 15 N.
  EXPECT_NEAR(before.hardest_n, 300.0 * 0.177 + 15.0, 2.0);
  EXPECT_NEAR(after.hardest_n, 300.0 * 0.25 + 15.0, 2.0);
}

TEST_F(ParameterChanges, LessTimeIsMoreTimeouts) {
  const Totals& before = as_it_is("M1");
  const Totals after =
      drive_all("M1", Lighting::indoor, [](ParameterSet& set) { set.drive.time_limit_s = 45.0; });
  say("time limit 120 to 45 s", before, after);
  EXPECT_GT(after.timed_out, before.timed_out);
}

TEST_F(ParameterChanges, AForceThatIsOnlyWatchedChangesNothingButItsCount) {
  const Totals& before = as_it_is("M1");
  const Totals after = drive_all(
      "M1", Lighting::indoor, [](ParameterSet& set) { set.drive.watched_force_n = 10.0; });
  EXPECT_TRUE(same_drive(before, after));
  EXPECT_GT(after.above_s, before.above_s);
}

}  // namespace
}  // namespace tcert::study
