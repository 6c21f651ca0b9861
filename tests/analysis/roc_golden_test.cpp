// Every AUC and paired-test case of the pROC goldens, from the data sets they were made of.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/roc.hpp"
#include "datasets/csv.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kRelative = 1e-10;

/// One numeric column of a CSV file; NA is NaN. Empty if the file has no such column.
std::vector<double> read_column(const fs::path& path, const std::string& name) {
  const TextTableResult file = read_text_table(path, {name});
  std::vector<double> values;
  if (!file.table) {
    return values;
  }
  const std::size_t column = file.table->find(name).value();
  for (std::size_t row = 0; row < file.table->rows(); ++row) {
    const std::string& cell = file.table->at(row, column);
    values.push_back(cell == "NA" ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell));
  }
  return values;
}

double number(const json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  if (value == "Inf") {
    return std::numeric_limits<double>::infinity();
  }
  if (value == "-Inf") {
    return -std::numeric_limits<double>::infinity();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void expect_equal(double actual, const json& expected) {
  const double value = number(expected);
  if (std::isinf(value)) {
    EXPECT_EQ(actual, value);
  } else {
    EXPECT_NEAR(actual, value, value == 0.0 ? 1e-15 : kRelative * std::abs(value));
  }
}

class RocGolden : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test_support::shared_data() / "stats";
    std::ifstream file(folder_ / "golden" / "roc.json");
    if (!file) {
      GTEST_SKIP() << "no golden values: " << (folder_ / "golden" / "roc.json");
    }
    golden_ = json::parse(file);
  }

  [[nodiscard]] std::vector<double> column(const json& test_case, const char* key) const {
    const std::vector<double> values = read_column(
        folder_ / "data" / test_case["data"].get<std::string>(), test_case[key].get<std::string>());
    EXPECT_FALSE(values.empty()) << test_case["data"] << ": no column " << test_case[key];
    return values;
  }

  fs::path folder_;
  json golden_;
};

TEST_F(RocGolden, AucVarianceIntervalAndCurveEqualPRoc) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["auc"].items()) {
    SCOPED_TRACE(name);
    const std::vector<double> score = column(expected, "x");
    const std::vector<double> success = column(expected, "y");
    const AucEstimate estimate = auc(score, success, HigherMeans::success);
    ASSERT_TRUE(estimate.auc.has_value());
    EXPECT_EQ(estimate.successes, expected["n_case"].get<std::size_t>());
    EXPECT_EQ(estimate.failures, expected["n_control"].get<std::size_t>());
    expect_equal(*estimate.auc, expected["auc_direction_lt"]);
    expect_equal(estimate.variance.value(), expected["delong_var"]);
    for (const auto& [level, key] :
         {std::pair{0.90, "ci_delong_90"}, {0.95, "ci_delong_95"}, {0.99, "ci_delong_99"}}) {
      SCOPED_TRACE(key);
      const AucEstimate at_level = auc(score, success, HigherMeans::success, level);
      expect_equal(at_level.interval->low, expected[key][0]);
      expect_equal(at_level.interval->high, expected[key][2]);
    }
    if (expected["auto_direction"] == ">") {
      expect_equal(auc(score, success, HigherMeans::failure).auc.value(), expected["auto_auc"]);
    }

    const std::vector<RocPoint> points = roc_points(score, success, HigherMeans::success);
    const json& curve = expected["curve_points"];
    ASSERT_EQ(points.size(), curve["n_thresholds"].get<std::size_t>());
    const std::size_t shown = curve["threshold"].size();
    for (std::size_t k = 0; k < shown; ++k) {
      // The golden file shows points 1 + (n - 1) k / (shown - 1), rounded half to even as R does.
      const auto at = static_cast<std::size_t>(std::nearbyint(
          static_cast<double>((points.size() - 1) * k) / static_cast<double>(shown - 1)));
      const auto nearest = [&](std::size_t i) {
        return i < points.size() && points[i].threshold == number(curve["threshold"][k]);
      };
      const RocPoint& point = points[nearest(at) ? at : (nearest(at + 1) ? at + 1 : at)];
      expect_equal(point.threshold, curve["threshold"][k]);
      expect_equal(point.sensitivity, curve["sens"][k]);
      expect_equal(point.specificity, curve["spec"][k]);
    }
    ++cases;
  }
  std::printf("pROC golden cases run: %zu AUC\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(RocGolden, PairedTestEqualsPRoc) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["paired_tests"].items()) {
    SCOPED_TRACE(name);
    const std::vector<double> first = column(expected, "x1");
    const std::vector<double> second = column(expected, "x2");
    const std::vector<double> success = column(expected, "y");
    const AucDifference difference =
        paired_auc_test({first, HigherMeans::success}, {second, HigherMeans::success}, success);
    expect_equal(difference.first_auc.value(), expected["auc1"]);
    expect_equal(difference.second_auc.value(), expected["auc2"]);
    expect_equal(difference.difference.value(), expected["diff"]);
    const double variance =
        number(expected["var1"]) + number(expected["var2"]) - 2.0 * number(expected["cov_delong"]);
    EXPECT_NEAR(difference.variance.value(), variance, 1e-14);
    const json& test = expected["delong_paired"];
    expect_equal(difference.z.value(), test["Z"]);
    EXPECT_NEAR(difference.p_value.value(), number(test["p"]), 1e-9 * number(test["p"]));
    expect_equal(difference.interval->low, test["conf_int"][0]);
    expect_equal(difference.interval->high, test["conf_int"][1]);
    ++cases;
  }
  std::printf("pROC golden cases run: %zu paired tests\n", cases);
  EXPECT_GT(cases, 0U);
}

}  // namespace
}  // namespace tcert
