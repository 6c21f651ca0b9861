// What a fit says where the data allow little: separation, few clusters, many levels.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/fit_runs.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

class FitLimits : public test_support::FitRuns {
 protected:
  /// The lines of stderr hold `text`, and the exit code is this.
  void expect_said(const ProcessResult& run, int exit_code, const std::string& text) {
    EXPECT_EQ(run.exit_code, exit_code) << to_string(run);
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
  }

  static const json* condition(const json& report, const std::string& name) {
    for (const json& one : report["conditions"]) {
      if (one["name"] == name) {
        return &one;
      }
    }
    return nullptr;
  }
};

/// Every row with g = c has y = 1.
constexpr const char* kSureLevel =
    "y,g,x\n1,a,0.3\n0,b,-1.2\n1,c,0.8\n0,a,-0.4\n1,b,1.1\n1,c,0.2\n1,a,-0.7\n0,b,0.9\n1,c,-1.5\n"
    "0,a,0.4\n0,b,-0.6\n1,c,1.6\n1,a,0.9\n1,b,1.3\n1,c,-0.9\n0,a,-1.1\n1,b,0.2\n1,c,0.6\n1,a,1.4\n"
    "0,b,-0.3\n1,c,0.5\n0,a,0.2\n1,b,0.8\n1,c,-0.1\n";

TEST_F(FitLimits, QuasiSeparationKeepsTheProfilesAndTheOneSidedLimit) {
  work_.write("t.csv", kSureLevel);
  const json glm = document("glm", "y ~ g + x");
  const json& x = glm["coefficients"][3];
  // R: the profile of the limit model, glm on the rows with g != c.
  EXPECT_NEAR(x["profile.low"].get<double>(), 0.318822253, 1e-8);
  EXPECT_NEAR(x["profile.high"].get<double>(), 4.193555709, 1e-8);
  EXPECT_EQ(x["profile.open"], "");
  const json& c = glm["coefficients"][2];
  EXPECT_EQ(c["kind"], "+infinity");
  EXPECT_NEAR(c["profile.low"].get<double>(), 1.583314631, 1e-8);
  EXPECT_TRUE(c["profile.high"].is_null());
  EXPECT_EQ(c["profile.open"], "no upper limit");
  EXPECT_NEAR(c["odds.ratio.profile.low"].get<double>(), std::exp(1.583314631), 1e-7);
  EXPECT_TRUE(c["odds.ratio.profile.high"].is_null());
  EXPECT_TRUE(c["estimate"].is_null());
  const std::string csv = fit("glm", "y ~ g + x", {"--format", "csv"}).out;
  EXPECT_NE(csv.find("\ngc,,,,,,,1.5833146"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",no upper limit,"), std::string::npos) << csv;
  const std::string text = fit("glm", "y ~ g + x").out;
  EXPECT_NE(text.find("1.583"), std::string::npos) << text;
  EXPECT_NE(text.find("no upper limit"), std::string::npos) << text;
}

TEST_F(FitLimits, CompleteSeparationKeepsTheOneSidedLimits) {
  work_.write("t.csv", "y,x\n0,1\n0,2\n0,3\n1,4\n1,5\n1,6\n");
  const json glm = document("glm", "y ~ x", {}, 65);
  EXPECT_NEAR(glm["coefficients"][1]["profile.low"].get<double>(), 0.735298303, 1e-8);
  EXPECT_EQ(glm["coefficients"][1]["profile.open"], "no upper limit");
  EXPECT_EQ(glm["coefficients"][0]["profile.open"], "no lower limit");
}

TEST_F(FitLimits, WithoutAnyEstimateTheExitCodeIs65) {
  work_.write("t.csv",
              "y,x,t,e,d\n0,0,1,1,5\n0,0,2,1,4\n1,2,3,1,3\n1,2,4,1,2\n0,1,5,1,1\n1,1,6,1,0\n");
  expect_said(fit("glm", "y ~ x"), 65, "no coefficient has an estimate");
  expect_said(fit("cox", "Surv(t, e) ~ d"), 65, "no coefficient has an estimate");
  expect_said(fit("glm", "y ~ x", {"--format", "csv"}), 65, "estimate");
  // A table that is there is printed all the same.
  const ProcessResult hazard = fit("cox", "Surv(t, e) ~ d", {"--table", "basehaz"});
  expect_said(hazard, 65, "no coefficient has an estimate");
  EXPECT_NE(hazard.out.find("hazard"), std::string::npos) << hazard.out;
  EXPECT_EQ(hazard.err.find("asked for"), std::string::npos) << hazard.err;
  // One coefficient is enough, and so is a model without any.
  work_.write("t.csv", kSureLevel);
  EXPECT_EQ(fit("glm", "y ~ g + x").exit_code, 0);
  work_.write("t.csv", "t,e\n1,1\n2,0\n3,1\n");
  EXPECT_EQ(fit("cox", "Surv(t, e) ~ 1").exit_code, 0);
}

/// Forty rows on `clusters` days.
std::string days(int clusters) {
  std::string csv = "y,x,z,t,day\n";
  for (int i = 0; i < 40; ++i) {
    const int x = i * 7 % 11;
    const int y = (i * 5 % 13 + x) % 3 == 0 ? 1 : 0;
    csv += std::to_string(y) + ',' + std::to_string(x) + ',' + std::to_string(i * 3 % 7) + ',' +
           std::to_string(10 + i * 17 % 41) + ",d" + std::to_string(i % clusters) + '\n';
  }
  return csv;
}

TEST_F(FitLimits, FewClustersAreWarnedOfAndReadByT) {
  work_.write("t.csv", days(2));
  const std::vector<std::array<std::string, 3>> fits{{"glm", "y ~ x + z", "odds.ratio"},
                                                     {"cox", "Surv(t, y) ~ x + z", "hazard.ratio"}};
  for (const auto& [kind, formula, ratio] : fits) {
    SCOPED_TRACE(kind);
    const json two = document(kind, formula, {"--cluster", "day", "--inference", "cr1"});
    const json& row = two["coefficients"].back();
    const double z = row["statistic"].get<double>();
    const double se = row[kind == "cox" ? "robust.se" : "std.error"].get<double>();
    const double estimate = row["estimate"].get<double>();
    // R's numbers stay: by the normal distribution.
    EXPECT_NEAR(row["p.value"].get<double>(), std::erfc(std::abs(z) / std::numbers::sqrt2), 1e-12);
    // t with one degree of freedom is Cauchy's distribution; R: qt(0.975, 1) = 12.7062047361747.
    const double corrected = se * std::numbers::sqrt2;  // G / (G - 1) = 2.
    EXPECT_NEAR(row["t.std.error"].get<double>(), corrected, 1e-9);
    EXPECT_EQ(row["t.df"], 1.0);
    EXPECT_NEAR(row["t.p.value"].get<double>(),
                1.0 - 2.0 / std::numbers::pi * std::atan(std::abs(z) / std::numbers::sqrt2),
                1e-9);
    EXPECT_NEAR(row["t.low"].get<double>(), estimate - 12.7062047361747 * corrected, 1e-8);
    EXPECT_NEAR(row["t.high"].get<double>(), estimate + 12.7062047361747 * corrected, 1e-8);
    EXPECT_NEAR(row[ratio + ".low"].get<double>(), std::exp(row["conf.low"].get<double>()), 1e-12);
    EXPECT_NEAR(
        row[ratio + ".t.high"].get<double>() / std::exp(row["t.high"].get<double>()), 1.0, 1e-12);
    const json* const few = condition(two, "few_clusters");
    ASSERT_NE(few, nullptr);
    EXPECT_EQ((*few)["severity"], "warning");
    EXPECT_NE((*few)["message"].get<std::string>().find("no full rank"), std::string::npos);
  }
  work_.write("t.csv", days(12));
  const json twelve = document("glm", "y ~ x + z", {"--cluster", "day"});
  EXPECT_EQ((*condition(twelve, "few_clusters"))["severity"], "note");
  EXPECT_TRUE(twelve["coefficients"][1]["t.p.value"].is_number());
  work_.write("t.csv", days(5));
  const json five = document("glm", "y ~ x + z", {"--cluster", "day"});
  EXPECT_EQ((*condition(five, "few_clusters"))["severity"], "warning");
  EXPECT_FALSE(document("glm", "y ~ x + z")["coefficients"][1].contains("t.p.value"));
  EXPECT_FALSE(document("glm", "y ~ x + z", {"--robust"})["coefficients"][1].contains("t.p.value"));
}

/// The default is the jackknife, of which the table of left-out clusters is what it is made of.
TEST_F(FitLimits, InferenceIsTheJackknifeOfTheClustersLeftOut) {
  work_.write("t.csv", days(8));
  for (const auto& [kind, formula] : std::vector<std::pair<std::string, std::string>>{
           {"glm", "y ~ x + z"}, {"cox", "Surv(t, y) ~ x + z"}}) {
    SCOPED_TRACE(kind);
    const json run = document(kind, formula, {"--cluster", "day", "--left-out"});
    const json& row = run["coefficients"].back();
    double squares = 0.0;
    int clusters = 0;
    for (const json& left : run["left_out"]) {
      if (left["term"] == row["term"]) {
        const double change = left["estimate"].get<double>() - row["estimate"].get<double>();
        EXPECT_NEAR(left["change"].get<double>(), change, 1e-12);
        EXPECT_EQ(left["rows"], 5);
        squares += change * change;
        ++clusters;
      }
    }
    EXPECT_EQ(clusters, 8);
    EXPECT_NEAR(row["t.std.error"].get<double>(), std::sqrt(7.0 / 8.0 * squares), 1e-9);
    EXPECT_EQ(row["t.df"], 7.0);
    const json cr2 = document(kind, formula, {"--cluster", "day", "--inference", "cr2"});
    EXPECT_LE(cr2["coefficients"].back()["t.df"].get<double>(), 7.0);
    const json wild = document(kind, formula, {"--cluster", "day", "--inference", "wild"});
    const json& by_wild = wild["coefficients"].back();
    EXPECT_TRUE(by_wild["t.df"].is_null());
    EXPECT_GT(by_wild["t.p.value"].get<double>(), 0.0);
    EXPECT_LT(by_wild["t.low"].get<double>(), by_wild["estimate"].get<double>());
    EXPECT_GT(by_wild["t.high"].get<double>(), by_wild["estimate"].get<double>());
  }
  expect_said(fit("glm", "y ~ x", {"--inference", "cr2"}), 2, "needs clusters");
  expect_said(fit("glm", "y ~ x", {"--cluster", "day", "--inference", "hc3"}), 2, "jackknife, cr1");
}

TEST_F(FitLimits, ASingleClusterHasNoT) {
  work_.write("t.csv", days(1));
  for (const char* kind : {"glm", "cox"}) {
    const json one = document(
        kind, kind == std::string("glm") ? "y ~ x" : "Surv(t, y) ~ x", {"--cluster", "day"});
    EXPECT_TRUE(one["coefficients"].back()["t.p.value"].is_null()) << kind;
    EXPECT_TRUE(one["coefficients"].back()["t.low"].is_null()) << kind;
    EXPECT_NE(condition(one, "one_cluster"), nullptr) << kind;
  }
}

TEST_F(FitLimits, AreasAndConcordancesHaveTheirIntervalsByT) {
  work_.write("t.csv", days(4));
  const double t = 3.18244630528371;  // R: qt(0.975, 3)
  for (const auto& [kind, formula] : std::vector<std::pair<std::string, std::string>>{
           {"roc", "y ~ x + z"}, {"concordance", "Surv(t, y) ~ x + z"}}) {
    const json run = document(kind, formula, {"--cluster", "day"});
    const json& row = run[kind == "roc" ? "auc" : "concordance"][0];
    const double half = t * row["std.error"].get<double>();
    const double value = row["estimate"].get<double>();
    EXPECT_NEAR(row["t.low"].get<double>(), std::max(0.0, value - half), 1e-9) << kind;
    EXPECT_NEAR(row["t.high"].get<double>(), std::min(1.0, value + half), 1e-9) << kind;
    EXPECT_TRUE(run["differences"][0]["t.p.value"].is_number()) << kind;
    EXPECT_GT(run["differences"][0]["t.p.value"].get<double>(),
              run["differences"][0]["p.value"].get<double>())
        << kind;
    EXPECT_EQ((*condition(run, "few_clusters"))["severity"], "warning") << kind;
  }
}

TEST_F(FitLimits, ProfilesOfManyLevelsAreLeftOutAndSaid) {
  std::string csv = "y,x,w\n";
  for (int i = 0; i < 2400; ++i) {
    csv += std::to_string((i * 7 + i / 11) % 5 < 2 ? 1 : 0) + ',' + std::to_string(i * 31 % 97) +
           ",w" + std::to_string(i % 120) + '\n';
  }
  work_.write("t.csv", csv);
  const ProcessResult many = fit("glm", "y ~ x + w", {"--format", "json"});
  expect_said(many, 0, "ask for them with --profile");
  const json report = json::parse(many.out);
  EXPECT_EQ((*condition(report, "no_profile"))["severity"], "note");
  EXPECT_TRUE(report["coefficients"][1]["profile.low"].is_null());
  EXPECT_TRUE(report["coefficients"][1]["conf.low"].is_number());
  EXPECT_EQ(
      condition(json::parse(fit("glm", "y ~ x + w", {"--no-profile", "--format", "json"}).out),
                "no_profile"),
      nullptr);
  EXPECT_EQ(fit("glm", "y ~ x", {"--profile", "--no-profile"}).exit_code, 2);
  EXPECT_EQ(fit("glm", "y ~ x", {"--profile", "--robust"}).exit_code, 2);
  EXPECT_TRUE(
      document("glm", "y ~ x", {"--profile"})["coefficients"][1]["profile.low"].is_number());
}

/// Failures below 0.5, successes from there; one failure lies `overlap` above the first success.
std::string overlapping_by(double overlap) {
  std::string csv = "y,x,day\n";
  for (int i = 0; i < 40; ++i) {
    const double x = i == 19 ? 0.5 + overlap : 0.025 * i;
    csv += std::to_string(i < 20 ? 0 : 1) + ',' + std::to_string(x) + ",d" + std::to_string(i % 4) +
           '\n';
  }
  return csv;
}

TEST_F(FitLimits, NearSeparationIsNaInEveryRatio) {
  work_.write("t.csv", overlapping_by(1e-5));
  const json glm = document("glm", "y ~ x", {}, 65);
  for (const json& row : glm["coefficients"]) {
    for (const char* key :
         {"estimate", "std.error", "conf.high", "odds.ratio", "odds.ratio.high"}) {
      EXPECT_TRUE(row[key].is_null()) << key << row;
    }
    EXPECT_EQ(row["kind"], "near-separation");
  }
  ASSERT_NE(condition(glm, "near_separation"), nullptr);
  EXPECT_TRUE(glm["coefficients"][1]["profile.low"].is_number());
  EXPECT_EQ(document("glm", "y ~ x", {"--firth"})["conditions"].size(), 0U);
  // By a hair that is thinner than this the mixed model does not converge.
  work_.write("t.csv", overlapping_by(1e-3));
  const json mixed = document("glmm", "y ~ x + (1 | day)", {}, 65);
  EXPECT_EQ(mixed["coefficients"][1]["kind"], "near-separation") << mixed["coefficients"];
  ASSERT_NE(condition(mixed, "near_separation"), nullptr) << mixed["conditions"];
  EXPECT_TRUE(mixed["coefficients"][1]["odds.ratio"].is_null()) << mixed["coefficients"];
}

}  // namespace
}  // namespace tcert
