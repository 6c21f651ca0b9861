// Times as `fit` and `check` take them: stamps, stamps among durations, rounding.

#include <gtest/gtest.h>

#include <algorithm>
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

class FitTimes : public test_support::FitRuns {
 protected:
  /// Twelve trials in whole seconds, from `origin` on.
  static std::string trials(long long origin) {
    const std::vector<int> seconds{8, 54, 71, 72, 90, 101, 120, 133, 140, 158, 171, 190};
    std::string csv = "begin,stamp,ev,x\n";
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      const long long stop = origin + seconds[i];
      csv += std::to_string(stop - 20) + "," + std::to_string(stop) + "," +
             (i % 4 == 2 ? "0" : "1") + "," + std::to_string((i * 7) % 5) + "\n";
    }
    return csv;
  }

  ProcessResult good_fit(const std::string& kind,
                         const std::string& formula,
                         std::vector<std::string> more = {}) {
    const ProcessResult run = fit(kind, formula, std::move(more));
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run;
  }
};

TEST_F(FitTimes, StampsGiveWhatTheirDifferencesGive) {
  work_.write("t.csv", trials(1'700'000'000));
  const std::string shifted = "stamp - 1700000000";
  for (const std::string kind : {"cox", "concordance"}) {
    const ProcessResult stamps = good_fit(kind, "Surv(stamp, ev) ~ x", {"--format", "csv"});
    EXPECT_EQ(stamps.out, good_fit(kind, "Surv(" + shifted + ", ev) ~ x", {"--format", "csv"}).out);
    EXPECT_NE(stamps.err.find("R's timefix"), std::string::npos) << stamps.err;
  }
  const ProcessResult curve = good_fit("km", "Surv(stamp, ev) ~ 1", {"--table", "curve"});
  EXPECT_NE(curve.out.find("1700000054"), std::string::npos) << curve.out;
  EXPECT_NE(curve.err.find("times are stamps, not durations"), std::string::npos) << curve.err;
  const ProcessResult intervals =
      good_fit("cox", "Surv(begin, stamp, ev) ~ x", {"--format", "csv"});
  EXPECT_NE(intervals.err.find("subtract the first time"), std::string::npos);
  EXPECT_EQ(intervals.err.find("times are stamps"), std::string::npos) << "a clock of all trials";
  work_.write("t.csv", trials(1'000));
  EXPECT_EQ(intervals.out, good_fit("cox", "Surv(begin, stamp, ev) ~ x", {"--format", "csv"}).out);
}

TEST_F(FitTimes, AStampAmongSecondsIsNamed) {
  work_.write("t.csv", "success,time_s,x\n1,5,1\n1,9,2\n1,13,3\n1,17,4\n0,1764174008,5\n");
  const ProcessResult curve =
      good_fit("km", "Surv(time_s, success) ~ 1", {"--table", "curve", "--format", "csv"});
  for (const std::string row : {"all,5,5,1,", "all,9,4,1,", "all,13,3,1,", "all,17,2,1,"}) {
    EXPECT_NE(curve.out.find(row), std::string::npos) << curve.out;
  }
  EXPECT_NE(
      curve.err.find("warning: column 'time_s': a time far from the others: found 1764174008"),
      std::string::npos)
      << curve.err;
  const ProcessResult check = work_.run({"check", "t.csv"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_NE(check.out.find("1764174008, 1.36e+08 times the median of 13"), std::string::npos)
      << check.out;
}

TEST_F(FitTimes, RoundingIsSaidAndCanBeTurnedOff) {
  work_.write("t.csv",
              "a,b,ev\n1700000000.1,1700000010.1,1\n1700000000.4,1700000010.4,1\n"
              "1700000000.7,1700000010.7,1\n0,30,1\n");
  const auto points = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--format", "json", "--table", "curve"});
    const ProcessResult run = good_fit("km", "Surv(b - a, ev) ~ 1", more);
    return json::parse(run.out).size();
  };
  EXPECT_LE(points({}), points({"--no-time-rounding"}));
  work_.write("t.csv", "t,ev\n0.3,1\n0.30000000000000004,1\n0.5,1\n");
  const auto rows = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--table", "curve", "--format", "csv"};
    all.insert(all.end(), more.begin(), more.end());
    const std::string out = good_fit("km", "Surv(t, ev) ~ 1", all).out;
    return std::count(out.begin(), out.end(), '\n') - 1;
  };
  EXPECT_EQ(rows({}), 2);
  EXPECT_EQ(rows({"--no-time-rounding"}), 3);
  // What R would make equal is said then too.
  EXPECT_EQ(good_fit("km", "Surv(t, ev) ~ 1").out.find("R's timefix"), std::string::npos);
  EXPECT_NE(good_fit("km", "Surv(t, ev) ~ 1", {"--no-time-rounding"}).out.find("R's timefix"),
            std::string::npos);
}

TEST_F(FitTimes, AHypothesisSaysNearTimesThatItKeepsApart) {
  std::string csv = "ev,t,x\n1,10.000000001,3\n";
  for (int i = 0; i < 40; ++i) {
    csv += std::to_string(i % 3 == 0 ? 0 : 1) + ',' + std::to_string(10 + i) + ',' +
           std::to_string(i * 7 % 11) + '\n';
  }
  work_.write("t.csv", csv);
  const auto said = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"hypotheses",
                                       "h1",
                                       "--features",
                                       "t.csv",
                                       "--success",
                                       "ev",
                                       "--time",
                                       "t",
                                       "--strata",
                                       "",
                                       "--predictor",
                                       "x",
                                       "--replicates",
                                       "20"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult run = work_.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run.out;
  };
  EXPECT_EQ(said({}).find("R's timefix"), std::string::npos);
  EXPECT_NE(said({"--no-time-rounding"}).find("R's timefix"), std::string::npos);
}

TEST_F(FitTimes, ATimeOfTheCurveFindsItsStep) {
  work_.write("t.csv",
              "a,b,ev\n0.1,0.4,1\n15.8,16.1,1\n100.1,112.44449,1\n3.3,5.56789123,0\n1,13.3,1\n");
  const json curve =
      json::parse(good_fit("km", "Surv(b - a, ev) ~ 1", {"--format", "json"}).out)["curve"];
  ASSERT_GE(curve.size(), 4U);
  // As text prints them, as data formats do, and as one would write them.
  for (const std::string times : {"0.3,2.26789123,12.3,12.34449", "0.30000000000000004,12.34449"}) {
    const json rows = json::parse(
        good_fit("km", "Surv(b - a, ev) ~ 1", {"--format", "json", "--times", times}).out)["times"];
    EXPECT_NEAR(rows[0]["estimate"].get<double>(), 0.6, 1e-12) << times;
    EXPECT_EQ(rows[0]["n.risk"].get<double>(), 5.0);
    EXPECT_EQ(rows[0]["n.event"].get<double>(), 2.0);
    EXPECT_NEAR(rows.back()["estimate"].get<double>(), 0.0, 1e-12) << times;
  }
}

TEST_F(FitTimes, AMonotoneFitKeepsItsTables) {
  std::string csv = "t,e,x,g\n";
  const std::string groups = "abc";
  for (int i = 0; i < 30; ++i) {
    const char group = groups[static_cast<std::size_t>(i % 3)];
    csv += std::to_string(3 + (i * 17) % 31) + "," + (group == 'c' || i % 5 == 4 ? "0" : "1") +
           "," + std::to_string((i * 13) % 7) + "," + group + "\n";
  }
  work_.write("t.csv", csv);
  const ProcessResult run =
      good_fit("cox",
               "Surv(t, e) ~ g + x",
               {"--format", "json", "--residuals", "martingale", "--curves", "1"});
  const json document = json::parse(run.out);
  for (const char* const table :
       {"zph", "zph_columns", "drop1", "anova", "basehaz", "martingale", "curves"}) {
    EXPECT_TRUE(document.contains(table)) << table;
  }
  EXPECT_NE(run.err.find("runs to -infinity"), std::string::npos);
  EXPECT_NE(good_fit("cox", "Surv(t, e) ~ g + x", {"--table", "drop1"}).out.find("g "),
            std::string::npos);
}

}  // namespace
}  // namespace tcert
