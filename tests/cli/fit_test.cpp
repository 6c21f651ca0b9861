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

/// Twenty-four trials on six days, hand-made: overlapping outcomes, ties in time and predictor.
constexpr const char* kTrials =
    "day,light,x,z,success,time_s,end\n"
    "a,dim,1.0,3,1,12,goal\na,dark,0.2,1,0,30,wedged\na,dim,0.7,2,1,15,goal\na,dark,0.9,4,1,14,"
    "goal\n"
    "b,dim,0.4,5,0,22,wedged\nb,dark,0.5,1,1,19,goal\nb,dim,1.3,2,1,11,goal\nb,dark,0.1,3,0,30,"
    "timeout\n"
    "c,dim,0.8,4,1,14,goal\nc,dark,1.1,1,1,12,goal\nc,dim,0.3,2,0,25,wedged\nc,dark,0.6,5,1,18,"
    "goal\n"
    "d,dim,0.9,3,0,30,timeout\nd,dark,0.4,2,1,21,goal\nd,dim,1.2,1,1,13,goal\nd,dark,0.2,4,0,28,"
    "wedged\n"
    "e,dim,0.6,2,1,17,goal\ne,dark,0.8,3,1,16,goal\ne,dim,0.5,1,0,30,timeout\ne,dark,1.0,5,1,15,"
    "goal\n"
    "f,dim,0.7,4,1,16,goal\nf,dark,0.3,2,1,23,goal\nf,dim,1.1,3,1,12,goal\nf,dark,0.5,1,0,27,"
    "wedged\n";

class Fit : public test_support::FitRuns {
 protected:
  void SetUp() override { work_.write("t.csv", kTrials); }
};

TEST_F(Fit, GlmmPrintsOneDocumentWithBroomsNames) {
  const json glmm = document("glmm", "success ~ x + (1 | day)", {"--profile", "--drop1"});
  EXPECT_EQ(glmm["model"], "glmm");
  ASSERT_EQ(glmm["coefficients"].size(), 3U);
  const json& x = glmm["coefficients"][1];
  for (const char* key : {"effect",
                          "group",
                          "term",
                          "estimate",
                          "std.error",
                          "statistic",
                          "p.value",
                          "conf.low",
                          "conf.high",
                          "profile.low",
                          "profile.high",
                          "odds.ratio"}) {
    EXPECT_TRUE(x.contains(key)) << key;
  }
  EXPECT_EQ(x["effect"], "fixed");
  EXPECT_TRUE(x["profile.low"].is_number());
  const json& sd = glmm["coefficients"][2];
  EXPECT_EQ(sd["effect"], "ran_pars");
  EXPECT_EQ(sd["group"], "day");
  EXPECT_EQ(sd["term"], "sd__(Intercept)");
  EXPECT_TRUE(sd["estimate"].is_number());
  EXPECT_EQ(glmm["summary"]["nAGQ"], 15);
  EXPECT_EQ(glmm["summary"]["termination"], "converged");
  EXPECT_LT(glmm["summary"]["gradient_norm"].get<double>(), 1e-8);
  EXPECT_EQ(glmm["random"][0]["dropped"], "(Intercept)");
  EXPECT_EQ(glmm["ran_vals"].size(), 6U);
  EXPECT_EQ(glmm["drop1"][0]["term"], "x");
  EXPECT_EQ(document("glmm", "success ~ x + (1 | day)", {"--quadrature", "1"})["summary"]["nAGQ"],
            1);
}

TEST_F(Fit, GlmmNamesWhatItCannotFit) {
  const ProcessResult none = fit("glmm", "success ~ x");
  EXPECT_EQ(none.exit_code, 65) << to_string(none);
  EXPECT_NE(none.err.find("no random effect; write + (1 | group)"), std::string::npos) << none.err;
  const ProcessResult separated = fit("glmm", "success ~ end + z + (1 | day)");
  EXPECT_EQ(separated.exit_code, 65) << to_string(separated);
  EXPECT_NE(separated.err.find("endwedged"), std::string::npos) << separated.err;
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--quadrature", "101"}, {"--quadrature", "-1"}, {"--cluster", "day"}, {"--robust"}}) {
    EXPECT_EQ(fit("glmm", "success ~ x + (1 | day)", more).exit_code, 2) << more[0];
  }
  EXPECT_EQ(fit("glmm", "success ~ x + (1 + x | day)", {"--quadrature", "5"}).exit_code, 2);
  const ProcessResult glm = fit("glm", "success ~ x + (1 | day)");
  EXPECT_EQ(glm.exit_code, 2);
  EXPECT_NE(glm.err.find("fitted by 'fit glmm'"), std::string::npos) << glm.err;
}

TEST_F(Fit, GlmPrintsOneDocumentWithBroomsNames) {
  const json glm = document("glm", "success ~ x + light");
  EXPECT_EQ(glm["model"], "glm");
  EXPECT_EQ(glm["formula"], "success ~ x + light");
  EXPECT_EQ(glm["n"], 24);
  ASSERT_EQ(glm["coefficients"].size(), 3U);
  const json& x = glm["coefficients"][1];
  for (const char* key : {"term",
                          "estimate",
                          "std.error",
                          "statistic",
                          "p.value",
                          "conf.low",
                          "conf.high",
                          "profile.low",
                          "profile.high"}) {
    EXPECT_TRUE(x.contains(key)) << key;
  }
  EXPECT_EQ(x["term"], "x");
  EXPECT_GT(x["estimate"].get<double>(), 0.0);
  EXPECT_EQ(glm["summary"]["termination"], "converged");
  EXPECT_EQ(glm["vcov"].size(), 3U);
  EXPECT_TRUE(glm["conditions"].empty());
}

TEST_F(Fit, SeparationSuggestsFirthWhichHasAnEstimate) {
  work_.write("t.csv", "x,y\n1,0\n2,0\n3,1\n4,1\n");
  const ProcessResult plain = fit("glm", "y ~ x");
  EXPECT_EQ(plain.exit_code, 65);
  EXPECT_NE(plain.err.find("fit with --firth"), std::string::npos) << plain.err;
  const json firth = document("glm", "y ~ x", {"--firth"});
  ASSERT_EQ(firth["coefficients"].size(), 2U);
  const json& x = firth["coefficients"][1];
  EXPECT_GT(x["estimate"].get<double>(), 0.0);
  EXPECT_GT(x["profile.high"].get<double>(), x["estimate"].get<double>());
  EXPECT_EQ(x["statistic"], firth["drop1"][0]["statistic"]);
  EXPECT_EQ(firth["summary"]["separation"], "complete");
  EXPECT_EQ(firth["conditions"][0]["name"], "penalised_separation");
  EXPECT_EQ(firth["vcov"].size(), 2U);
  const ProcessResult clustered = fit("glm", "y ~ x", {"--firth", "--robust"});
  EXPECT_EQ(clustered.exit_code, 2);
}

TEST_F(Fit, CalibrationIsOutOfFoldOrOfGivenProbabilities) {
  const json fitted =
      document("calibration", "success ~ x", {"--cluster", "day", "--folds", "3", "--seed", "2"});
  EXPECT_EQ(fitted["summary"]["folds"], 3);
  EXPECT_EQ(fitted["summary"]["predicted"], "out of fold");
  EXPECT_EQ(fitted["calibration"].size(), 3U);
  EXPECT_EQ(fitted["predictions"].size(), 24U);
  EXPECT_FALSE(fitted["bins"].empty());
  // The given column of probabilities is calibrated as it is.
  std::string csv = "p,y\n";
  for (const json& row : fitted["predictions"]) {
    if (!row["predicted"].is_null()) {
      csv += row["predicted"].dump() + "," + row["outcome"].dump() + "\n";
    }
  }
  work_.write("t.csv", csv);
  const json given = document("calibration", "y ~ p", {"--predicted", "p"});
  EXPECT_EQ(given["calibration"][0]["estimate"], fitted["calibration"][0]["estimate"]);
  EXPECT_EQ(given["brier"], fitted["brier"]);
  EXPECT_EQ(fit("calibration", "y ~ p", {"--predicted", "q"}).exit_code, 2);
  work_.write("t.csv", "p,y\n0.5,1\n1.5,0\n0.2,0\n");
  const ProcessResult outside = fit("calibration", "y ~ p", {"--predicted", "p"});
  EXPECT_EQ(outside.exit_code, 65);
  EXPECT_NE(outside.err.find("not between 0 and 1"), std::string::npos) << outside.err;
}

TEST_F(Fit, CoxTakesStrataClustersResidualsAndCurves) {
  const json cox =
      document("cox",
               "Surv(time_s, success) ~ x + z + strata(light)",
               {"--cluster", "day", "--residuals", "martingale,dfbeta", "--curves", "1,2"});
  EXPECT_EQ(cox["summary"]["clusters"], 6);
  EXPECT_EQ(cox["summary"]["variance"], "robust");
  EXPECT_FALSE(cox["coefficients"][0]["robust.se"].is_null());
  EXPECT_EQ(cox["martingale"].size(), 24U);
  EXPECT_EQ(cox["dfbeta"].size(), 24U);
  EXPECT_EQ(cox["zph"].back()["term"], "GLOBAL");
  EXPECT_FALSE(cox["curves"].empty());
  EXPECT_FALSE(cox["basehaz"].empty());
  // Twenty-four rows on six days: said, not hidden.
  EXPECT_EQ(cox["conditions"][0]["name"], "few_clusters");
}

TEST_F(Fit, KmComparesGroupsAndCauses) {
  const json km =
      document("km", "Surv(time_s, success) ~ light", {"--cause", "end", "--times", "20"});
  EXPECT_EQ(km["groups"].size(), 2U);
  EXPECT_EQ(km["groups"][0]["strata"], "light=dark");
  EXPECT_EQ(km["times"].size(), 2U);
  EXPECT_EQ(km["summary"]["df"], 1);
  EXPECT_FALSE(km["incidence"].empty());
}

TEST_F(Fit, RocAndConcordanceCompareAndBootstrapByCluster) {
  const json roc =
      document("roc",
               "success ~ x + I(-z)",
               {"--cluster", "day", "--bootstrap", "200", "--partial", "specificity:0.5:1"});
  EXPECT_EQ(roc["auc"].size(), 2U);
  EXPECT_EQ(roc["differences"].size(), 1U);
  EXPECT_EQ(roc["bootstrap"].size(), 3U);
  EXPECT_FALSE(roc["auc"][0]["partial.area"].is_null());
  EXPECT_EQ(roc["bootstrap"][0]["estimate"], roc["auc"][0]["estimate"]);
  const json c = document("concordance",
                          "Surv(time_s, success) ~ x + z",
                          {"--reverse", "--cluster", "day", "--bootstrap", "200"});
  EXPECT_GT(c["concordance"][0]["estimate"].get<double>(), 0.8);
  EXPECT_EQ(c["bootstrap"][0]["estimate"], c["concordance"][0]["estimate"]);
  const json forward = document("concordance", "Surv(time_s, success) ~ x");
  EXPECT_NEAR(forward["concordance"][0]["estimate"].get<double>(),
              1.0 - c["concordance"][0]["estimate"].get<double>(),
              1e-15);
}

TEST_F(Fit, OtherFormatsShowTheMainTableOrTheChosenOne) {
  const ProcessResult csv = fit("glm", "success ~ x", {"--format", "csv"});
  EXPECT_EQ(csv.out.substr(0, csv.out.find('\n')),
            "term,estimate,std.error,statistic,p.value,conf.low,conf.high,profile.low,profile.high,"
            "profile.open,odds.ratio,odds.ratio.low,odds.ratio.high,odds.ratio.profile.low,"
            "odds.ratio.profile.high,kind");
  const ProcessResult tex = fit("glm", "success ~ x", {"--format", "tex", "--table", "drop1"});
  EXPECT_NE(tex.out.find("\\toprule"), std::string::npos);
  const ProcessResult wrong = fit("glm", "success ~ x", {"--table", "zph"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("expected one of summary, coefficients, drop1, vcov"), std::string::npos)
      << wrong.err;
}

TEST_F(Fit, ThreadsDoNotChangeAByte) {
  std::string first;
  for (const char* threads : {"1", "2"}) {
    const ProcessResult run = fit(
        "roc", "success ~ x + z", {"--bootstrap", "500", "--threads", threads, "--format", "json"});
    first = first.empty() ? run.out : first;
    EXPECT_EQ(run.out, first);
  }
}

TEST_F(Fit, SaysWhatIsWrongWithTheCall) {
  const auto expect_usage = [&](const ProcessResult& run, const std::string& text) {
    EXPECT_EQ(run.exit_code, 2) << to_string(run);
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
  };
  expect_usage(
      fit("coxx", "y ~ x"),
      "unknown kind 'coxx', expected glm, glmm, lmm, calibration, cox, finegray, km, roc or "
      "concordance");
  expect_usage(fit("glm", "succes ~ x"), "no column 'succes' in t.csv; did you mean 'success'?");
  expect_usage(fit("glm", "success x"), "unexpected 'x' at character 9");
  expect_usage(fit("cox", "Surv(time_s, success) ~ x", {"--ties", "efrom"}),
               "--ties: found 'efrom', expected one of efron, breslow, exact");
  expect_usage(fit("cox", "Surv(time_s, success) ~ x", {"--ties", "exact", "--cluster", "day"}),
               "--ties exact goes without");
  expect_usage(fit("glm", "success ~ light", {"--ref", "light=dusk"}),
               "column 'light' has no level 'dusk', only dark, dim");
  EXPECT_EQ(work_.run({"fit", "glm", "--data", "no.csv", "--formula", "y ~ x"}).exit_code, 66);
}

TEST_F(Fit, SaysWhatIsWrongWithTheData) {
  const auto expect_bad = [&](const std::string& csv,
                              const std::string& kind,
                              const std::string& formula,
                              const std::string& condition) {
    work_.write("t.csv", csv);
    const ProcessResult run = fit(kind, formula, {"--format", "json"});
    EXPECT_EQ(run.exit_code, 65) << to_string(run);
    const json document = json::parse(run.out);
    bool found = false;
    for (const json& one : document["conditions"]) {
      found = found || one["name"] == condition;
    }
    EXPECT_TRUE(found) << condition << "\n" << run.out;
    EXPECT_NE(run.err.find("tcert fit: error: "), std::string::npos) << run.err;
  };
  expect_bad("x,y\n1,0\n2,0\n3,1\n4,1\n", "glm", "y ~ x", "complete_separation");
  expect_bad("x,y\n1,1\n2,1\n3,1\n", "glm", "y ~ x", "one_class");
  expect_bad("x,y\n1,1\n2,2\n3,0\n", "glm", "y ~ x", "not_binary");
  expect_bad("x,y\n1,1\nInf,0\n3,0\n", "glm", "y ~ x", "infinite_value");
  expect_bad("x,y\n", "glm", "y ~ x", "no_rows");
  expect_bad("x,t,s\n1,2,0\n2,3,0\n", "cox", "Surv(t, s) ~ x", "no_events");
  expect_bad("x,t,s\n1,-2,0\n2,3,1\n", "cox", "Surv(t, s) ~ x", "time_not_positive");
  expect_bad("x,t,s\n1,2,1\n2,3,2\n", "concordance", "Surv(t, s) ~ x", "not_binary");
  expect_bad("x,y\n1,1\n2,1\n", "roc", "y ~ x", "one_class");
}

}  // namespace
}  // namespace tcert
