// That what a message advises works, and is true.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/fit_runs.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

class FitAdvice : public test_support::FitRuns {
 protected:
  static void expect_said(const ProcessResult& run, int exit_code, const std::string& text) {
    EXPECT_EQ(run.exit_code, exit_code) << to_string(run);
    EXPECT_NE((run.out + run.err).find(text), std::string::npos) << to_string(run);
  }

  static void expect_unsaid(const ProcessResult& run, const std::string& text) {
    EXPECT_EQ((run.out + run.err).find(text), std::string::npos) << to_string(run);
  }
};

/// Every row with f = c has y = 1; groups of four rows.
std::string sure_level(int rows) {
  std::string csv = "y,f,g\n";
  for (int i = 0; i < rows; ++i) {
    const bool sure = i % 3 == 2;
    csv += std::string(sure || i * 5 % 7 < 4 ? "1" : "0") + ',' +
           (sure         ? "c"
            : i % 3 == 1 ? "b"
                         : "a") +
           ",g" + std::to_string(i / 4) + '\n';
  }
  return csv;
}

TEST_F(FitAdvice, FirthIsNamedWhereItIsTaken) {
  work_.write("t.csv", sure_level(36));
  const ProcessResult mixed = fit("glmm", "y ~ f + (1 | g)");
  expect_said(mixed, 65, "merge levels or leave the term out");
  expect_unsaid(mixed, "or fit with --firth");
  expect_said(mixed, 65, "fit glm with --firth");
  expect_said(fit("glm", "y ~ f"), 0, "or fit with --firth");
  EXPECT_EQ(fit("glm", "y ~ f", {"--firth"}).exit_code, 0);
  const ProcessResult clustered = fit("glm", "y ~ f", {"--cluster", "g"});
  expect_said(clustered, 0, "or fit with --firth, which goes without clusters");
}

TEST_F(FitAdvice, APerfectAreaIsNotSentToTheBootstrap) {
  work_.write("t.csv", "y,a\n1,5\n1,6\n1,7\n0,1\n0,2\n0,3\n");
  const ProcessResult roc = fit("roc", "y ~ a");
  expect_said(roc, 0, "more rows are needed");
  expect_unsaid(roc, "use the bootstrap");
}

TEST_F(FitAdvice, SharesAndCountsAreToldApart) {
  work_.write("t.csv", "k,n,x\n2,3,1\n2,4,2\n1,4,3\n3,4,1.5\n0,2,3.3\n");
  const ProcessResult share = fit("glm", "k/n ~ x", {"--weights", "n"});
  expect_said(share, 65, "write 'cbind(k, n - k)'");
  expect_unsaid(share, "column == value");
  // What it advises works.
  EXPECT_EQ(fit("glm", "cbind(k, n - k) ~ x").exit_code, 0);
  work_.write("t.csv", "s,n,x\n0.5,4,1\n0.25,4,2\n0.75,4,3\n");
  expect_said(fit("glm", "s ~ x"), 65, "write 'cbind(successes, failures)'");
  work_.write("t.csv", "k,n,x\n2.5,3,1\n2,4,2\n1,4,3\n");
  const ProcessResult fraction = fit("glm", "cbind(k, n - k) ~ x");
  expect_said(fraction, 65, "counts are whole numbers");
  expect_unsaid(fraction, "column == value");
  work_.write("t.csv", "k,n,x\n5,3,1\n2,4,2\n1,4,3\n");
  expect_said(fit("glm", "cbind(k, n - k) ~ x"), 65, "k is at most n");
  work_.write("t.csv", "y,x\n1,1\n2,2\n1,3\n");
  expect_said(fit("glm", "y ~ x"), 65, "write 'column == value'");
}

TEST_F(FitAdvice, FoldsThatAllFailMissNothing) {
  std::string csv = "y,x\n";
  for (int i = 0; i < 20; ++i) {
    csv += std::string(i < 10 ? "0," : "1,") + std::to_string(i) + '\n';
  }
  work_.write("t.csv", csv);
  const ProcessResult run = fit("calibration", "y ~ x");
  expect_said(run, 65, "no row has a prediction");
  expect_unsaid(run, "missing values");
  expect_unsaid(run, "fewer terms or folds");
}

TEST_F(FitAdvice, ProbabilitiesOfNoughtAndOneHaveABrierScore) {
  work_.write("t.csv", "y,p\n1,0.9\n0,0.2\n1,1\n0,0.4\n1,0.7\n0,0\n");
  const ProcessResult run = fit("calibration", "y ~ p", {"--predicted", "p", "--format", "json"});
  expect_said(run,
              0,
              "column 'p': probabilities of exactly 0 or 1 have no logit: 2 rows, the first is row "
              "3 (line 4)");
  const json report = json::parse(run.out);
  EXPECT_NEAR(report["summary"]["brier"].get<double>(), 0.3 / 6.0, 1e-12);
  EXPECT_TRUE(report["calibration"][0]["estimate"].is_null());
  EXPECT_FALSE(report["bins"].empty());
  work_.write("t.csv", "y,p\n1,0.9\n0,0.2\n1,1.5\n0,0.4\n");
  expect_said(
      fit("calibration", "y ~ p", {"--predicted", "p"}),
      65,
      "column 'p': a probability that is not between 0 and 1: 1 row, row 3 (line 4) with 1.5");
}

TEST_F(FitAdvice, ManyLevelsAreOneLine) {
  std::string csv = "y,w\n";
  for (int i = 0; i < 240; ++i) {
    const int level = i % 12;
    csv +=
        std::string(level >= 5 || i * 7 % 5 < 2 ? "1" : "0") + ",w" + std::to_string(level) + '\n';
  }
  work_.write("t.csv", csv);
  const ProcessResult run = fit("glm", "y ~ w", {"--format", "json"});
  expect_said(run, 0, "column 'w': quasi-complete separation: 7 columns (ww10, ww11, ");
  const json report = json::parse(run.out);
  EXPECT_EQ(report["conditions"].size(), 1U) << report["conditions"];
  EXPECT_EQ(report["coefficients"][2]["kind"], "+infinity") << "each is still named in its row";
}

TEST_F(FitAdvice, TablesOfNothingHaveNoP) {
  work_.write("t.csv", "t,e,x,y\n1,1,1,2\n2,1,3,6\n3,0,2,4\n4,1,5,10\n5,1,4,8\n6,0,6,12\n");
  const json cox = json::parse(fit("cox", "Surv(t, e) ~ x + y", {"--format", "json"}).out);
  for (const json& row : cox["drop1"]) {
    if (row["df"].is_null() || row["df"] == 0) {
      EXPECT_TRUE(row["p.value"].is_null()) << row;
    }
  }
  const json null = json::parse(fit("cox", "Surv(t, e) ~ 1", {"--format", "json"}).out);
  for (const auto& [key, value] : null["summary"].items()) {
    if (key.rfind("p.value", 0) == 0) {
      EXPECT_TRUE(value.is_null()) << key;
    }
  }
}

}  // namespace
}  // namespace tcert
