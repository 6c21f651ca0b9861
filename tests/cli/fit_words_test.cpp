// That a report says what its numbers are: of which rows, of which outcome, under which assumption.

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
    "g,one,f,term,row,w,y,end,t,s,why\n"
    "1,c,a,1.0,3,1,1,won,12,1,x\n1,c,b,0.2,1,2,0,lost,30,0,z\n2,c,a,0.7,2,1,1,won,15,1,y\n"
    "2,c,b,0.9,4,1,0,lost,14,1,x\n3,c,a,0.4,5,2,0,lost,22,0,\n3,c,b,0.5,1,1,1,won,19,1,\n"
    "1,c,a,1.3,2,1,1,won,11,1,y\n2,c,b,0.1,3,1,0,lost,31,0,z\n3,c,a,0.8,4,1,0,lost,13,1,x\n"
    "1,c,b,1.1,1,2,1,won,17,1,y\n2,c,a,0.3,2,1,1,won,25,0,\n3,c,b,0.6,5,1,0,lost,18,1,x\n";

class FitWords : public test_support::FitRuns {
 protected:
  void SetUp() override { work_.write("t.csv", kRows); }

  static std::vector<json> conditions(const json& report, const std::string& name) {
    std::vector<json> found;
    for (const json& one : report["conditions"]) {
      if (one["name"] == name) {
        found.push_back(one);
      }
    }
    return found;
  }
};

TEST_F(FitWords, ConcordanceCountsItsRows) {
  EXPECT_EQ(document("concordance", "Surv(t, s) ~ term")["summary"]["n"], 12);
  EXPECT_NE(fit("concordance", "Surv(t, s) ~ term").out.find("n = 12"), std::string::npos);
}

TEST_F(FitWords, OneClusterGivesCurvesWithoutAVariance) {
  const json one = document("km", "Surv(t, s) ~ 1", {"--cluster", "one", "--cause", "why"});
  EXPECT_EQ(conditions(one, "one_cluster").size(), 1U);
  for (const char* table : {"curve", "incidence_curve"}) {
    for (const json& point : one[table]) {
      EXPECT_TRUE(point["std.error"].is_null()) << table << point;
      EXPECT_TRUE(point["conf.low"].is_null()) << table << point;
    }
  }
  const json few = document("km", "Surv(t, s) ~ 1", {"--cluster", "g"});
  ASSERT_EQ(conditions(few, "few_clusters").size(), 1U);
  EXPECT_EQ(conditions(few, "few_clusters")[0]["detail"], "all: 3 clusters, fewer than 10");
}

TEST_F(FitWords, AnEventWithoutACauseIsLeftOutAndCounted) {
  const json km = document("km", "Surv(t, s) ~ 1", {"--cause", "why"});
  ASSERT_EQ(conditions(km, "missing_rows").size(), 1U);
  EXPECT_EQ(conditions(km, "missing_rows")[0]["column"], "why");
  EXPECT_EQ(km["n"], 11);
  EXPECT_EQ(km["n_dropped"], 1);
  EXPECT_EQ(km["summary"]["n"], 11);
  for (const json& row : km["incidence"]) {
    EXPECT_NE(row["state"], "z");
  }
  ASSERT_EQ(conditions(km, "no_such_event").size(), 1U);
  EXPECT_EQ(conditions(km, "no_such_event")[0]["detail"], "'z'");
}

TEST_F(FitWords, StrataAloneGiveACurveEach) {
  const json km = document("km", "Surv(t, s) ~ strata(f)");
  EXPECT_EQ(km["groups"].size(), 2U);
  EXPECT_FALSE(km.contains("logrank"));
}

TEST_F(FitWords, WeightsSayThatTheyTakeTheTestAway) {
  const json km = document("km", "Surv(t, s) ~ f", {"--weights", "w"});
  EXPECT_FALSE(km.contains("logrank"));
  EXPECT_EQ(conditions(km, "no_weighted_test").size(), 1U);
}

TEST_F(FitWords, OneGroupIsAWarning) {
  const json km = document("km", "Surv(t, s) ~ one");
  EXPECT_EQ(conditions(km, "one_group")[0]["severity"], "warning");
  EXPECT_FALSE(km["curve"].empty());
}

TEST_F(FitWords, RobustFitsLeaveOutOrMarkWhatTakesRowsAsIndependent) {
  const json glm = document("glm", "y ~ term", {"--cluster", "g"});
  EXPECT_FALSE(glm.contains("drop1"));
  EXPECT_FALSE(glm["coefficients"][0].contains("profile.low"));
  EXPECT_TRUE(document("glm", "y ~ term")["coefficients"][0].contains("profile.low"));
  EXPECT_NE(fit("cox", "Surv(t, s) ~ term", {"--cluster", "g"})
                .out.find("likelihood ratio, rows independent"),
            std::string::npos);
  const json cox = document("cox", "Surv(t, s) ~ term", {"--cluster", "g"});
  EXPECT_TRUE(cox["summary"].contains("p.value.log.rows_independent"));
  EXPECT_FALSE(cox["summary"].contains("p.value.log"));
  EXPECT_TRUE(document("cox", "Surv(t, s) ~ term")["summary"].contains("p.value.log"));
}

TEST_F(FitWords, TheNullModelOfAFitWithoutInterceptHasAllDegreesOfFreedom) {
  EXPECT_EQ(document("glm", "y ~ term")["summary"]["df.null"], 11);
  EXPECT_EQ(document("glm", "y ~ term + 0")["summary"]["df.null"], 12);
}

TEST_F(FitWords, APredictorCalledTermOrRowLosesNothing) {
  const json glm = document("glm", "y ~ term");
  EXPECT_EQ(glm["vcov"][1][".term"], "term");
  EXPECT_TRUE(glm["vcov"][1]["term"].is_number());
  const json cox = document("cox", "Surv(t, s) ~ row", {"--residuals", "dfbeta"});
  EXPECT_EQ(cox["dfbeta"][1][".row"], 2);
  EXPECT_TRUE(cox["dfbeta"][1]["row"].is_number());
}

TEST_F(FitWords, TheOutcomeIsNamed) {
  EXPECT_NE(fit("glm", "y ~ term").out.find("log odds of 'y' = 1"), std::string::npos);
  const ProcessResult text = fit("glm", "end ~ term");
  EXPECT_NE(text.out.find("log odds of 'end' = won (against lost)"), std::string::npos) << text.out;
  const json coded = document("glm", "end ~ term");
  EXPECT_EQ(coded["event_level"], "won");
  EXPECT_EQ(conditions(coded, "text_outcome").size(), 1U);
}

TEST_F(FitWords, AfterAnErrorThereIsTheErrorAlone) {
  work_.write("t.csv", "x,y\n1,1\n2,1e-9\n3,0\n4,1\n");
  const ProcessResult run = fit("glm", "y ~ x");
  EXPECT_EQ(run.exit_code, 65);
  EXPECT_EQ(run.out.find("NA"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("found 1e-09 in row 2 (line 3)"), std::string::npos) << run.out;
  const json glm = document("glm", "y ~ x", {}, 65);
  EXPECT_EQ(glm["summary"]["termination"], "no fit");
  EXPECT_EQ(glm["n"], 4);
  EXPECT_EQ(glm["summary"]["nobs"], 4);
  work_.write("t.csv", "x,y\n");
  EXPECT_NE(fit("glm", "y ~ x").err.find("the table has a header and no rows"), std::string::npos);
}

TEST_F(FitWords, NumbersAreShownAsTheyAre) {
  EXPECT_EQ(document("glm", "y ~ term", {"--level", "0.9999999"})["level"], 0.9999999);
}

}  // namespace
}  // namespace tcert
