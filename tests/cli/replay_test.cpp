#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_done(const ProcessResult& run) { ASSERT_EQ(run.exit_code, 0) << to_string(run); }

/// Rows of the audit log of one trial, without the cells before the time.
std::string audit_of(const std::string& audit, const std::string& trial_id) {
  std::istringstream lines(audit);
  std::string line;
  std::getline(lines, line);
  std::string rows = line.substr(line.find("time_s")) + '\n';
  const std::string start = "1," + trial_id + ",clip,10,";
  while (std::getline(lines, line)) {
    if (line.rfind(start, 0) == 0) {
      rows += line.substr(start.size()) + '\n';
    }
  }
  return rows;
}

TEST(ReplayCommand, LiveSaysWhatTheReplaySays) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "20", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--ticks", "--output", "out"}));
  expect_done(work.run({"replay",
                        "corpus",
                        "--laws",
                        "clip",
                        "--betas",
                        "10",
                        "--series",
                        "--set",
                        "replan_margin_m=0.03",
                        "--output",
                        "replays"}));
  const std::string audit = work.read("replays/audit.csv");
  std::size_t trips = 0;
  for (const std::string& file : work.files("out/ticks")) {
    const ProcessResult live = work.run({"live",
                                         "--bundle",
                                         "corpus",
                                         "--guards",
                                         "--audit",
                                         "audit.csv",
                                         "--set",
                                         "speed_law=clip",
                                         "--set",
                                         "beta_per_m=10",
                                         "--set",
                                         "replan_margin_m=0.03"},
                                        work.read("out/ticks/" + file));
    expect_done(live);
    EXPECT_TRUE(live.out == work.read("replays/series/clip_10/" + file)) << file;
    const std::string own = work.read("audit.csv");
    EXPECT_EQ(own, audit_of(audit, file.substr(0, file.find('.'))));
    trips += static_cast<std::size_t>(std::count(own.begin(), own.end(), '\n')) - 1;
  }
  EXPECT_GT(trips, 10U) << "nothing was audited";
}

TEST(ReplayCommand, ThreadsDoNotChangeAByte) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "30", "--output", "corpus"}));
  for (const std::string threads : {"1", "2"}) {
    expect_done(work.run(
        {"replay", "corpus", "--replan", "--threads", threads, "--output", "out" + threads}));
  }
  for (const std::string& file : work.files("out1")) {
    EXPECT_TRUE(work.read("out1/" + file) == work.read("out2/" + file)) << file;
  }
}

TEST(ReplayCommand, H3OfABundleIsH3OfItsReplays) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "150", "--output", "corpus"}));
  expect_done(work.run({"replay", "corpus", "--output", "replays"}));
  const ProcessResult bundle =
      work.run({"hypotheses", "h3", "corpus", "--replicates", "100", "--format", "json"});
  const ProcessResult table = work.run({"hypotheses",
                                        "h3",
                                        "--replays",
                                        "replays/replay.csv",
                                        "--replicates",
                                        "100",
                                        "--format",
                                        "json"});
  expect_done(bundle);
  expect_done(table);
  EXPECT_EQ(bundle.out, table.out);
  const auto document = nlohmann::json::parse(table.out);
  EXPECT_EQ(document.at("h3").size(), 24U) << "6 laws and betas, all and 3 lightings";
  EXPECT_EQ(document.at("h3_baseline").size(), 4U);
}

TEST(ReplayCommand, ATrackingErrorTableWidensTheBound) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "3", "--output", "corpus"}));
  work.write("te.csv",
             "speed_mps,acceleration_mps2,disturbance,radius_m\n"
             "0,0,0,0.01\n1,0,0,0.3\n0,10,0,0.02\n1,10,0,0.4\n");
  const auto totals = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "replay", "corpus", "--laws", "clip", "--betas", "10", "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult run = work.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return nlohmann::json::parse(run.out).at("rows").at(0);
  };
  EXPECT_LT(totals({"--tracking-error", "te.csv"}).at("gated_rate_m_per_min").get<double>(),
            totals({}).at("gated_rate_m_per_min").get<double>());
  work.write("bad.csv", "speed_mps,acceleration_mps2,disturbance,radius_m\n0,0,0,1\n1,0,0,0.5\n");
  const ProcessResult bad = work.run({"replay", "corpus", "--tracking-error", "bad.csv"});
  EXPECT_EQ(bad.exit_code, 65) << to_string(bad);
  EXPECT_NE(bad.err.find("fall along an axis"), std::string::npos) << bad.err;
}

TEST(ReplayCommand, WrongLawsAreUsageErrors) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "1", "--output", "corpus"}));
  EXPECT_EQ(work.run({"replay", "corpus", "--laws", "quick"}).exit_code, 2);
  EXPECT_EQ(work.run({"replay", "corpus", "--betas", "0"}).exit_code, 2);
  EXPECT_EQ(work.run({"replay", "corpus", "--series"}).exit_code, 2);
  EXPECT_EQ(work.run({"hypotheses", "h3"}).exit_code, 2);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--within", "lighting"}, {"--success", "success"}, {"--no-time-rounding"}}) {
    std::vector<std::string> arguments{"hypotheses", "h3", "corpus", "--replicates", "10"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const ProcessResult run = work.run(arguments);
    EXPECT_EQ(run.exit_code, 2) << to_string(run);
    EXPECT_NE(run.err.find(option.front() + " is for h1 and h2, not for h3"), std::string::npos)
        << to_string(run);
  }
  EXPECT_EQ(work.run({"hypotheses", "h9", "corpus"}).exit_code, 2);
}

TEST(GateCommand, FindsTheEvenChanceOfTheMicroStudy) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--micro-study", "--output", "gates"}));
  const ProcessResult run = work.run({"gate", "gates", "--format", "json"});
  expect_done(run);
  const auto document = nlohmann::json::parse(run.out);
  ASSERT_EQ(document.at("gate").size(), 4U);
  for (const auto& row : document.at("gate")) {
    EXPECT_EQ(row.at("set"), "bounded") << row;
    EXPECT_LT(std::abs(row.at("point_m").get<double>()), 0.03);
  }
  EXPECT_EQ(document.at("gate_passes").size(), 60U);
  EXPECT_EQ(document.at("gate_calibration").size(), 5U);
  EXPECT_EQ(work.run({"gate", "gates", "--format", "json", "--threads", "1"}).out, run.out);
}

}  // namespace
}  // namespace tcert
