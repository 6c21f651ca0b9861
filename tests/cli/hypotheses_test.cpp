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
    arguments.insert(arguments.end(), {"--features", "t.csv", "--replicates", "200"});
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
}

}  // namespace
}  // namespace tcert
