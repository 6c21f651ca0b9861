// What R says of small tables, kept in tests/golden by scripts/golden/fit.R and mixed.R, against
// what the command prints.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using nlohmann::json;

constexpr double kRelative = 1e-8;

void expect_fields(const json& actual, const json& expected, double relative) {
  for (const auto& [key, value] : expected.items()) {
    ASSERT_TRUE(actual.contains(key)) << key;
    ASSERT_TRUE(actual[key].is_number()) << key << ": " << actual[key];
    const double number = value.get<double>();
    EXPECT_NEAR(actual[key].get<double>(), number, relative * std::max(1e-6, std::abs(number)))
        << key;
  }
}

/// Every case of a file, to its own tolerance where R's optimiser leaves one.
void expect_cases(const std::string& name) {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/" + name);
  const json golden = json::parse(file);
  test_support::Workdir work(TCERT_BINARY);
  work.write("t.csv", golden["csv"].get<std::string>() + "\n");
  for (const json& one : golden["cases"]) {
    std::vector<std::string> arguments{"fit"};
    const auto given = one["arguments"].get<std::vector<std::string>>();
    arguments.insert(arguments.end(), given.begin(), given.end());
    arguments.insert(arguments.end(), {"--data", "t.csv", "--format", "json"});
    const auto run = work.run(arguments);
    SCOPED_TRACE(run.command);
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
    const json document = json::parse(run.out);
    const double relative = one.value("relative", kRelative);
    for (const auto& [table, expected] : one["expected"].items()) {
      SCOPED_TRACE(table);
      if (expected.is_object()) {
        expect_fields(document[table], expected, relative);
        continue;
      }
      ASSERT_EQ(document[table].size(), expected.size());
      for (std::size_t row = 0; row < expected.size(); ++row) {
        expect_fields(document[table][row], expected[row], relative);
      }
    }
  }
  std::printf("fit golden cases run: %zu\n", golden["cases"].size());
}

TEST(FitGolden, EveryCaseEqualsR) { expect_cases("fit.json"); }

TEST(FitGolden, MixedModelsAndContrastsEqualR) { expect_cases("mixed.json"); }

}  // namespace
}  // namespace tcert
