#include <gtest/gtest.h>

#include <cstdlib>
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

class Options : public ::testing::Test {
 protected:
  void SetUp() override {
    const ProcessResult made =
        work_.run({"simulate", "--trials", "4", "--output", "corpus", "--quiet"});
    ASSERT_EQ(made.exit_code, 0) << to_string(made);
  }

  /// edge_length_m as it took effect.
  double effective(std::vector<std::string> flags) {
    std::vector<std::string> arguments = {"certify", "corpus", "--output", "out", "--quiet"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const ProcessResult run = work_.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return nlohmann::json::parse(work_.read("out/manifest.json"))["parameters"]["edge_length_m"];
  }

  Workdir work_{TCERT_BINARY};
};

TEST_F(Options, GoDefaultsThenBundleThenConfigFileThenFlags) {
  work_.write("run.ini", "edge_length_m = 0.5\n");
  EXPECT_EQ(effective({}), 0.25);
  auto description = nlohmann::json::parse(work_.read("corpus/bundle.json"));
  description["parameters"] = {{"edge_length_m", 0.75}};
  work_.write("corpus/bundle.json", description.dump());
  EXPECT_EQ(effective({}), 0.75);
  EXPECT_EQ(effective({"--config", "run.ini"}), 0.5);
  EXPECT_EQ(effective({"--config", "run.ini", "--set", "edge_length_m=0.375"}), 0.375);
  EXPECT_EQ(effective({"--config", "run.ini", "--edge_length_m", "0.125"}), 0.125);
}

TEST_F(Options, OfTheConfigFileAreTheSameNames) {
  work_.write("run.ini", "trials = t0000001\nformat = csv\n");
  const ProcessResult run = work_.run({"certify", "corpus", "--config", "run.ini"});
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.out.find("\nt0000001,"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("\nt0000000,"), std::string::npos) << run.out;
}

TEST_F(Options, OfTheConfigFileThatAreUnknownAreRefused) {
  work_.write("run.ini", "edge_lenght_m = 0.5\n");
  const ProcessResult run = work_.run({"certify", "corpus", "--config", "run.ini"});
  EXPECT_EQ(run.exit_code, 2) << to_string(run);
  EXPECT_NE(run.err.find("did you mean 'edge_length_m'?"), std::string::npos) << run.err;
  EXPECT_EQ(work_.run({"certify", "corpus", "--config", "none.ini"}).exit_code, 66);
}

TEST_F(Options, AreNeverGuessedFromAPrefix) {
  EXPECT_EQ(work_.run({"certify", "corpus", "--form", "csv"}).exit_code, 2);
}

TEST_F(Options, ThatDoNotShapeTheResultLeaveNoTraceInTheManifest) {
  ASSERT_EQ(work_.run({"certify", "corpus", "--output", "a", "--threads", "1"}).exit_code, 0);
  ASSERT_EQ(
      work_.run({"certify", "./corpus/", "--output", "b/c", "--threads", "2", "--quiet"}).exit_code,
      0);
  EXPECT_EQ(work_.read("a/manifest.json"), work_.read("b/c/manifest.json"));
}

TEST_F(Options, OfAResultFolderReplaceOurOwnResultsOnly) {
  EXPECT_EQ(work_.run({"certify", "corpus", "--output", "out"}).exit_code, 0);
  EXPECT_EQ(work_.run({"certify", "corpus", "--output", "out"}).exit_code, 0);
  work_.write("other/notes.txt", "mine");
  EXPECT_EQ(work_.run({"certify", "corpus", "--output", "other"}).exit_code, 73);
  EXPECT_EQ(work_.read("other/notes.txt"), "mine");
}

TEST_F(Options, OfLiveReadJsonLinesAsCsv) {
  ASSERT_EQ(
      work_.run({"certify", "corpus", "--ticks", "--ray-margins", "--output", "out"}).exit_code, 0);
  std::istringstream csv(work_.read("out/ticks/t0000000.csv"));
  std::vector<std::string> names;
  std::string lines;
  for (std::string line; std::getline(csv, line);) {
    if (line.starts_with('#')) {
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream row(line + ",");
    for (std::string cell; std::getline(row, cell, ',');) {
      cells.push_back(cell);
    }
    if (names.empty()) {
      names = cells;
      continue;
    }
    lines += "{";
    for (std::size_t i = 0; i < names.size(); ++i) {
      lines += (i == 0 ? "\"" : ",\"") + names[i] + "\":" + (cells[i].empty() ? "null" : cells[i]);
    }
    lines += "}\n";
  }
  const ProcessResult live =
      work_.run({"live", "--bundle", "corpus/bundle.json", "--ray-margins"}, lines);
  EXPECT_EQ(live.exit_code, 0) << to_string(live);
  EXPECT_TRUE(live.out == work_.read("out/series/t0000000.csv")) << to_string(live);
}

TEST_F(Options, OfHypothesesKeepTheSyntheticLabelOfATable) {
  ASSERT_EQ(work_.run({"certify", "corpus", "--output", "out"}).exit_code, 0);
  const ProcessResult run = work_.run({"hypotheses", "h1", "--features", "out/features.csv"});
  // Four trials without a failure: the table is printed, but nothing can be estimated.
  EXPECT_EQ(run.exit_code, 65) << to_string(run);
  EXPECT_TRUE(run.out.starts_with("SYNTHETIC data, seed 1")) << run.out;
  const ProcessResult direct = work_.run({"hypotheses", "h1", "corpus"});
  EXPECT_EQ(direct.out, run.out);
}

TEST_F(Options, AreDoneWhenTheReaderHasHadEnough) {
  const std::string shell = "cd '" + work_.path().string() + "' && ( '" + TCERT_BINARY +
                            "' help parameters; '" + TCERT_BINARY +
                            "' certify corpus --format csv --quiet; echo $? > code ) | true";
  ASSERT_EQ(std::system(shell.c_str()), 0);
  EXPECT_EQ(work_.read("code"), "0\n");
}

TEST_F(Options, OfStdoutThatCannotBeWrittenEndWith73) {
  const std::string shell = "cd '" + work_.path().string() + "' && '" + TCERT_BINARY +
                            "' certify corpus --quiet > /dev/full 2> /dev/null; echo $? > code";
  ASSERT_EQ(std::system(shell.c_str()), 0);
  EXPECT_EQ(work_.read("code"), "73\n");
}

}  // namespace
}  // namespace tcert
