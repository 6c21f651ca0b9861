// What a kind of fit takes, and that the rest is refused rather than passed over.

#include <gtest/gtest.h>

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

constexpr const char* kRows =
    "g,f,x,w,y,t,s\n"
    "1,a,1.0,1,1,12,1\n1,b,0.2,2,0,30,0\n2,a,0.7,1,1,15,1\n2,b,0.9,1,0,14,1\n"
    "3,a,0.4,2,0,22,0\n3,b,0.5,1,1,19,1\n1,a,1.3,1,1,11,1\n2,b,0.1,1,0,31,0\n"
    "3,a,0.8,1,0,13,1\n1,b,1.1,2,1,17,1\n2,a,0.3,1,1,25,0\n3,b,0.6,1,0,18,1\n";

class FitOptions : public test_support::FitRuns {
 protected:
  void SetUp() override { work_.write("t.csv", kRows); }

  static void expect_refused(const ProcessResult& run, const std::string& text) {
    EXPECT_EQ(run.exit_code, 2) << to_string(run);
    EXPECT_NE(run.err.find(text), std::string::npos) << to_string(run);
    EXPECT_EQ(run.out, "");
  }
};

TEST_F(FitOptions, OfAnotherKindAreRefused) {
  expect_refused(fit("roc", "y ~ x", {"--weights", "w"}),
                 "--weights is for glm, glmm, lmm, cox, km and");
  expect_refused(fit("glm", "y ~ x", {"--ties", "efron"}), "--ties is for cox");
  expect_refused(fit("glm", "y ~ x", {"--interval", "bogus"}), "--interval is for km");
  expect_refused(fit("glm", "y ~ x", {"--partial", "nonsense"}), "--partial is for roc");
  expect_refused(fit("glm", "y ~ x", {"--bootstrap", "100"}),
                 "--bootstrap is for roc and concordance");
  expect_refused(fit("cox", "Surv(t, s) ~ x", {"--no-profile"}), "--no-profile is for glm");
}

TEST_F(FitOptions, WhatAPenalisedFitHasNotIsRefused) {
  expect_refused(fit("glm", "y ~ f", {"--firth", "--contrasts", "f"}),
                 "--firth goes without --contrasts and --predict");
  expect_refused(fit("glm", "y ~ f", {"--firth", "--predict", "t.csv"}),
                 "--firth goes without --contrasts and --predict");
}

/// Of x * strata(f) the products alone would be compared, as if the baseline hazards were equal.
TEST_F(FitOptions, StrataAreNotContrasted) {
  expect_refused(fit("cox", "Surv(t, s) ~ x * strata(f)", {"--contrasts", "f"}),
                 "--contrasts: column 'f' makes the strata, which have no ratio of hazards");
}

TEST_F(FitOptions, PartsOfAFormulaThatDoNothingAreRefused) {
  for (const char* kind : {"glm", "roc"}) {
    expect_refused(fit(kind, "y ~ x + (1 | g)"), "'(... | g)'");
    expect_refused(fit(kind, "y ~ x + strata(f)"),
                   "strata() is for calibration, cox, finegray, km and concordance");
  }
  expect_refused(fit("cox", "Surv(t, s) ~ x + (1 | g)"), "use --cluster");
  expect_refused(fit("roc", "y ~ x + offset(w)"), "offset() is for glm");
}

TEST_F(FitOptions, AReferenceNeedsAFactorOfTheFormula) {
  expect_refused(fit("glm", "y ~ x + f", {"--ref", "nosuch=3"}),
                 "--ref: the formula has no column 'nosuch'");
  expect_refused(fit("glm", "y ~ x + g", {"--ref", "g=3"}), "write factor(g)");
  EXPECT_NE(fit("glm", "y ~ x + factor(g)", {"--ref", "g=3"}).exit_code, 2);
}

TEST_F(FitOptions, TheManifestKeepsTheReference) {
  ASSERT_EQ(fit("glm", "y ~ x + f", {"--ref", "f=b", "--output", "o.txt"}).exit_code, 0);
  EXPECT_NE(work_.read("o.txt.manifest.json").find("f=b"), std::string::npos);
}

TEST_F(FitOptions, PairWeightsByTheCensoringNeedPlainTimes) {
  work_.write("t.csv", "a,b,s,x\n0,2,1,1\n1,3,0,2\n0,4,1,3\n1,5,1,1\n");
  expect_refused(fit("concordance", "Surv(a, b, s) ~ x", {"--pair-weight", "S/G"}),
                 "--pair-weight: S/G and n/G2 need Surv(time, event)");
}

TEST_F(FitOptions, ALogisticModelOfTimesPointsToCox) {
  expect_refused(fit("glm", "Surv(t, s) ~ x"),
                 "a logistic model needs a 0/1 outcome; use tcert fit cox");
}

TEST_F(FitOptions, DecimalCommasAreSuggestedAndRead) {
  work_.write("t.csv", "x;y\n0,5;1\n1,5;0\n2,5;1\n3,5;0\n0,7;0\n");
  const ProcessResult without = fit("glm", "y ~ x");
  EXPECT_NE(without.err.find("--decimal-comma reads them as numbers"), std::string::npos);
  const ProcessResult with = fit("glm", "y ~ x", {"--decimal-comma", "--format", "json"});
  ASSERT_EQ(with.exit_code, 0) << to_string(with);
  EXPECT_EQ(json::parse(with.out)["coefficients"].size(), 2U);
}

TEST_F(FitOptions, AnErrorIsSaidBeforeAMissingTable) {
  work_.write("t.csv", "x,y\n1,1\n2,1\n3,1\n");
  const ProcessResult run = fit("roc", "y ~ x", {"--table", "auc"});
  EXPECT_EQ(run.exit_code, 65) << to_string(run);
  EXPECT_NE(run.err.find("all outcomes are the same"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("--table"), std::string::npos) << run.err;
}

TEST_F(FitOptions, HelpOfAKindShowsItsOptionsAndTables) {
  const ProcessResult run = work_.run({"fit", "cox", "--help"});
  EXPECT_NE(run.out.find("--ties"), std::string::npos);
  EXPECT_EQ(run.out.find("--partial"), std::string::npos);
  EXPECT_NE(run.out.find("basehaz"), std::string::npos);
  EXPECT_EQ(run.out.find("thresholds"), std::string::npos);
  EXPECT_EQ(work_.run({"help", "fit", "cox"}).out, run.out);
  EXPECT_NE(work_.run({"fit", "--help"}).out.find("--partial"), std::string::npos);
}

TEST_F(FitOptions, FormulaMistakesAreNamed) {
  expect_refused(fit("glm", "y ~ ."), "name the columns");
  expect_refused(fit("glm", "y ~ log(x, 2, 3)"), "log() takes one argument, found 3");
  work_.write("t.csv", "x,y\n1,goal\n2,wedged\n3,goal\n");
  expect_refused(fit("glm", "y == goal ~ x"), "write y == \"goal\"");
}

}  // namespace
}  // namespace tcert
