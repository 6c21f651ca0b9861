// Every deterministic field of the pROC goldens, from the data sets they were made of. Left out:
// Venkatraman's test and the bootstrap ones, which are random, and `var_obuchowski`, which is
// Obuchowski & McClish's binormal formula.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <statistics/roc/roc.hpp>
#include <statistics/roc/roc_curve.hpp>
#include <string>
#include <vector>

#include "analysis/statistics/golden_columns.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::statistics {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kRelative = 1e-12;
constexpr double kPValue = 1e-9;

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

  void TearDown() override {
    for (const auto& [quantity, worst] : worst_) {
      std::printf("  %-22s worst relative disagreement %.1e\n", quantity.c_str(), worst);
    }
  }

  [[nodiscard]] std::vector<double> column(const json& test_case, const char* key) const {
    const std::vector<double> values = read_column(
        folder_ / "data" / test_case["data"].get<std::string>(), test_case[key].get<std::string>());
    EXPECT_FALSE(values.empty()) << test_case["data"] << ": no column " << test_case[key];
    return values;
  }

  /// Equal to `tolerance`, relative; where R has 0, to as much absolute.
  void expect(const std::string& quantity,
              double actual,
              const json& expected,
              double tolerance = kRelative) {
    const double value = number(expected);
    if (std::isinf(value)) {
      EXPECT_EQ(actual, value) << quantity;
      return;
    }
    const double error =
        value == 0.0 ? std::abs(actual) : std::abs(actual - value) / std::abs(value);
    EXPECT_LE(error, tolerance) << quantity << ": " << actual << " for " << value;
    worst_[quantity] = std::max(worst_[quantity], error);
  }

  void expect_curve(const RocCurve& curve, const json& expected);
  void expect_parts(const RocCurve& curve, const json& expected);
  void expect_best(const RocCurve& curve, BestBy criterion, const json& expected);

  fs::path folder_;
  json golden_;
  std::map<std::string, double> worst_;
};

void RocGolden::expect_curve(const RocCurve& curve, const json& expected) {
  const auto& points = curve.points;
  ASSERT_EQ(points.size(), expected["n_thresholds"].get<std::size_t>());
  const std::size_t shown = expected["threshold"].size();
  for (std::size_t k = 0; k < shown; ++k) {
    // The golden file shows points 1 + (n - 1) k / (shown - 1), rounded half to even as R does.
    const auto at = static_cast<std::size_t>(std::nearbyint(
        static_cast<double>((points.size() - 1) * k) / static_cast<double>(shown - 1)));
    const double threshold = number(expected["threshold"][k]);
    const auto is_at = [&](std::size_t i) {
      return i < points.size() &&
             (points[i].threshold == threshold ||
              std::abs(points[i].threshold - threshold) <= 1e-14 * std::abs(threshold));
    };
    const RocPoint& point = points[is_at(at) ? at : (is_at(at + 1) ? at + 1 : at)];
    expect("curve threshold", point.threshold, expected["threshold"][k]);
    expect("curve sensitivity", point.sensitivity, expected["sens"][k]);
    expect("curve specificity", point.specificity, expected["spec"][k]);
  }
}

void RocGolden::expect_parts(const RocCurve& curve, const json& expected) {
  const std::map<std::string, std::pair<double, double>> bounds{{"spec_100_90", {0.9, 1.0}},
                                                                {"spec_100_80", {0.8, 1.0}},
                                                                {"sens_100_90", {0.9, 1.0}},
                                                                {"spec_80_60", {0.6, 0.8}}};
  for (const auto& [name, part] : expected.items()) {
    SCOPED_TRACE(name);
    const auto [low, high] = bounds.at(name);
    const PartialAuc ours =
        partial_auc(curve,
                    low,
                    high,
                    part["focus"] == "sensitivity" ? RocFocus::sensitivity : RocFocus::specificity);
    expect("partial AUC", ours.area.value(), part["raw"]);
    if (part["corrected"] == "NA") {
      EXPECT_FALSE(ours.corrected.has_value());
      EXPECT_TRUE(has(ours.conditions, ConditionKind::below_diagonal));
    } else {
      expect("partial AUC corrected", ours.corrected.value(), part["corrected"]);
    }
  }
}

void RocGolden::expect_best(const RocCurve& curve, BestBy criterion, const json& expected) {
  const std::vector<RocThreshold> best = best_thresholds(curve, criterion);
  ASSERT_EQ(best.size(), expected["threshold"].size());
  for (std::size_t k = 0; k < best.size(); ++k) {
    expect("best threshold", best[k].point.threshold, expected["threshold"][k]);
    expect("best sensitivity", best[k].point.sensitivity, expected["sensitivity"][k]);
    expect("best specificity", best[k].point.specificity, expected["specificity"][k]);
    if (criterion != BestBy::youden) {
      continue;
    }
    expect("best accuracy", best[k].accuracy, expected["accuracy"][k]);
    expect("best youden",
           best[k].point.sensitivity + best[k].point.specificity,
           expected["youden"][k]);
    for (const auto& [key, ours] : {std::pair{"ppv", best[k].ppv}, {"npv", best[k].npv}}) {
      if (expected[key][k] == "NaN") {
        EXPECT_FALSE(ours.has_value()) << key;
      } else {
        expect(std::string("best ") + key, ours.value(), expected[key][k]);
      }
    }
  }
}

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
    expect("AUC", *estimate.auc, expected["auc_direction_lt"]);
    expect("variance", estimate.variance.value(), expected["delong_var"]);
    for (const auto& [level, key] :
         {std::pair{0.90, "ci_delong_90"}, {0.95, "ci_delong_95"}, {0.99, "ci_delong_99"}}) {
      const AucEstimate at_level = auc(score, success, HigherMeans::success, {level, {}});
      expect("interval", at_level.interval->low, expected[key][0]);
      expect("interval", at_level.interval->high, expected[key][2]);
    }
    expect("AUC",
           auc(score,
               success,
               expected["auto_direction"] == ">" ? HigherMeans::failure : HigherMeans::success)
               .auc.value(),
           expected["auto_auc"]);

    const RocCurve curve = roc_curve(score, success, HigherMeans::success);
    expect_curve(curve, expected["curve_points"]);
    expect_parts(curve, expected["partial"]);
    expect_best(curve, BestBy::youden, expected["best_youden"]);
    expect_best(curve, BestBy::closest_topleft, expected["best_topleft"]);
    expect(
        "sensitivity at", sensitivity_at(curve, 0.5).value(), expected["sens_at_spec_0.5_0.9"][0]);
    expect(
        "sensitivity at", sensitivity_at(curve, 0.9).value(), expected["sens_at_spec_0.5_0.9"][1]);
    ++cases;
  }
  std::printf("pROC golden cases run: %zu AUC\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(RocGolden, PlacementsEqualTheSumsOverAllPairs) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["auc"].items()) {
    SCOPED_TRACE(name);
    const std::vector<double> score = column(expected, "x");
    std::vector<std::uint8_t> success;
    for (const double y : column(expected, "y")) {
      success.push_back(y == 1.0 ? 1 : 0);
    }
    const Placements place = placements(score, success, HigherMeans::success);
    const json& brute = expected["brute"];
    expect("AUC", place.auc, brute["auc"]);
    expect("variance",
           auc(score, column(expected, "y"), HigherMeans::success).variance.value(),
           brute["var_delong"]);
    for (std::size_t k = 0; k < brute["V10_first"].size(); ++k) {
      expect("V10", place.successes[k], brute["V10_first"][k]);
      expect("V01", place.failures[k], brute["V01_first"][k]);
    }
    expect("Wilcoxon's W",
           place.auc * static_cast<double>(place.successes.size() * place.failures.size()),
           expected["wilcoxon"]["W"]);
    ++cases;
  }
  std::printf("pROC golden cases run: %zu placements\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(RocGolden, TestsEqualPRoc) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_["paired_tests"].items()) {
    SCOPED_TRACE(name);
    const std::vector<double> first = column(expected, "x1");
    const std::vector<double> second = column(expected, "x2");
    const std::vector<double> success = column(expected, "y");
    const std::vector<Score> markers{{first, HigherMeans::success}, {second, HigherMeans::success}};
    const JointAuc joint = joint_auc(markers, success);
    const AucDifference difference = auc_contrast(joint, 0, 1);
    expect("AUC", difference.first_auc.value(), expected["auc1"]);
    expect("AUC", difference.second_auc.value(), expected["auc2"]);
    expect("difference", difference.difference.value(), expected["diff"]);
    expect("variance", (*joint.covariance)(0, 0), expected["var1"]);
    expect("variance", (*joint.covariance)(1, 1), expected["var2"]);
    expect("covariance", (*joint.covariance)(0, 1), expected["cov_delong"]);
    const json& paired = expected["delong_paired"];
    expect("Z", difference.z.value(), paired["Z"]);
    expect("p", difference.p_value.value(), paired["p"], kPValue);
    expect("difference interval", difference.interval->low, paired["conf_int"][0]);
    expect("difference interval", difference.interval->high, paired["conf_int"][1]);
    expect("p one-sided",
           auc_contrast(joint, 0, 1, Alternative::less).p_value.value(),
           expected["delong_paired_less"]["p"],
           kPValue);
    expect("p one-sided",
           auc_contrast(joint, 0, 1, Alternative::greater).p_value.value(),
           expected["delong_paired_greater"]["p"],
           kPValue);
    const UnpairedAucTest unpaired = unpaired_auc_test(joint.markers[0], joint.markers[1]);
    expect("unpaired D", unpaired.t.value(), expected["delong_unpaired"]["D"]);
    expect("unpaired df", unpaired.degrees_of_freedom.value(), expected["delong_unpaired"]["df"]);
    expect("unpaired p", unpaired.p_value.value(), expected["delong_unpaired"]["p"], kPValue);
    ++cases;
  }
  std::printf("pROC golden cases run: %zu tests of two AUCs\n", cases);
  EXPECT_GT(cases, 0U);
}

}  // namespace
}  // namespace tcert::statistics
