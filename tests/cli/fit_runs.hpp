#pragma once
/// \file
/// `tcert fit` of the rows in t.csv.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert::test_support {

class FitRuns : public ::testing::Test {
 protected:
  ProcessResult fit(const std::string& kind,
                    const std::string& formula,
                    std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"fit", kind, "--data", "t.csv", "--formula", formula};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return work_.run(arguments);
  }

  /// What it prints with --format json.
  nlohmann::json document(const std::string& kind,
                          const std::string& formula,
                          std::vector<std::string> more = {},
                          int exit_code = 0) {
    more.insert(more.end(), {"--format", "json"});
    const ProcessResult run = fit(kind, formula, more);
    EXPECT_EQ(run.exit_code, exit_code) << to_string(run);
    return nlohmann::json::parse(run.out);
  }

  Workdir work_{TCERT_BINARY};
};

}  // namespace tcert::test_support
