#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

/// Two rays whose clearance is 0.6 - 0.5 bend, and `days` of which day d reads d mm too much.
std::string pairs(int days) {
  std::string text = "ray,run,day,bend_rad,clearance_m\n";
  for (int day = 1; day <= days; ++day) {
    for (int i = 0; i <= 24; ++i) {
      const double bend = 0.05 * i;
      for (const char* ray : {"left", "right"}) {
        text += std::string(ray) + ",1,day" + std::to_string(day) + "," + std::to_string(bend) +
                "," + std::to_string(0.6 - 0.5 * bend - 0.001 * day + 0.022) + "\n";
      }
    }
  }
  return text;
}

constexpr const char* kBundle =
    R"({"format": "tcert-bundle", "version": 1, "robot": {"body_width_m": 0.45, "min_turn_radius_m": 0.35},
 "rays": [
  {"name": "left", "kind": "bend", "mount_x_m": 0.2, "mount_y_m": 0.1, "bearing_rad": 1.5708,
   "reach_m": 0.6, "calibration": {"bend_rad": [0, 1.2], "clearance_m": [0.6, 0]}},
  {"name": "right", "kind": "bend", "mount_x_m": 0.2, "mount_y_m": -0.1, "bearing_rad": -1.5708,
   "reach_m": 0.4, "calibration": {"bend_rad": [0, 1.2], "clearance_m": [0.4, 0]}},
  {"name": "sonar", "kind": "range", "mount_x_m": 0.3, "mount_y_m": 0, "bearing_rad": 0, "reach_m": 2}]})";

TEST(Calibrate, RaysGiveTheListOfABundleWithABoundOfNineteenDays) {
  Workdir work(TCERT_BINARY);
  work.write("pairs.csv", pairs(21));
  work.write("logs/bundle.json", kBundle);
  const ProcessResult run =
      work.run({"calibrate", "rays", "pairs.csv", "--bundle", "logs", "--output", "cal/"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  const json rays = json::parse(work.read("cal/rays.json"));
  ASSERT_EQ(rays.size(), 3U);
  EXPECT_EQ(rays[0]["name"], "left");
  EXPECT_EQ(rays[0]["mount_x_m"], 0.2) << "all of the ray, ready to be pasted";
  EXPECT_EQ(rays[2]["kind"], "range");
  // In the place of the old ones it is a bundle.
  json bundle = json::parse(kBundle);
  bundle["rays"] = rays;
  work.write("pasted/bundle.json", bundle.dump());
  work.write("pasted/trials.csv", "trial_id,success,time_s\na,1,2\n");
  EXPECT_NE(work.run({"check", "pasted"}).exit_code, 65) << "its one trial has no log; it opens";
  EXPECT_EQ(json::parse(work.read("logs/bundle.json")), json::parse(kBundle)) << "untouched";

  const json report = json::parse(work.read("cal/report.json"));
  EXPECT_EQ(report["rays"], rays);
  EXPECT_EQ(report["summary"]["bound_days"], 19);
  EXPECT_EQ(report["summary"]["rank"], 19);
  EXPECT_EQ(report["summary"]["coverage"], 0.95);
  EXPECT_NEAR(report["summary"]["coverage_low"].get<double>(), std::pow(0.05, 1.0 / 19.0), 1e-9);
  EXPECT_EQ(report["ray_days"].size(), 19U);
  // Two days make the curves, so that q is at most 20 mm and at least that of the 19th of 21 days.
  const double q = report["summary"]["q_m"].get<double>();
  EXPECT_GT(q, 0.0);
  EXPECT_LT(q, 0.0205);
  for (const json& knot : report["ray_knots"]) {
    EXPECT_NEAR(
        knot["clearance_m"].get<double>(), std::max(knot["curve_m"].get<double>() - q, 0.0), 1e-9);
    if (knot["ray"] == "right") {
      EXPECT_LE(knot["curve_m"].get<double>(), 0.4 + 1e-12) << "no bend states more than the reach";
    }
  }
  EXPECT_EQ(work.run({"verify", "cal", "--inputs", "."}).exit_code, 0);
  EXPECT_EQ(work.run({"calibrate", "rays", "pairs.csv", "--bundle", "logs", "--output", "logs/x/"})
                .exit_code,
            2)
      << "nothing is written into the bundle";
}

TEST(Calibrate, RaysPrintTheKnotsAndWhatIsToBePasted) {
  Workdir work(TCERT_BINARY);
  work.write("pairs.csv", pairs(30));
  const ProcessResult run = work.run({"calibrate", "rays", "pairs.csv", "--alpha", "0.1"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  const auto list = run.out.find("[\n {\"name\":\"left\",\"kind\":\"bend\",\"calibration\":");
  ASSERT_NE(list, std::string::npos) << to_string(run);
  const auto end = run.out.find("\n]\n", list);
  const json rays = json::parse(run.out.substr(list, end + 2 - list));
  EXPECT_EQ(rays.size(), 2U);
  EXPECT_NE(run.out.find("at all ticks and rays of a new day with probability 0.938 or more (rank "
                         "15 of 15 days"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(work.run({"calibrate", "rays", "pairs.csv", "--alpha", "0.1"}).out, run.out);
}

TEST(Calibrate, RaysOfTooFewDaysAreRefusedWithWhatIsPossible) {
  Workdir work(TCERT_BINARY);
  work.write("pairs.csv", pairs(8));
  const ProcessResult few = work.run({"calibrate", "rays", "pairs.csv", "--output", "cal/"});
  EXPECT_EQ(few.exit_code, 65);
  EXPECT_NE(few.err.find("8 days, and a bound at alpha 0.05 needs 20"), std::string::npos)
      << to_string(few);
  EXPECT_NE(few.err.find("--alpha 0.125 is possible"), std::string::npos);
  EXPECT_EQ(work.files("cal").size(), 0U);
  EXPECT_EQ(work.run({"calibrate", "rays", "pairs.csv", "--alpha", "0.125"}).exit_code, 0);
  EXPECT_EQ(work.run({"calibrate", "rays", "pairs.csv", "--alpha", "0"}).exit_code, 2);
  const ProcessResult plain = work.run({"calibrate", "rays", "pairs.csv", "--no-bound"});
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_NE(plain.out.find("No bound was asked for"), std::string::npos) << plain.out;
  EXPECT_EQ(work.run({"calibrate", "rays", "pairs.csv", "--no-bound", "--alpha", "0.1"}).exit_code,
            2);
  EXPECT_EQ(work.run({"calibrate", "rays", "none.csv"}).exit_code, 66);
  EXPECT_EQ(work.run({"calibrate", "ray", "pairs.csv"}).exit_code, 2);
  work.write("logs/bundle.json", kBundle);
  work.write("sonar.csv", "ray,run,day,bend_rad,clearance_m\nsonar,1,1,0.1,0.2\n");
  const ProcessResult range =
      work.run({"calibrate", "rays", "sonar.csv", "--bundle", "logs", "--no-bound"});
  EXPECT_EQ(range.exit_code, 65);
  EXPECT_NE(range.err.find("has no ray 'sonar' of kind bend"), std::string::npos);
}

/// Straight runs at 0.2 m/s of which run k is k mm beside its path.
std::string tracked(int runs, const std::string& more = "") {
  std::string text = "run,day,time_s,x_m,y_m,yaw_rad,nominal_x_m,nominal_y_m\n";
  for (int run = 1; run <= runs; ++run) {
    for (int i = 0; i <= 50; ++i) {
      text += "r" + std::to_string(run) + ",d" + std::to_string(run % 3) + "," +
              std::to_string(0.1 * i) + "," + std::to_string(0.02 * i) + "," +
              std::to_string(0.001 * run) + ",0," + std::to_string(0.02 * i) + ",0\n";
    }
  }
  return text + more;
}

TEST(Calibrate, TrackingGivesBuffersThatConfigTakesAndWhatSoManyRunsBound) {
  Workdir work(TCERT_BINARY);
  work.write("runs.csv", tracked(59));
  const ProcessResult run = work.run({"calibrate", "tracking", "runs.csv", "--output", "buffers/"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.err.find("0.0590 m from the nominal path"), std::string::npos) << run.err;
  EXPECT_EQ(work.read("buffers/buffers.ini"),
            "tracking_buffer_m=0.059\ncurvature_buffer_per_m=0\n");
  EXPECT_EQ(json::parse(work.read("buffers/robot.json")),
            json::parse(R"({"tracking_buffer_m": 0.059, "curvature_buffer_per_m": 0})"));
  const json report = json::parse(work.read("buffers/report.json"));
  EXPECT_EQ(report["tracking_runs"].size(), 59U);
  EXPECT_NEAR(report["summary"]["confidence"].get<double>(), 0.9515, 1e-4);
  EXPECT_NEAR(report["summary"]["share_of_days"].get<double>(), std::pow(0.05, 1.0 / 3.0), 1e-9);
  EXPECT_EQ(report["buffers"], work.read("buffers/buffers.ini"));
  EXPECT_EQ(work.run({"verify", "buffers", "--inputs", "."}).exit_code, 0);
  // As --config and as the 'robot' of a bundle, the same.
  EXPECT_EQ(work.run({"simulate", "--trials", "2", "--output", "corpus"}).exit_code, 0);
  const ProcessResult certified =
      work.run({"certify", "corpus", "--config", "buffers/buffers.ini", "--output", "results"});
  ASSERT_EQ(certified.exit_code, 0) << to_string(certified);
  const json manifest = json::parse(work.read("results/manifest.json"));
  EXPECT_EQ(manifest["parameters"]["tracking_buffer_m"], 0.059);
  // Fewer runs say what they do bound.
  work.write("few.csv", tracked(7));
  const ProcessResult few = work.run({"calibrate", "tracking", "few.csv"});
  EXPECT_NE(few.out.find("bounds 65.2 % of all runs with 95 % confidence"), std::string::npos)
      << few.out;
  EXPECT_NE(few.out.find("takes 59"), std::string::npos) << few.out;
}

TEST(Calibrate, TrackingNamesWhatIsWrongWithRuns) {
  Workdir work(TCERT_BINARY);
  work.write("back.csv", tracked(1, "r1,d1,2.5,0,0,0,0,0\n"));
  const ProcessResult back = work.run({"calibrate", "tracking", "back.csv"});
  EXPECT_EQ(back.exit_code, 65);
  EXPECT_NE(back.err.find("back.csv:53: error: column 'time_s': found '2.5 after 5'"),
            std::string::npos)
      << back.err;
  work.write("text.csv", tracked(1, "r1,d1,6,0,left,0,0,0\n"));
  EXPECT_NE(work.run({"calibrate", "tracking", "text.csv"}).err.find("column 'y_m': found 'left'"),
            std::string::npos);
  work.write("runs.csv", tracked(1));
  EXPECT_EQ(work.run({"calibrate", "tracking", "none.csv"}).exit_code, 66);
  EXPECT_EQ(work.run({"calibrate", "tracking"}).exit_code, 2);
  EXPECT_EQ(
      work.run({"calibrate", "tracking", "runs.csv", "--model", "double-integrator"}).exit_code, 2);
  EXPECT_EQ(work.run({"calibrate", "tracking", "runs.csv", "--braking-mps2", "1"}).exit_code, 2);
  EXPECT_EQ(work.run({"calibrate", "tracking", "--model", "unicycle"}).exit_code, 2);
  EXPECT_EQ(work.run({"calibrate", "trackign"}).exit_code, 2);
}

TEST(Calibrate, TrackingOfAModelIsATableOfTheSpeedJustLeft) {
  Workdir work(TCERT_BINARY);
  const ProcessResult run = work.run({"calibrate",
                                      "tracking",
                                      "--model",
                                      "double-integrator",
                                      "--disturbance-mps2",
                                      "0.1",
                                      "--disturbance-mps",
                                      "0.05",
                                      "--speeds",
                                      "0,0.08,0.22",
                                      "--format",
                                      "json"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  const json table = json::parse(run.out)["tracking_error"];
  ASSERT_EQ(table.size(), 18U);
  for (const json& row : table) {
    const double v = std::max(row["speed_mps"].get<double>(), row["speed_left_mps"].get<double>());
    const double dv = row["disturbance"] == 1 ? 0.05 : 0.0;
    const double braking = row["disturbance"] == 1 ? 0.9 : 1.0;
    EXPECT_NEAR(row["radius_m"].get<double>(), (v + dv) * (v + dv) / braking, 1e-12);
    EXPECT_NEAR(
        row["hold_s"].get<double>(), (row["speed_left_mps"].get<double>() + 0.05) / 0.9, 1e-12);
  }
  EXPECT_EQ(table.back()["radius_m"], 0.081);
  for (const char* const speeds : {"0", "0.1,0.2", "0,0.2,0.1", "0,x", "0,inf", "0,2000"}) {
    EXPECT_EQ(
        work.run({"calibrate", "tracking", "--model", "double-integrator", "--speeds", speeds})
            .exit_code,
        2)
        << speeds;
  }
  EXPECT_EQ(
      work.run({"calibrate", "tracking", "--model", "double-integrator", "--disturbance-mps2", "1"})
          .exit_code,
      2);
}

}  // namespace
}  // namespace tcert
