// Wrong values as people meet them: what certify, check and live say of a bundle that holds them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

class Values : public ::testing::Test {
 protected:
  void make_corpus(const char* trials) {
    const ProcessResult made =
        work_.run({"simulate", "--trials", trials, "--output", "corpus", "--quiet"});
    ASSERT_EQ(made.exit_code, 0) << to_string(made);
  }

  /// Every cell of one column of a CSV file, in place.
  void change_column(const std::string& file,
                     const std::string& column,
                     const std::function<double(double)>& change) {
    std::istringstream in(work_.read(file));
    std::string out;
    std::size_t position = 0;
    bool is_header = true;
    for (std::string line; std::getline(in, line); out += '\n') {
      if (line.starts_with('#')) {
        out += line;
        continue;
      }
      std::istringstream cells(line);
      std::size_t at = 0;
      for (std::string cell; std::getline(cells, cell, ','); ++at) {
        position = is_header && cell == column ? at : position;
        const bool wanted = !is_header && at == position;
        out += (at > 0 ? "," : "") + (wanted ? std::to_string(change(std::stod(cell))) : cell);
      }
      is_header = false;
    }
    work_.write(file, out);
  }

  /// A corridor of 1 m along x, 20 s at 0.2 m/s; `left` is written into every fourth scan.
  void write_corridor(const std::string& left, const json& keys, double yaw_rad = 0.0) {
    json bundle = json::parse(R"({"format": "tcert-bundle", "version": 1,
      "robot": {"body_width_m": 0.4, "min_turn_radius_m": 0},
      "rays": [{"name": "left", "kind": "range", "bearing_rad": 1.5708, "reach_m": 2},
               {"name": "right", "kind": "range", "bearing_rad": -1.5708, "reach_m": 2}],
      "course": {"start": {"disc": {"x_m": 0, "y_m": 0, "radius_m": 0.5}},
                 "goal": {"disc": {"x_m": 4, "y_m": 0, "radius_m": 0.5}}}})");
    bundle["rays"][0].update(keys);
    work_.write("b/bundle.json", bundle.dump());
    work_.write("b/trials.csv", "trial_id,success,time_s\nt,1,20\n");
    std::string ticks = "time_s,x_m,y_m,yaw_rad,left_range_m,right_range_m\n";
    for (int i = 0; i <= 200; ++i) {
      const std::string sway = std::to_string(0.5 + 0.002 * (i % 3));
      ticks += std::to_string(0.1 * i) + "," + std::to_string(0.02 * i) + ",0," +
               std::to_string(yaw_rad) + "," + (i % 4 == 0 ? left : sway) + "," +
               std::to_string(0.5 + 0.001 * (i % 5)) + "\n";
    }
    work_.write("b/logs/t/ticks.csv", ticks);
  }

  /// The last T_t that `certify` gives the corridor.
  double certificate() {
    const ProcessResult run = work_.run({"certify", "b", "--format", "json", "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return json::parse(run.out).at("rows").at(0).at("certificate_m").get<double>();
  }

  Workdir work_{TCERT_BINARY};
};

TEST_F(Values, CertifyEndsWithALineForEachSign) {
  make_corpus("12");
  const ProcessResult good = work_.run({"certify", "corpus", "--output", "good"});
  EXPECT_FALSE(says(good.err, "warning")) << good.err;
  for (const char* trial : {"t0000002", "t0000007"}) {
    const std::string log = std::string("corpus/logs/") + trial;
    change_column(log + "/tactile.csv", "left_bend_rad", [](double v) { return 57.3 * v; });
  }
  change_column("corpus/logs/t0000007/pose.csv", "yaw_rad", [](double v) { return 57.3 * v; });
  const ProcessResult run = work_.run({"certify", "corpus", "--output", "out", "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_TRUE(says(run.err, "logs/t0000002: warning: column 'left_bend_rad': found '")) << run.err;
  EXPECT_TRUE(says(run.err, "0 to 1.2: degrees? (and 1 more trial)")) << run.err;
  EXPECT_TRUE(says(run.err, "logs/t0000007: warning: column 'yaw_rad'")) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 2) << run.err;
  const std::string problems = work_.read("out/diagnostics.csv");
  EXPECT_TRUE(says(problems, "t0000007,warning,logs/t0000007")) << problems;
  const ProcessResult check = work_.run({"check", "corpus"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_TRUE(says(check.err, "12 trials checked: 0 errors, 3 warnings, 0 notes.")) << check.err;
}

TEST_F(Values, CertifySaysWhyNoSuccessHasACertificate) {
  make_corpus("12");
  json bundle = json::parse(work_.read("corpus/bundle.json"));
  const json course = bundle["course"];
  const auto said = [&](const json& other) {
    bundle["course"] = other;
    work_.write("corpus/bundle.json", bundle.dump());
    return work_.run({"certify", "corpus", "--no-series", "--output", "out"}).err;
  };
  EXPECT_FALSE(says(said(course), "Why none"));
  EXPECT_TRUE(says(said(json::object({{"start", course["start"]}})),
                   "the course has no goal (G) (in t0000000)"));
  json far = course;
  far["start"] = {{"disc", {{"x_m", 50.0}, {"y_m", 0.0}, {"radius_m", 0.5}}}};
  const std::string outside = said(far);
  EXPECT_TRUE(says(outside, "Why none: in ")) << outside;
  EXPECT_TRUE(says(outside, "m outside the start (S)")) << outside;
  EXPECT_TRUE(says(outside, "m outside the start region', expected a run that starts in S"))
      << outside;
  far["start"] = course["start"];
  far["goal"] = {{"disc", {{"x_m", 50.0}, {"y_m", 0.0}, {"radius_m", 0.5}}}};
  const std::string missed = said(far);
  EXPECT_TRUE(says(missed, "the goal (G) was never entered, ")) << missed;
  EXPECT_TRUE(says(missed, "a success that never entered the goal region")) << missed;
  EXPECT_TRUE(says(missed, "T_t was above 0 in 0 of ")) << missed;
  bundle["course"] = course;
  work_.write("corpus/bundle.json", bundle.dump());
  const std::string narrow =
      work_
          .run({"certify", "corpus", "--set", "body_width_m=1.5", "--no-series", "--output", "out"})
          .err;
  EXPECT_TRUE(says(narrow, "which is not above 0 (in t")) << narrow;
}

// 25 degrees off the heading the rays reach askew, at 40 they look along the way.
TEST_F(Values, ARobotThatMovesAcrossItsHeadingIsNotGivenWhatItsRaysReach) {
  write_corridor("0.5", json::object());
  const double straight = certificate();
  write_corridor("0.5", json::object(), 0.436);
  EXPECT_NEAR(certificate() + 0.4, (straight + 0.4) * std::cos(0.436), 0.01);
  write_corridor("0.5", json::object(), 0.7);
  const ProcessResult run = work_.run({"certify", "b", "--output", "out"});
  EXPECT_TRUE(says(run.err, "no certificate: the margin is")) << run.err;
  EXPECT_TRUE(says(run.err, "the robot moved across its heading there")) << run.err;
  EXPECT_TRUE(says(work_.read("out/series/t.csv"), "across_heading"));
}

TEST_F(Values, CheckTakesTheClockOfAFolder) {
  std::string rows = "Zeit;Pos_X;Pos_Y;yaw\n";
  for (int i = 0; i < 50; ++i) {
    rows += std::to_string(0.1 * i) + ";" + std::to_string(0.02 * i) + ";0;0\n";
  }
  work_.write("logs/run_01.csv", rows);
  work_.write("logs/run_02.csv", rows);
  const ProcessResult run =
      work_.run({"check", "logs", "--clock", "Zeit", "--write-map", "map.json"});
  EXPECT_TRUE(says(work_.read("map.json"), "\"Zeit\"")) << to_string(run);
  const ProcessResult other = work_.run({"check", "logs", "--clock", "Uhr"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(says(other.err, "found 'Uhr', which is the clock of no file in logs")) << other.err;
}

TEST_F(Values, NothingWithinReachIsTheReach) {
  write_corridor("0.5", json::object());
  const double certificate_m = certificate();
  EXPECT_NEAR(certificate_m, 0.6, 0.01);
  for (const char* word : {"inf", "2", "Infinity"}) {
    write_corridor(word, json::object());
    EXPECT_NEAR(certificate(), certificate_m, 0.02) << word;
  }
  for (const char* word : {"0", "-1", "65.535"}) {
    write_corridor(word, {{"no_return", {0, -1, 65.535}}});
    EXPECT_NEAR(certificate(), certificate_m, 0.02) << word;
  }
  write_corridor("0", json::object());
  EXPECT_LT(certificate(), 0.2) << "as it is read";
  const std::string warned = work_.run({"certify", "b", "--quiet"}).err;
  EXPECT_TRUE(says(warned, "column 'left_range_m': found '0 in 25 % of the readings'")) << warned;
  EXPECT_TRUE(says(warned, "'no_return': [0] of the ray in bundle.json")) << warned;
}

// The same rule in files, in the ticks that certify writes, and in the lines of live.
TEST_F(Values, LiveReadsRangesAsFilesDo) {
  for (const char* word : {"inf", "-inf", "0", "0.01", "-1"}) {
    write_corridor(word, {{"no_return", {0}}, {"range_min_m", 0.05}});
    const ProcessResult run = work_.run({"certify", "b", "--ticks", "--output", "out", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
    const std::string series = work_.read("out/series/t.csv");
    const ProcessResult raw =
        work_.run({"live", "--bundle", "b"}, work_.read("b/logs/t/ticks.csv"));
    EXPECT_TRUE(raw.out == series) << word;
    EXPECT_EQ(says(raw.err, "51 readings below 0, down to -1"), std::string(word) == "-1")
        << raw.err;
    const ProcessResult again = work_.run({"live", "--bundle", "b"}, work_.read("out/ticks/t.csv"));
    EXPECT_TRUE(again.out == series) << word;
    work_.write("b/logs/t/ticks.csv", work_.read("out/ticks/t.csv"));
    ASSERT_EQ(work_.run({"certify", "b", "--output", "out2", "--quiet"}).exit_code, 0);
    EXPECT_TRUE(work_.read("out2/series/t.csv") == series) << word;
    std::filesystem::remove_all(work_ / "out");
    std::filesystem::remove_all(work_ / "out2");
  }
}

TEST_F(Values, CheckNotesACourseWithoutAGoal) {
  make_corpus("2");
  json bundle = json::parse(work_.read("corpus/bundle.json"));
  bundle["course"].erase("goal");
  work_.write("corpus/bundle.json", bundle.dump());
  const ProcessResult run = work_.run({"check", "corpus"});
  EXPECT_EQ(run.exit_code, 0) << "a study of V_t needs none";
  EXPECT_TRUE(says(run.out, "without it there is no certificate T_t, only V_t")) << run.out;
}

}  // namespace
}  // namespace tcert
