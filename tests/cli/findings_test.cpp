// What every command says that it found, and how it fits a terminal.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "support/shell.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

bool says(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

class FindingsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(shell_.run("$T simulate --output corpus --quiet").exit_code, 0);
    ASSERT_EQ(shell_.run("$T certify corpus --no-series --output c --quiet").exit_code, 0);
  }

  Shell shell_;
};

TEST_F(FindingsTest, CertifyCountsWhatItIssued) {
  const ProcessResult run = shell_.run("$T certify corpus --no-series --output again");
  EXPECT_TRUE(
      says(run.err, "Certificates issued: T_t was above 0 in 582 of 583 successes, 0 of 77"))
      << to_string(run);
  EXPECT_TRUE(says(run.err, "Early certificate: TC_early: median ")) << to_string(run);
  EXPECT_TRUE(says(shell_.run("$T certify corpus --trials t0000000").out, "t0000000: T_t is "));
}

TEST_F(FindingsTest, HypothesesBeginWithTheVerdicts) {
  const ProcessResult h1 =
      shell_.run("$T hypotheses h1 --features c/features.csv --replicates 199");
  EXPECT_LT(h1.out.find("H1, success, landmark panel: supported."),
            h1.out.find("H1, success: early certificate margin"))
      << to_string(h1);
  EXPECT_TRUE(says(h1.out, "Rule of H1: "));
  const ProcessResult file =
      shell_.run("$T hypotheses h1 --features c/features.csv --replicates 199 --output h1.csv");
  EXPECT_TRUE(says(file.err, "H1, success, landmark panel: supported.")) << to_string(file);
  const ProcessResult table = shell_.run(
      "$T hypotheses h2 --features c/features.csv --replicates 199 --permutations 9 --table "
      "findings --format csv");
  EXPECT_TRUE(says(table.out, "about,verdict,evidence")) << to_string(table);
  EXPECT_FALSE(says(table.out, ",supported,")) << "22 days cannot show a margin of 0.05";
}

/// The evidence of a verdict of H1 is the gain that made it.
void expect_evidence(const std::string& lines) {
  std::istringstream all(lines);
  std::size_t verdicts = 0;
  for (std::string line; std::getline(all, line);) {
    static const std::regex kLine(
        "H1, .* panel: (supported|contradicted|not decided)\\. .* is (\\S+) \\[(\\S+), "
        "(\\S+)\\], over .*");
    std::smatch found;
    if (!std::regex_match(line, found, kLine)) {
      continue;
    }
    ++verdicts;
    const double gain = std::stod(found[2]);
    const double low = std::stod(found[3]);
    const double high = std::stod(found[4]);
    EXPECT_LE(low, gain) << line;
    EXPECT_LE(gain, high) << line;
    EXPECT_EQ(found[1] == "supported", low > 0.0) << line;
    EXPECT_EQ(found[1] == "contradicted", high < 0.0) << line;
  }
  EXPECT_EQ(verdicts, 8U) << "success and time, pooled and within, in two panels\n" << lines;
}

TEST_F(FindingsTest, EvidenceIsWhatMadeTheVerdict) {
  expect_evidence(
      shell_.run("$T hypotheses h1 --features c/features.csv --replicates 199 --quiet").out);
  ASSERT_EQ(shell_.run("$T simulate --effect 0 --seed 6 --output null --quiet").exit_code, 0);
  expect_evidence(shell_.run("$T hypotheses h1 null --replicates 199 --quiet").out);
}

TEST_F(FindingsTest, AFolderHasARowOfEveryCondition) {
  // So few days that much is to be said.
  ASSERT_EQ(shell_
                .run("head -120 c/features.csv > few.csv && $T hypotheses h2 --features few.csv "
                     "--replicates 99 --permutations 9 --output h2/ --quiet")
                .exit_code,
            0);
  const auto report = nlohmann::json::parse(shell_.work().read("h2/report.json"));
  const std::string csv = shell_.work().read("h2/conditions.csv");
  ASSERT_GT(report["conditions"].size(), 3U);
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            report["conditions"].size() + 1);
}

TEST_F(FindingsTest, NothingIsSupportedWhereThereIsNothing) {
  ASSERT_EQ(shell_.run("$T simulate --effect 0 --seed 3 --output null --quiet").exit_code, 0);
  const ProcessResult run = shell_.run("$T hypotheses h1 null --replicates 199 --quiet");
  EXPECT_FALSE(says(run.out, "panel: supported")) << to_string(run);
  EXPECT_TRUE(says(run.out, "H1, success, landmark panel: not decided.") ||
              says(run.out, "H1, success, landmark panel: contradicted."))
      << to_string(run);
}

TEST_F(FindingsTest, LinesFitTheTerminal) {
  for (const char* const line :
       {"COLUMNS=100 $T hypotheses h1 --features c/features.csv --replicates 99",
        "COLUMNS=80 $T hypotheses h2 --features c/features.csv --replicates 99 --permutations 9",
        "COLUMNS=80 $T check corpus --trials 't000000*'"}) {
    const ProcessResult run = shell_.run(line);
    std::istringstream lines(run.out);
    for (std::string text; std::getline(lines, text);) {
      EXPECT_LE(text.size(), 100U) << line << '\n' << text;
    }
  }
  const char* const wide = "$T hypotheses h1 --features c/features.csv --replicates 99";
  EXPECT_EQ(shell_.run(std::string("COLUMNS=80 ") + wide + " --wide").out, shell_.run(wide).out);
}

TEST_F(FindingsTest, HelpFitsTheTerminalButForItsExamples) {
  for (const std::string command : {"certify", "study", "live", "import log"}) {
    const ProcessResult run = shell_.run("COLUMNS=80 $T " + command + " --help");
    std::istringstream lines(run.out);
    for (std::string text; std::getline(lines, text);) {
      const bool is_example = text.starts_with("  ") && text.find("tcert ") != std::string::npos;
      EXPECT_TRUE(text.size() <= 80 || is_example) << command << '\n' << text;
    }
    EXPECT_NE(shell_.run("$T " + command + " --help").out, run.out) << command;
  }
}

TEST_F(FindingsTest, ACommandWithoutResultsSaysWhy) {
  ASSERT_EQ(shell_.run("head -14 c/features.csv > few.csv").exit_code, 0);
  const ProcessResult run = shell_.run("$T hypotheses h1 --features few.csv --output few/");
  EXPECT_EQ(run.exit_code, 65) << to_string(run);
  EXPECT_TRUE(says(run.err, "H1, success, landmark panel: not decided.")) << to_string(run);
}

}  // namespace
}  // namespace tcert
