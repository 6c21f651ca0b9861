// Predictions for other rows, risks at times, competing causes (scripts/golden/predictions.R,
// competing.R).

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/fit_runs.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;

json golden(const std::string& name) {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/" + name);
  return json::parse(file);
}

class FitPredict : public test_support::FitRuns {
 protected:
  void take(const json& all) {
    work_.write("t.csv", all["csv"].get<std::string>() + "\n");
    if (all.contains("new")) {
      work_.write("new.csv", all["new"].get<std::string>() + "\n");
    }
  }

  void expect_said(const ProcessResult& run, int exit_code, const std::string& text) {
    EXPECT_EQ(run.exit_code, exit_code) << to_string(run);
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
  }
};

TEST_F(FitPredict, ProbabilitiesOfNewRowsAreThoseOfR) {
  const json all = golden("predictions.json");
  take(all);
  const json& r = all["glm"];
  const json rows =
      document("glm", "y ~ x + scale(z) + light", {"--predict", "new.csv"})["predictions"];
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(rows[i]["row"], i + 1);
    EXPECT_NEAR(rows[i]["estimate"].get<double>(), r["probability"][i].get<double>(), 1e-8);
    EXPECT_NEAR(rows[i]["log.odds"].get<double>(), r["eta"][i].get<double>(), 1e-8);
    EXPECT_NEAR(rows[i]["std.error"].get<double>(), r["se"][i].get<double>(), 1e-7);
    EXPECT_NEAR(rows[i]["conf.low"].get<double>(), r["low"][i].get<double>(), 1e-7);
    EXPECT_NEAR(rows[i]["conf.high"].get<double>(), r["high"][i].get<double>(), 1e-7);
  }
}

TEST_F(FitPredict, SurvivalOfNewRowsAndItsScoresAreThoseOfR) {
  const json all = golden("predictions.json");
  take(all);
  const json run = document(
      "cox", "Surv(time, event) ~ x + z + light", {"--times", "8,20", "--predict", "new.csv"});
  const json& rows = run["predictions"];
  ASSERT_EQ(rows.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t row = i / 2;
    const std::size_t time = i % 2;
    EXPECT_NEAR(rows[i]["estimate"].get<double>(), all["survival"][row][time].get<double>(), 1e-8);
    EXPECT_NEAR(
        rows[i]["std.error"].get<double>(), all["survival_se"][row][time].get<double>(), 1e-7);
    EXPECT_NEAR(rows[i]["conf.low"].get<double>(), all["lower"][row][time].get<double>(), 1e-7);
    EXPECT_NEAR(rows[i]["conf.high"].get<double>(), all["upper"][row][time].get<double>(), 1e-7);
    EXPECT_NEAR(rows[i]["risk"].get<double>() + rows[i]["estimate"].get<double>(), 1.0, 1e-14);
  }
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_NEAR(run["scores"][t]["auc"].get<double>(), all["auc"][t].get<double>(), 1e-8);
    EXPECT_NEAR(run["scores"][t]["brier"].get<double>(), all["brier"][t].get<double>(), 1e-8);
  }
}

TEST_F(FitPredict, WhatTheFitHasNotSeenIsRefusedByName) {
  take(golden("predictions.json"));
  work_.write("fog.csv", "x,z,light\n1,0,fog\n");
  expect_said(
      fit("glm", "y ~ x + light", {"--predict", "fog.csv"}), 2, "the fit has not seen 'fog'");
  work_.write("text.csv", "x,light\nmany,dim\nfew,dark\n");
  expect_said(fit("glm", "y ~ x + light", {"--predict", "text.csv"}), 2, "holds text");
  work_.write("short.csv", "x\n1\n");
  expect_said(fit("glm", "y ~ x + light", {"--predict", "short.csv"}), 2, "no column 'light'");
  expect_said(fit("cox", "Surv(time, event) ~ x", {"--predict", "new.csv"}), 2, "needs --times");
  work_.write("gap.csv", "x,light\n1,dim\n,dim\n");
  const json gap = document("glm", "y ~ x + light", {"--predict", "gap.csv"});
  ASSERT_EQ(gap["predictions"].size(), 1U);
  EXPECT_EQ(gap["predictions"][0]["row"], 1);
}

TEST_F(FitPredict, OneClusterHasPredictionsWithoutIntervals) {
  take(golden("predictions.json"));
  work_.write("one.csv",
              "y,x,day,time\n1,1,a,3\n0,2,a,4\n1,3,a,1\n0,1,a,7\n1,2,a,2\n0,4,a,9\n1,4,a,5\n");
  work_.write("x.csv", "x\n1\n2\n");
  for (const std::string kind : {"glm", "cox"}) {
    std::vector<std::string> arguments{"fit", kind, "--data", "one.csv", "--cluster", "day"};
    arguments.insert(arguments.end(), {"--predict", "x.csv", "--format", "json", "--formula"});
    arguments.emplace_back(kind == "glm" ? "y ~ x" : "Surv(time, y) ~ x");
    if (kind == "cox") {
      arguments.insert(arguments.end(), {"--times", "3"});
    }
    const ProcessResult run = work_.run(arguments);
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
    const json rows = json::parse(run.out)["predictions"];
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(rows[0]["estimate"].is_number());
    EXPECT_TRUE(rows[0]["conf.low"].is_null()) << rows.dump();
  }
}

/// With clusters intervals are Student's, by the covariance that --inference names.
TEST_F(FitPredict, IntervalsOfClustersAreByWhatIsAskedFor) {
  take(golden("predictions.json"));
  const std::string formula = "Surv(time, event) ~ x + z + light";
  const auto width = [&](const std::string& inference) {
    const json row = document("cox",
                              formula,
                              {"--times",
                               "8",
                               "--predict",
                               "new.csv",
                               "--cluster",
                               "day",
                               "--inference",
                               inference})["predictions"][0];
    const double low = std::log(row["conf.low"].get<double>());
    const double log_se = row["std.error"].get<double>() / row["estimate"].get<double>();
    EXPECT_NEAR((std::log(row["estimate"].get<double>()) - low) / log_se, 2.1447866879, 1e-6)
        << "qt(0.975, 14)";
    return log_se;
  };
  EXPECT_NE(width("jackknife"), width("cr1"));
  EXPECT_NE(width("cr2"), width("cr1"));
  EXPECT_EQ(width("wild"), width("cr1"));
  const ProcessResult table = fit(
      "glm", "y ~ x + light", {"--predict", "new.csv", "--cluster", "day", "--inference", "cr2"});
  EXPECT_NE(table.out.find("Satterthwaite's are of a coefficient"), std::string::npos)
      << to_string(table);
}

TEST_F(FitPredict, AStratumThatTheFitHasNotSeenIsRefused) {
  work_.write(
      "s.csv",
      "time,y,x,s\n1,1,1,1\n2,1,3,1\n3,0,2,1\n4,1,1,1\n1,1,2,2\n2,0,1,2\n3,1,3,2\n5,1,2,2\n");
  work_.write("new.csv", "x,s\n1,1\n2,3\n");
  const ProcessResult run = work_.run({"fit",
                                       "cox",
                                       "--data",
                                       "s.csv",
                                       "--formula",
                                       "Surv(time, y) ~ x + strata(s)",
                                       "--predict",
                                       "new.csv",
                                       "--times",
                                       "2"});
  expect_said(run, 2, "row 2 of new.csv: the fit has not seen stratum");
}

/// A hazard at year 0 underflows: no run may hang or have no risks for that.
TEST_F(FitPredict, YearsAreColumnsAsAnyOther) {
  std::string csv = "t,e,year\n";
  for (int k = 0; k < 40; ++k) {
    csv += std::to_string(1 + (k * 7) % 11) + "," + (k % 4 == 0 ? "0" : "1") + "," +
           std::to_string(2000 + (k * 5) % 9) + "\n";
  }
  work_.write("t.csv", csv);
  const json run = document("cox", "Surv(t, e) ~ year", {"--times", "5"});
  EXPECT_TRUE(run["scores"][0]["auc"].is_number()) << run["scores"].dump();
}

TEST_F(FitPredict, ACoxModelIsCalibratedOutOfFold) {
  take(golden("predictions.json"));
  const json run = document(
      "calibration", "Surv(time, event) ~ x + z + light", {"--times", "8,20", "--cluster", "day"});
  ASSERT_EQ(run["calibration"].size(), 2U);
  for (std::size_t t = 0; t < 2; ++t) {
    const json& row = run["calibration"][t];
    EXPECT_NEAR(row["expected"].get<double>(), row["estimate"].get<double>(), 0.15);
    EXPECT_GT(row["slope"].get<double>(), 0.3);
    EXPECT_LT(row["slope.low"].get<double>(), row["slope"].get<double>());
    EXPECT_LT(run["scores"][t]["brier"].get<double>(),
              run["scores"][t]["brier.null"].get<double>());
  }
  EXPECT_EQ(run["summary"]["folds"], 5);
  EXPECT_EQ(run["bins"].size(), 20U);
}

TEST_F(FitPredict, CompetingCausesAndRestrictedMeansAreThoseOfR) {
  const json all = golden("competing.json");
  take(all);
  const std::string causes = "Surv(time, cause > 0) ~ ";
  const json km = document("km", causes + "group", {"--cause", "cause", "--rmst", "18"});
  for (std::size_t cause = 0; cause < 2; ++cause) {
    EXPECT_NEAR(km["gray"][cause]["statistic"].get<double>(),
                all["gray"][0]["statistic"][cause].get<double>(),
                1e-8);
  }
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_NEAR(
        km["rmst"][g]["estimate"].get<double>(), all["rmst"]["mean"][g].get<double>(), 1e-9);
    EXPECT_NEAR(km["rmst"][3 + g]["std.error"].get<double>(),
                all["rmst"]["difference_se"][g].get<double>(),
                1e-9);
  }
  const json model = document(
      "finegray", causes + "x + z", {"--cause", "cause", "--event", "1", "--cluster", "day"});
  for (std::size_t j = 0; j < 2; ++j) {
    const json& r = all["fine_gray"][0];
    EXPECT_NEAR(
        model["coefficients"][j]["estimate"].get<double>(), r["estimate"][j].get<double>(), 1e-7);
    EXPECT_NEAR(
        model["coefficients"][j]["robust.se"].get<double>(), r["by_day"][j].get<double>(), 1e-7);
  }
  EXPECT_EQ(model["cause_specific"].size(), 2U);
  EXPECT_GT(model["coefficients"][0]["t.std.error"].get<double>(), 0.0);
  expect_said(fit("finegray", causes + "x", {"--cause", "cause"}), 2, "--event");
  expect_said(fit("finegray", causes + "x", {"--cause", "cause", "--event", "9"}), 2, "'9'");
  expect_said(fit("km", causes + "group", {"--rmst", "0"}), 2, "one time above 0");
}

}  // namespace
}  // namespace tcert
