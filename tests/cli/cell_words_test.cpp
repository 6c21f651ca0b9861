// That check, fit, hypotheses and certify read a cell alike, and what they say of one they refuse.

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

/// Ninety trials on fifteen days; `x` of every `share`th is `word`.
std::string trials(const std::string& one,
                   const std::string& zero,
                   const std::string& word = "",
                   int share = 1000) {
  std::string csv = "y,t,x,day,id\n";
  for (int i = 0; i < 90; ++i) {
    const int x = (i * 37) % 90;
    const bool success = (i * 53) % 97 < 30 + x / 2;
    csv += (success ? one : zero) + ',' + std::to_string(10 + (i * 29) % 71) + ',' +
           (i % share == 2 ? word : "0." + std::to_string(100 + x)) + ",d" +
           std::to_string(i % 15) + ',' + std::to_string(i) + '\n';
  }
  return csv;
}

class CellWords : public test_support::FitRuns {
 protected:
  ProcessResult h1(std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"hypotheses",
                                       "h1",
                                       "--features",
                                       "t.csv",
                                       "--predictor",
                                       "x",
                                       "--time",
                                       "t",
                                       "--strata",
                                       "",
                                       "--replicates",
                                       "100",
                                       "--format",
                                       "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return work_.run(arguments);
  }
};

TEST_F(CellWords, WhatPrintfWritesForNotANumberIsAMissingCell) {
  for (const char* word : {"-nan", "nan(ind)", "NaN", "NA", ""}) {
    work_.write("t.csv", trials("1", "0", word, 30));
    const ProcessResult run = fit("glm", "y ~ x", {"--format", "json"});
    ASSERT_EQ(run.exit_code, 0) << word << to_string(run);
    const json glm = json::parse(run.out);
    EXPECT_EQ(glm["coefficients"].size(), 2U) << word;
    EXPECT_EQ(glm["n"], 87) << word;
    EXPECT_EQ(glm["n_dropped"], 3) << word;
  }
}

TEST_F(CellWords, InfinitiesAreNumbers) {
  for (const char* word : {"+inf", "infinity", "Inf", "1e999"}) {
    work_.write("t.csv", trials("1", "0", word, 30));
    const ProcessResult run = fit("glm", "y ~ x");
    EXPECT_EQ(run.exit_code, 65) << word << to_string(run);
    EXPECT_NE(run.err.find("found Inf in row 3 (line 4) (and 2 more)"), std::string::npos)
        << word << to_string(run);
    EXPECT_EQ(fit("roc", "y ~ x").exit_code, 0) << word;
  }
}

TEST_F(CellWords, AWordForAMissingCellIsRefusedWithItsPlace) {
  for (const char* word : {"N/A", "null", "None", "na", "-"}) {
    for (const int share : {45, 4, 3}) {
      work_.write("t.csv", trials("1", "0", word, share));
      const std::string found = "'" + std::string(word) + "' in row 3 of column x of t.csv (line 4";
      for (const char* kind : {"glm", "roc"}) {
        const ProcessResult run = fit(kind, "y ~ x");
        EXPECT_EQ(run.exit_code, 2) << word << share << to_string(run);
        EXPECT_NE(run.err.find(found), std::string::npos) << to_string(run);
        EXPECT_NE(run.err.find("a missing cell is empty, NA or nan"), std::string::npos);
      }
      const ProcessResult hypothesis = h1({"--success", "y"});
      EXPECT_EQ(hypothesis.exit_code, 2) << to_string(hypothesis);
      EXPECT_NE(hypothesis.err.find(found), std::string::npos) << to_string(hypothesis);
      const ProcessResult check = work_.run({"check", "t.csv"});
      EXPECT_EQ(check.exit_code, 1) << to_string(check);
      EXPECT_NE(check.out.find("a missing cell is empty, NA or nan"), std::string::npos)
          << check.out;
    }
  }
}

TEST_F(CellWords, AnOutcomeIsTheSameInAllItsWords) {
  work_.write("t.csv", trials("1", "0"));
  const json numbers = json::parse(h1({"--success", "y"}).out);
  const json glm = json::parse(fit("glm", "y ~ x", {"--format", "json"}).out);
  const json cox = json::parse(fit("cox", "Surv(t, y) ~ x", {"--format", "json"}).out);
  for (const auto& [one, zero] : {std::pair{"True", "False"},
                                  {"TRUE", "FALSE"},
                                  {"s", "f"},
                                  {"ok", "fail"},
                                  {"Success", "failure"}}) {
    work_.write("t.csv", trials(one, zero));
    const ProcessResult run = h1({"--success", "y"});
    ASSERT_EQ(run.exit_code, 0) << one << to_string(run);
    EXPECT_EQ(json::parse(run.out)["h1"], numbers["h1"]) << one;
    EXPECT_EQ(json::parse(fit("glm", "y ~ x", {"--format", "json"}).out)["coefficients"],
              glm["coefficients"])
        << one;
    EXPECT_EQ(json::parse(fit("cox", "Surv(t, y) ~ x", {"--format", "json"}).out)["coefficients"],
              cox["coefficients"])
        << one;
  }
  work_.write("t.csv", trials("True", "False"));
  EXPECT_EQ(
      json::parse(fit("cox", "Surv(t, y == TRUE) ~ x", {"--format", "json"}).out)["coefficients"],
      cox["coefficients"]);
  // Words of one's own are named.
  work_.write("t.csv", trials("reached", "cycle_cap"));
  const ProcessResult unnamed = h1({"--success", "y"});
  EXPECT_EQ(unnamed.exit_code, 2);
  EXPECT_NE(unnamed.err.find("--success 'y=WORD[,WORD]' names the words that count as success"),
            std::string::npos)
      << to_string(unnamed);
  const ProcessResult named = h1({"--success", "y=reached"});
  ASSERT_EQ(named.exit_code, 0) << to_string(named);
  EXPECT_EQ(json::parse(named.out)["h1"], numbers["h1"]);
  EXPECT_NE(named.err.find("'reached' counts as 1, 'cycle_cap' as 0"), std::string::npos);
  // It is in the report too, where --quiet says nothing.
  const json quiet = json::parse(h1({"--success", "y=reached", "--quiet"}).out);
  EXPECT_EQ(quiet["event_level"], "reached");
  EXPECT_EQ(quiet["reference_level"], "cycle_cap");
  const auto& conditions = quiet["conditions"];
  EXPECT_TRUE(std::any_of(conditions.begin(), conditions.end(), [](const json& one) {
    return one["name"] == "text_outcome" && one["column"] == "y" && one["severity"] == "note";
  })) << conditions;
  EXPECT_FALSE(numbers.contains("event_level"));
  EXPECT_EQ(h1({"--success", "y=raeched"}).exit_code, 2);
  EXPECT_EQ(h1({"--success", "=reached"}).exit_code, 2);
}

TEST_F(CellWords, AReferenceOfATruthValueTakesAnySpelling) {
  work_.write("t.csv", trials("True", "False"));
  for (const char* word : {"y=FALSE", "y=False", "y=f"}) {
    const ProcessResult run = fit("glm", "x > 0.14 ~ y", {"--ref", word, "--format", "json"});
    if (std::string(word) == "y=f") {
      EXPECT_NE(run.err.find("has no level 'f', only FALSE, TRUE"), std::string::npos)
          << to_string(run);
    } else {
      ASSERT_EQ(run.exit_code, 0) << to_string(run);
      EXPECT_EQ(json::parse(run.out)["coefficients"][1]["term"], "yTRUE");
    }
  }
  const ProcessResult run = fit("glm", "x > 0.14 ~ y", {"--ref", "y=True", "--format", "json"});
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_EQ(json::parse(run.out)["coefficients"][1]["term"], "yFALSE");
}

TEST_F(CellWords, NamesThatDifferInCaseAreTwoColumnsOfATable) {
  work_.write("t.csv", "Success,success,x\n1,0,1\n0,1,2\n1,1,3\n0,0,4\n1,1,5\n0,1,6\n");
  const ProcessResult run = fit("glm", "success ~ Success", {"--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
}

TEST_F(CellWords, AWordForAMissingCellIsNoCause) {
  const auto table = [](const std::string& word) {
    return "t,e,why\n1,1,1\n2,1,2\n3,1," + word + "\n4,1,1\n5,0,1\n6,1,2\n";
  };
  work_.write("t.csv", table("N/A"));
  const ProcessResult word = fit("km", "Surv(t, e) ~ 1", {"--cause", "why"});
  EXPECT_EQ(word.exit_code, 2) << to_string(word);
  EXPECT_NE(word.err.find("'N/A' in row 3 of column why of t.csv (line 4"), std::string::npos)
      << to_string(word);
  work_.write("t.csv", table("NA"));
  const ProcessResult missing = fit("km", "Surv(t, e) ~ 1", {"--cause", "why"});
  EXPECT_EQ(missing.exit_code, 0) << to_string(missing);
  EXPECT_NE(missing.out.find("events without a cause"), std::string::npos) << to_string(missing);
}

TEST_F(CellWords, ProductsWithStrataAreForCox) {
  work_.write("t.csv", trials("1", "0"));
  const ProcessResult cox = fit("cox", "Surv(t, y) ~ x * strata(day)", {"--format", "json"});
  // So few trials a day have no estimate, but the formula is one of cox.
  ASSERT_EQ(cox.exit_code, 65) << to_string(cox);
  EXPECT_EQ(json::parse(cox.out)["coefficients"][1]["term"], "x:strata(day)d1");
  EXPECT_EQ(fit("km", "Surv(t, y) ~ x * strata(day)").exit_code, 2);
  EXPECT_EQ(fit("glm", "y ~ x * strata(day)").exit_code, 2);
  for (const char* formula : {"Surv(t, y) ~ x * strata(day)", "Surv(t, y) ~ x:strata(day)"}) {
    const ProcessResult concordance = fit("concordance", formula);
    EXPECT_EQ(concordance.exit_code, 2) << to_string(concordance);
    EXPECT_NE(concordance.err.find("a product with strata() is for cox"), std::string::npos)
        << to_string(concordance);
  }
}

}  // namespace
}  // namespace tcert
