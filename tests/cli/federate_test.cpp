#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_done(const ProcessResult& run) { ASSERT_EQ(run.exit_code, 0) << to_string(run); }

/// A lane of four edges along x from `x`, of margin 0.6.
std::string lane(const std::string& name, double x, bool begins, const std::string& error) {
  std::string text = "tcert-submap,1\nagent,0.45,0.35,0,0\nsource," + name + ",witness," + error +
                     ',' + (error == "-" ? "-" : "0") + '\n';
  for (int n = 0; n <= 4; ++n) {
    const bool is_end = begins ? n == 0 : n == 4;
    text += "node," + std::to_string(x + 0.25 * n) + ",0,0," +
            (is_end ? (begins ? "S" : "G") : "-") + ",-\n";
  }
  for (int n = 0; n < 4; ++n) {
    text += "edge," + std::to_string(n) + ",front," + std::to_string(n + 1) + ",back,0.6,-\n";
  }
  return text;
}

json report_of(Workdir& work, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "federate");
  arguments.insert(arguments.end(), {"--quiet", "--format", "json"});
  const ProcessResult run = work.run(arguments);
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  return json::parse(run.out);
}

TEST(FederateCommand, JoinsTwoHalvesWhoseFramesAreKnown) {
  Workdir work(TCERT_BINARY);
  work.write("a.csv", lane("a", 0.0, true, "-"));
  work.write("b.csv", lane("b", 1.2, false, "-"));
  const json unknown = report_of(work, {"a.csv", "b.csv"});
  EXPECT_TRUE(unknown["summary"]["certificate_m"].is_null());
  EXPECT_EQ(unknown["summary"]["joins"], 0);
  const json known =
      report_of(work, {"a.csv", "b.csv", "--frame-error-m", "0", "--frame-error-rad", "0"});
  EXPECT_NEAR(known["summary"]["certificate_m"].get<double>(), 0.4, 1e-12);
  const json off =
      report_of(work, {"a.csv", "b.csv", "--frame-error-m", "0.02", "--frame-error-rad", "0.01"});
  EXPECT_LT(off["summary"]["certificate_m"].get<double>(), 0.37);
}

TEST(FederateCommand, TheUnionIsTheSameBytesInAnyOrderAndMergesAgain) {
  Workdir work(TCERT_BINARY);
  work.write("a.csv", lane("a", 0.0, true, "0"));
  work.write("b.csv", lane("b", 1.2, false, "0"));
  work.write("c.csv", lane("c", 0.9, false, "0.01"));
  expect_done(work.run({"federate", "a.csv", "b.csv", "c.csv", "--output", "abc/"}));
  expect_done(work.run({"federate", "c.csv", "a.csv", "b.csv", "a.csv", "--output", "cab/"}));
  EXPECT_EQ(work.read("abc/merged.submap"), work.read("cab/merged.submap"));
  expect_done(work.run({"federate", "a.csv", "b.csv", "--output", "ab/"}));
  expect_done(work.run({"federate", "ab/merged.submap", "c.csv", "--output", "ab_c/"}));
  EXPECT_EQ(work.read("ab_c/merged.submap"), work.read("abc/merged.submap"));
  EXPECT_EQ(work.read("ab_c/way.csv"), work.read("abc/way.csv"));
  expect_done(work.run({"verify", "abc", "--inputs", "."}));
}

TEST(FederateCommand, SaysWhatIsWrongWithAFile) {
  Workdir work(TCERT_BINARY);
  work.write("a.csv", lane("a", 0.0, true, "0"));
  work.write("bad.csv", "tcert-submap,1\nagent,0.45,0.35,0,x\n");
  const ProcessResult bad = work.run({"federate", "a.csv", "bad.csv"});
  EXPECT_EQ(bad.exit_code, 65);
  EXPECT_NE(bad.err.find("bad.csv, line 2, cell 5: found 'x', expected a number from 0 to 1e+06"),
            std::string::npos)
      << bad.err;
  std::string other = lane("b", 1.2, false, "0");
  other.replace(other.find("0.45"), 4, "0.50");
  work.write("other.csv", other);
  const ProcessResult agents = work.run({"federate", "a.csv", "other.csv"});
  EXPECT_EQ(agents.exit_code, 65);
  EXPECT_NE(agents.err.find("agents that differ"), std::string::npos) << agents.err;
  EXPECT_EQ(work.run({"federate", "none.csv"}).exit_code, 66);
  work.write("empty.csv", "");
  const ProcessResult empty = work.run({"federate", "empty.csv"});
  EXPECT_NE(empty.err.find("empty.csv, found 'nothing', expected tcert-submap,1"),
            std::string::npos)
      << empty.err;
}

TEST(FederateCommand, ClaimsNothingWhereStartAndGoalMeet) {
  Workdir work(TCERT_BINARY);
  std::string text = lane("a", 0.0, true, "0");
  text.replace(text.find(",S,"), 3, ",SG,");
  work.write("a.csv", text);
  const ProcessResult run = work.run({"federate", "a.csv"});
  expect_done(run);
  EXPECT_NE(
      run.out.find("T_H: not issued. S and G meet, so that nothing is to be passed, together"),
      std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("0 of 1 sources have a certificate"), std::string::npos) << run.out;
}

TEST(FederateCommand, TakesWhatCertifyTellsOfEachTrial) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "24", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--submaps", "--output", "width"}));
  expect_done(
      work.run({"certify", "corpus", "--submaps", "--witness-edges", "--output", "proved"}));
  std::vector<std::string> felt{"federate"};
  std::size_t largest = 0;
  for (const auto& file : std::filesystem::directory_iterator(work.path() / "width" / "submaps")) {
    felt.push_back("width/submaps/" + file.path().filename().string());
    largest = std::max(largest, static_cast<std::size_t>(file.file_size()));
  }
  EXPECT_EQ(felt.size(), 25U);
  EXPECT_LT(largest, 12'000U) << "a submap is a few kilobytes";
  felt.insert(felt.end(), {"--format", "json", "--quiet"});
  const ProcessResult run = work.run(felt);
  expect_done(run);
  EXPECT_TRUE(run.out.find("\"synthetic") != std::string::npos) << "it says that it is made up";
  const json report = json::parse(run.out);
  EXPECT_EQ(report["summary"]["sources"], 24);
  EXPECT_EQ(report["summary"]["joins"], 0) << "nobody knows how the frames of trials lie";
  const std::string proved = work.read("proved/submaps/" + felt[1].substr(felt[1].rfind('/') + 1));
  EXPECT_NE(proved.find(",witness,-,-\n"), std::string::npos);
}

}  // namespace
}  // namespace tcert
