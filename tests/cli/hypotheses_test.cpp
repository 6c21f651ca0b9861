#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

/// 240 trials on 12 days in two groups, made by a formula: no chance.
std::string trials_csv() {
  std::string csv = "day,lighting,algorithm,success,time_s,tc_early\n";
  for (int i = 0; i < 240; ++i) {
    const double tc = std::sin(1.7 * i) + 0.3 * std::cos(0.9 * i);
    const bool success = tc + std::sin(5.3 * i) > -0.6;
    csv += "d" + std::to_string(i % 12) + "," + (i % 5 < 2 ? "Dark" : "Indoor") + "," +
           (i % 3 == 0 ? "A" : "B") + "," + (success ? "1" : "0") + "," +
           std::to_string(40.0 - 5.0 * tc + 8.0 * std::sin(2.9 * i)) + "," + std::to_string(tc) +
           "\n";
  }
  return csv;
}

class HypothesesCommand : public ::testing::Test {
 protected:
  void SetUp() override { work_.write("t.csv", trials_csv()); }

  ProcessResult run(std::vector<std::string> more) {
    std::vector<std::string> arguments{"hypotheses"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(),
                     {"--features", "t.csv", "--predictor", "tc_early", "--replicates", "200"});
    return work_.run(arguments);
  }

  Workdir work_{TCERT_BINARY};
};

TEST_F(HypothesesCommand, H2HasItsTablesInEveryFormat) {
  const ProcessResult document = run({"h2", "--permutations", "100", "--format", "json"});
  ASSERT_EQ(document.exit_code, 0) << to_string(document);
  const json h2 = json::parse(document.out);
  EXPECT_EQ(h2["model"], "h2");
  EXPECT_EQ(h2["h2"].size(), 2U);
  EXPECT_EQ(h2["h2"][0]["group"], "Dark");
  EXPECT_EQ(h2["h2_equality"].size(), 2U);
  EXPECT_EQ(h2["h2_equality"][0]["margin"], 0.05);
  EXPECT_EQ(h2["h2_pairs"].size(), 2U);
  EXPECT_EQ(h2["h2_interaction"].size(), 4U);
  EXPECT_EQ(h2["h2_covariance"].size(), 6U);
  for (const char* format : {"text", "md", "tex", "csv", "jsonl"}) {
    const ProcessResult text = run({"h2", "--permutations", "100", "--format", format});
    EXPECT_EQ(text.exit_code, 0) << to_string(text);
    EXPECT_NE(text.out.find("Indoor"), std::string::npos) << format;
  }
}

TEST_F(HypothesesCommand, ThreadsDoNotChangeAByte) {
  std::string first;
  for (const char* threads : {"1", "2"}) {
    const ProcessResult one = run({"h2", "--threads", threads, "--format", "json"});
    first = first.empty() ? one.out : first;
    EXPECT_EQ(one.out, first);
  }
}

TEST_F(HypothesesCommand, H1HasWhatIsWithinStrataBesideThePooledNumbers) {
  const ProcessResult document = run({"h1", "--format", "json"});
  ASSERT_EQ(document.exit_code, 0) << to_string(document);
  const json h1 = json::parse(document.out);
  EXPECT_EQ(h1["summary"]["within"], "algorithm x lighting");
  EXPECT_EQ(h1["summary"]["interval"], "expanded");
  ASSERT_EQ(h1["h1_within"].size(), 1U);
  EXPECT_EQ(h1["h1_within"][0]["auc"], h1["h1"][0]["auc"]);
  EXPECT_TRUE(h1["h1_within"][0]["auc_within_low"].is_number());
  EXPECT_TRUE(h1["h1_time_within"][0]["c_within_high"].is_number());
  const json& all = h1["h1_intervals"][0];
  EXPECT_EQ(all["expanded_low"], h1["h1"][0]["auc_low"]);
  EXPECT_NE(all["bca_low"], all["expanded_low"]);
  const ProcessResult text = run({"h1"});
  EXPECT_NE(text.out.find("AUC within [95 % expanded]"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("H1, success, within algorithm x lighting"), std::string::npos);
}

TEST_F(HypothesesCommand, TheIntervalIsNamedInTheHeading) {
  const ProcessResult bca = run({"h1", "--interval", "bca", "--format", "json"});
  const json h1 = json::parse(bca.out);
  EXPECT_EQ(h1["h1"][0]["auc_low"], h1["h1_intervals"][0]["bca_low"]);
  EXPECT_NE(run({"h1", "--interval", "bca"}).out.find("AUC [95 % BCa]"), std::string::npos);
  EXPECT_NE(run({"h2", "--interval", "percentile"}).out.find("AUC [95 % percentile]"),
            std::string::npos);
  const ProcessResult wrong = run({"h1", "--interval", "normal"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("expected expanded, percentile or bca"), std::string::npos) << wrong.err;
}

TEST_F(HypothesesCommand, StrataWithinAreThoseThatAreAskedFor) {
  const auto within = [&](const std::vector<std::string>& more) -> std::string {
    std::vector<std::string> call{"h1", "--format", "json"};
    call.insert(call.end(), more.begin(), more.end());
    return json::parse(run(call).out)["summary"]["within"].dump();
  };
  EXPECT_EQ(within({"--within", "lighting"}), "\"lighting\"");
  EXPECT_EQ(within({"--strata", "lighting"}), "\"lighting\"") << "once";
  EXPECT_EQ(within({"--within", ""}), "\"\"");
  const ProcessResult wrong = run({"h1", "--within", "lightning"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("did you mean 'lighting'?"), std::string::npos) << wrong.err;
}

TEST_F(HypothesesCommand, ALandmarkWithoutTimesIsRefused) {
  std::string csv = trials_csv();
  const auto at = csv.find("time_s");
  work_.write("t.csv", csv.replace(at, 6, "energy"));
  for (const char* const hypothesis : {"h1", "h2"}) {
    const ProcessResult refused = run({hypothesis, "--landmark", "15"});
    EXPECT_EQ(refused.exit_code, 2) << to_string(refused);
    EXPECT_NE(refused.err.find("--landmark: t.csv has no times"), std::string::npos) << refused.err;
  }
}

TEST_F(HypothesesCommand, ALandmarkSaysWhatIsNotOfItsWindow) {
  const ProcessResult found = run({"h1", "--landmark", "15"});
  EXPECT_EQ(found.out.find("Landmark panel: the time window alone"), std::string::npos)
      << found.out;
  EXPECT_NE(found.out.find("Landmark panel: 'tc_early' as in the other panel"), std::string::npos)
      << found.out;
}

TEST_F(HypothesesCommand, APanelWithoutTrialsHasNoStrata) {
  for (const char* const hypothesis : {"h1", "h2"}) {
    const ProcessResult found = run({hypothesis, "--landmark", "80"});  // all have ended by then
    EXPECT_NE(found.out.find("pairs of trials of the same algorithm x lighting alone"),
              std::string::npos)
        << to_string(found);
    EXPECT_EQ(found.out.find("of the same  alone"), std::string::npos) << found.out;
  }
}

TEST_F(HypothesesCommand, FewClustersHaveNoIntervalAndNoP) {
  std::string csv = trials_csv();
  for (const char* const day : {"d3,", "d4,", "d5,", "d6,", "d7,", "d8,", "d9,"}) {
    for (std::size_t at = csv.find(day); at != std::string::npos; at = csv.find(day)) {
      csv.replace(at, 3, "d0,");
    }
  }
  work_.write("t.csv", csv);
  const ProcessResult found = run({"h1", "--format", "json"});
  EXPECT_EQ(found.exit_code, 0) << to_string(found);
  EXPECT_NE(
      found.err.find(
          "p-values and intervals are withheld: table panel: 5 clusters of 'day', fewer than 6"),
      std::string::npos)
      << found.err;
  const json h1 = json::parse(found.out);
  for (const auto& [name, rows] : h1.items()) {
    if (!rows.is_array() || name == "conditions") {
      continue;
    }
    for (const json& row : rows) {
      for (const auto& [column, cell] : row.items()) {
        const bool inference = column.ends_with("_low") || column.ends_with("_high") ||
                               column == "p" || column.ends_with("_p") ||
                               column.ends_with("std_error") || column == "p_holm" ||
                               column.starts_with("conf.");
        EXPECT_TRUE(!inference || cell.is_null()) << name << " " << column << " " << cell;
      }
    }
  }
  EXPECT_TRUE(h1["h1"][0]["auc"].is_number());
  EXPECT_TRUE(h1["h1_time"][0]["hr_censored"].is_number());
  ASSERT_FALSE(h1["h1_calibration"].empty());
  EXPECT_TRUE(h1["h1_calibration"][0]["observed"].is_number());
}

TEST_F(HypothesesCommand, SaysWhatIsWrongWithTheCall) {
  const auto expect_usage = [&](const std::vector<std::string>& call, const std::string& text) {
    const ProcessResult failed = run(call);
    EXPECT_EQ(failed.exit_code, 2) << to_string(failed);
    EXPECT_NE(failed.err.find(text), std::string::npos) << failed.err;
  };
  expect_usage({"h4"}, "unknown hypothesis 'h4', expected h1, h2 or h3");
  expect_usage({"h2", "--group", "lightning"}, "did you mean 'lighting'?");
  expect_usage({"h2", "--margin", "0"}, "--margin");
  expect_usage({"h2", "--baselines", "dwell"}, "--baselines");
  const ProcessResult same =
      work_.run({"hypotheses", "h3", "--replays", "t.csv", "--gated", "A", "--lead", "A"});
  EXPECT_EQ(same.exit_code, 2) << to_string(same);
  EXPECT_NE(same.err.find("found 'A' for both"), std::string::npos) << same.err;
}

TEST_F(HypothesesCommand, WithoutGroupsThereIsNoH2) {
  std::string csv = trials_csv();
  for (const std::string name : {",Dark,", ",Indoor,"}) {
    for (std::size_t at = csv.find(name); at != std::string::npos; at = csv.find(name, at)) {
      csv.replace(at, name.size(), ",,");
    }
  }
  work_.write("t.csv", csv);
  const ProcessResult none = run({"h2"});
  EXPECT_EQ(none.exit_code, 2) << to_string(none);
  EXPECT_NE(none.err.find("no trial has a value of 'lighting'"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace tcert
