// Progress is drawn on a terminal alone, and changes no byte of what is found.

#include <gtest/gtest.h>

#include <string>

#include "support/shell.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

/// Sixty trials of twelve days in two lightings.
std::string trials() {
  std::string csv = "tc_early,tc_landmark,success,time_s,end_s,day,lighting\n";
  for (int i = 0; i < 60; ++i) {
    const int success = (i * 7 + i / 5) % 3 == 0 ? 0 : 1;
    const std::string margin = std::to_string((i * 13) % 17 + 3 * success);
    const std::string time = std::to_string(20 + (i * 3) % 23);
    csv += margin + ',' + margin + ',' + std::to_string(success) + ',' + time + ',' + time + ",d" +
           std::to_string(i % 12) + (i % 2 == 0 ? ",Dark" : ",Indoor") + '\n';
  }
  return csv;
}

class ProgressOfHypotheses : public ::testing::Test {
 protected:
  void SetUp() override {
    if (shell_.run("command -v script").exit_code != 0) {
      GTEST_SKIP() << "script, which runs a program on a terminal, is not installed";
    }
    shell_.work().write("t.csv", trials());
  }

  /// What is on the terminal of a command, which writes its data to `out`.
  std::string terminal(const std::string& command) {
    const ProcessResult run =
        shell_.run("script -qec '" + command + " > out' /dev/null < /dev/null");
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run.out;
  }

  Shell shell_;
};

TEST_F(ProgressOfHypotheses, NamesEachPanelOnATerminalAlone) {
  const std::string h1 =
      "$T hypotheses h1 --features t.csv --predictor tc_early --strata \"\" --replicates 400";
  const std::string drawn = terminal(h1 + " --threads 2");
  EXPECT_NE(drawn.find("paper panel, resamples 400/400"), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("landmark panel, resamples 400/400"), std::string::npos) << drawn;
  const std::string watched = shell_.work().read("out");
  EXPECT_EQ(terminal(h1 + " --threads 1 --quiet").find("resamples"), std::string::npos);
  EXPECT_EQ(shell_.work().read("out"), watched);
  const ProcessResult plain = shell_.run(h1);
  EXPECT_EQ(plain.err.find("resamples"), std::string::npos) << plain.err;
  EXPECT_EQ(plain.out, watched);
}

TEST_F(ProgressOfHypotheses, OfH2CountsPermutationsToo) {
  const std::string drawn = terminal(
      "$T hypotheses h2 --features t.csv --predictor tc_early --strata \"\" --replicates 100 "
      "--permutations 150");
  EXPECT_NE(drawn.find("paper panel, permutations of AUC 150/150"), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("landmark panel, resamples 100/100"), std::string::npos) << drawn;
}

TEST_F(ProgressOfHypotheses, OfTheStudyOfGatesCountsStudies) {
  const std::string drawn = terminal("$T study gate --data-sets 30 --replicates 20");
  EXPECT_NE(drawn.find("micro-studies 30/30"), std::string::npos) << drawn;
}

}  // namespace
}  // namespace tcert
