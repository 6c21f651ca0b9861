// What R's formulas give (scripts/golden/calibration.R), through the same functions as the command.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <statistics/calibration/calibration.hpp>
#include <statistics/calibration/out_of_fold.hpp>
#include <string>

namespace tcert::statistics {
namespace {

using nlohmann::json;

constexpr double kRelative = 1e-9;

std::map<std::string, double>& worst() {
  static std::map<std::string, double> table;
  return table;
}

void expect_equal(const std::string& quantity, double actual, const json& golden) {
  const auto expected = golden.get<double>();
  const double error = std::abs(actual - expected) / std::max(std::abs(expected), 1e-3);
  worst()[quantity] = std::max(worst()[quantity], error);
  EXPECT_LE(error, kRelative) << quantity << ": " << actual << " is not " << expected;
}

table::Factor factor_of(const std::vector<std::string>& names) {
  table::Factor factor;
  factor.levels = names;
  std::sort(factor.levels.begin(), factor.levels.end());
  factor.levels.erase(std::unique(factor.levels.begin(), factor.levels.end()), factor.levels.end());
  for (const std::string& name : names) {
    factor.codes.push_back(static_cast<std::uint32_t>(
        std::lower_bound(factor.levels.begin(), factor.levels.end(), name) -
        factor.levels.begin()));
  }
  return factor;
}

void compare(const ModelCalibration& mine, const json& expected) {
  expect_equal("slope", mine.slope.estimate.value(), expected["slope"]);
  expect_equal("slope SE", mine.slope.standard_error.value(), expected["slope_se"]);
  expect_equal("intercept", mine.intercept.estimate.value(), expected["intercept"]);
  expect_equal("intercept SE", mine.intercept.standard_error.value(), expected["intercept_se"]);
  expect_equal("in the large", mine.in_the_large.estimate.value(), expected["in_the_large"]);
  expect_equal(
      "in the large SE", mine.in_the_large.standard_error.value(), expected["in_the_large_se"]);
  const BrierParts& brier = mine.brier.value();
  expect_equal("Brier", brier.score, expected["brier"]);
  expect_equal("reliability", brier.reliability, expected["reliability"]);
  expect_equal("resolution", brier.resolution, expected["resolution"]);
  expect_equal("uncertainty", brier.uncertainty, expected["uncertainty"]);
  expect_equal("within variance", brier.within_variance, expected["within_variance"]);
  expect_equal("within covariance", brier.within_covariance, expected["within_covariance"]);
  expect_equal("E:O", mine.expected_to_observed.value(), expected["expected_to_observed"]);
  const ChiSquareTest& test = mine.hosmer_lemeshow.value();
  expect_equal("Hosmer-Lemeshow", test.statistic, expected["hosmer_lemeshow"]);
  EXPECT_EQ(test.df, expected["hl_df"].get<std::size_t>());
  expect_equal("Hosmer-Lemeshow p", test.p_value, expected["hl_p"]);
  ASSERT_EQ(mine.bins.size(), expected["bins"].size());
  for (std::size_t k = 0; k < mine.bins.size(); ++k) {
    const json& bin = expected["bins"][k];
    EXPECT_EQ(mine.bins[k].trials, bin["n"].get<std::size_t>());
    EXPECT_EQ(mine.bins[k].events, bin["events"].get<std::size_t>());
    expect_equal("bin predicted", mine.bins[k].predicted, bin["predicted"]);
    expect_equal("bin observed", mine.bins[k].observed, bin["observed"]);
    expect_equal("Wilson low", mine.bins[k].wilson.value().low, bin["low"]);
    expect_equal("Wilson high", mine.bins[k].wilson.value().high, bin["high"]);
  }
}

/// Predictions by the folds of the case.
std::vector<double> predicted(const json& expected) {
  const auto y = expected["y"].get<std::vector<double>>();
  const auto x = expected["x"].get<std::vector<double>>();
  const auto z = expected["z"].get<std::vector<double>>();
  const auto n = static_cast<Eigen::Index>(y.size());
  LogisticInput input;
  input.design.resize(n, 3);
  input.design.col(0).setOnes();
  input.design.col(1) = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  input.design.col(2) = Eigen::Map<const Eigen::VectorXd>(z.data(), n);
  input.columns = {"(Intercept)", "x", "z"};
  input.terms = {"x", "z"};
  input.term_of = {0, 1, 2};
  input.successes = Eigen::Map<const Eigen::VectorXd>(y.data(), n);
  Folds folds;
  folds.count = 5;
  folds.of_row = expected["fold"].get<std::vector<std::uint32_t>>();
  const OutOfFold result = out_of_fold_probabilities(input, folds);
  EXPECT_TRUE(result.conditions.empty());
  return result.probability;
}

TEST(CalibrationGolden, EveryCaseEqualsR) {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/calibration.json");
  const json golden = json::parse(file)["cases"];
  for (const auto& [name, expected] : golden.items()) {
    SCOPED_TRACE(name);
    const auto y = expected["y"].get<std::vector<double>>();
    auto p = expected["p"].get<std::vector<double>>();
    if (expected.contains("fold")) {
      const std::vector<double> mine = predicted(expected);
      for (std::size_t i = 0; i < p.size(); ++i) {
        expect_equal("out-of-fold probability", mine[i], expected["p"][i]);
      }
      p = mine;
    }
    const bool clustered = expected.contains("cluster") && expected["cluster"].is_array();
    table::Factor cluster;
    if (clustered) {
      cluster = factor_of(expected["cluster"].get<std::vector<std::string>>());
    }
    compare(calibration(y, p, clustered ? &cluster : nullptr), expected);
  }
  std::printf("calibration golden cases run: %zu\n", golden.size());
  EXPECT_GT(golden.size(), 0U);
  for (const auto& [quantity, error] : worst()) {
    std::printf("  %-24s %.1e\n", quantity.c_str(), error);
  }
}

}  // namespace
}  // namespace tcert::statistics
