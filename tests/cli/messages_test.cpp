// What a mistake is answered with, and what the help lists.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_said(const ProcessResult& run, int exit_code, std::string_view text) {
  EXPECT_EQ(run.exit_code, exit_code) << to_string(run);
  EXPECT_NE(run.err.find(text), std::string::npos) << to_string(run);
}

constexpr const char* kOutcomes =
    "planner,world,success,collided,timeout,time_s\n"
    "dwa,1,1,0,0,12\ndwa,2,0,1,0,20\ndwa,3,1,0,0,14\n";

TEST(Messages, OfBundlesNameTheFolder) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(work.run({"simulate", "--output", "corpus", "--trials", "1", "--quiet"}).exit_code, 0);
  expect_said(work.run({"certify", "corpus/bundle.json"}), 65, "name the folder");
  expect_said(work.run({"certify", "corpus", "--output", "r"}), 0, "Certified 1 trial.");
  work.write("empty/note.txt", "");
  expect_said(work.run({"live", "--bundle", "empty"}), 65, "holds no bundle.json");
}

TEST(Messages, OfOptionsNameWhatWasFoundAndExpected) {
  Workdir work(TCERT_BINARY);
  work.write("t.csv", "x,y\n1,0\n");
  expect_said(work.run({"hypotheses", "h1", "--features", "t.csv", "--replicates", "abc"}),
              2,
              "--replicates: found 'abc', expected a whole number");
  expect_said(work.run({"fit", "glm", "--level", "high"}), 2, "expected a number");
  expect_said(work.run({"import", "foo"}), 2, "unknown format 'foo', expected log, carmen or barn");
  expect_said(work.run({"hypotheses", "h1", "--features", "t.csv", "--trials", "t1"}),
              2,
              "--trials is for a bundle");
  expect_said(work.run({"hypotheses", "h1", "--features", "t.csv", "--set", "beta_per_m=2"}),
              2,
              "parameters are for a bundle");
}

TEST(Messages, OfTheBarnImportSpeakOfItsFiles) {
  Workdir work(TCERT_BINARY);
  const auto import = [&](std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{
        "import", "barn", "--trials", "t.csv", "--metrics", "m.csv", "--output", "o.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return work.run(arguments);
  };
  work.write("t.csv", kOutcomes);
  work.write("m.csv", "world,m1,m2,m3,m4,m5\n1,1,1,1,1,1\n2,x,1,1,1,1\n2,1,1,1,1,1\n");
  // World 2 is bad, and its second row is no substitute: said, counted, and in the exit code.
  const ProcessResult bad = import();
  expect_said(bad, 3, "each world once; the first row counts");
  EXPECT_NE(bad.err.find("1 of 3 trials written"), std::string::npos) << bad.err;
  work.write("m.csv", "world,m1,m2,m3,m4,m5\n1,x,1,1,1,1\n");
  expect_said(import(), 65, "has no metrics for the worlds of");
  work.write("m.csv", "w,m1,m2,m3,m4,m5\n1,1,1,1,1,1\n");
  const ProcessResult without = import();
  EXPECT_EQ(without.err.find("bundle.json"), std::string::npos) << without.err;
  work.write("m.csv", "world,m1,m2,m3,m4,m5\n1,1,1,1,1,1\n");
  work.write("t.csv",
             "first_commit_date,world,success,collided,timeout,time_s\n2024-01-01,1,1,0,0,12\n");
  expect_said(import({"--same-port"}), 2, "--same-port: the trials have no column planner");
}

TEST(Messages, OfCheckKnowAStreamFromATableOfTrials) {
  Workdir work(TCERT_BINARY);
  work.write("trials.csv", "x,success,time_s\n1,1,30\n2,0,12\n3,1,12\n");
  EXPECT_EQ(work.run({"check", "trials.csv"}).exit_code, 0);
  work.write("ticks.csv", "time_s,x_m\n0,1\n2,2\n1,3\n");
  EXPECT_NE(work.run({"check", "ticks.csv"}).out.find("1 after 2"), std::string::npos);
  work.write("cut.csv", std::string("a,b\n1,2\n3,") + '\0' + "4\n");
  const ProcessResult cut = work.run({"check", "cut.csv"});
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_NE(cut.out.find("control byte"), std::string::npos) << cut.out;
}

TEST(Messages, TheHelpListsEveryColumnOfTheResults) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(work.run({"simulate", "--output", "corpus", "--trials", "1", "--quiet"}).exit_code, 0);
  ASSERT_EQ(work.run({"certify", "corpus", "--output", "r", "--quiet"}).exit_code, 0);
  const ProcessResult help = work.run({"help", "columns", "--format", "csv"});
  ASSERT_EQ(help.exit_code, 0) << to_string(help);
  for (const auto& file : work.files("r")) {
    const bool is_table =
        file == "features.csv" || file == "certificates.csv" || file.find("series/") == 0;
    if (!is_table) {
      continue;
    }
    const std::string label = file.find("series/") == 0 ? "series/<trial_id>.csv" : file;
    const std::string text = work.read("r/" + file);
    std::string header = text.substr(0, text.find('\n'));
    // Columns of the bundle's own come last.
    const std::string last = ",median_loop_latency_ms";
    const std::size_t own = header.find(last);
    header = (own == std::string::npos ? header : header.substr(0, own + last.size())) + ',';
    for (std::size_t begin = 0; begin < header.size();) {
      const std::size_t comma = header.find(',', begin);
      const std::string column = header.substr(begin, comma - begin);
      EXPECT_NE(help.out.find(label + "," + column + ","), std::string::npos) << label << column;
      begin = comma + 1;
    }
  }
  EXPECT_NE(help.out.find("seconds since the first tick"), std::string::npos);
}

TEST(Messages, OfH1NameThePredictorsOfAForeignTable) {
  Workdir work(TCERT_BINARY);
  std::string csv = "m1,m2,success,time_s,day\n";
  for (int i = 0; i < 60; ++i) {
    const int success = (i * 7 + i / 5) % 3 == 0 ? 0 : 1;
    csv += std::to_string((i * 13) % 17 + 3 * success) + ',' + std::to_string((i * 5) % 11) + ',' +
           std::to_string(success) + ',' + std::to_string(10 + (i * 3) % 23) + ",d" +
           std::to_string(i % 10) + '\n';
  }
  work.write("t.csv", csv);
  const std::vector<std::string> call{"hypotheses",
                                      "h1",
                                      "--features",
                                      "t.csv",
                                      "--predictor",
                                      "m1",
                                      "--baselines",
                                      "m2",
                                      "--replicates",
                                      "200",
                                      "--strata",
                                      ""};
  const ProcessResult run = work.run(call);
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.out.find("H1, success: m1 against m2"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("paper"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("landmark [s]"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("Sensitivity"), std::string::npos) << run.out;
  std::vector<std::string> as_json = call;
  as_json.insert(as_json.end(), {"--format", "json"});
  EXPECT_TRUE(json::parse(work.run(as_json).out).contains("h1_case_level"));
}

}  // namespace
}  // namespace tcert
