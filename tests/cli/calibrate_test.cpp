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

}  // namespace
}  // namespace tcert
