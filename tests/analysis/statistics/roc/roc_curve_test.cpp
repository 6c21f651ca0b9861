#include <statistics/roc/roc_curve.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <statistics/roc/roc.hpp>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(RocCurve, StepsFromEverythingToNothing) {
  const std::vector<double> score{3, 2, 1, 2};
  const std::vector<double> success{1, 1, 0, 0};
  const std::vector<RocPoint> points = roc_curve(score, success, HigherMeans::success).points;
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0].threshold, -kInf);
  EXPECT_EQ(points[0].sensitivity, 1.0);
  EXPECT_EQ(points[0].specificity, 0.0);
  EXPECT_EQ(points[1].threshold, 1.5);
  EXPECT_EQ(points[1].sensitivity, 1.0);
  EXPECT_EQ(points[1].specificity, 0.5);
  EXPECT_EQ(points[2].threshold, 2.5);
  EXPECT_EQ(points[2].sensitivity, 0.5);
  EXPECT_EQ(points[2].specificity, 1.0);
  EXPECT_EQ(points[3].threshold, kInf);
  EXPECT_EQ(points[3].sensitivity, 0.0);
  EXPECT_EQ(points[3].specificity, 1.0);
  EXPECT_TRUE(roc_curve(score, std::vector<double>(4, 1.0), HigherMeans::success).points.empty());
}

RocCurve random_curve(HigherMeans higher,
                      std::vector<double>& score,
                      std::vector<double>& success) {
  table::RandomStream random(7, 0, 0);
  for (int i = 0; i < 200; ++i) {
    success.push_back(i % 4 == 0 ? 0 : 1);
    score.push_back(static_cast<double>(random.below(25)) + 3.0 * success.back());
  }
  return roc_curve(score, success, higher);
}

TEST(RocCurve, EnclosesTheAucInPartsAndInWhole) {
  for (const HigherMeans higher : {HigherMeans::success, HigherMeans::failure}) {
    std::vector<double> score;
    std::vector<double> success;
    const RocCurve curve = random_curve(higher, score, success);
    const double whole = auc(score, success, higher).auc.value();
    for (const RocFocus focus : {RocFocus::specificity, RocFocus::sensitivity}) {
      EXPECT_NEAR(partial_auc(curve, 0.0, 1.0, focus).area.value(), whole, 1e-13);
      EXPECT_NEAR(partial_auc(curve, 0.0, 0.37, focus).area.value() +
                      partial_auc(curve, 0.37, 0.5, focus).area.value() +
                      partial_auc(curve, 0.5, 1.0, focus).area.value(),
                  whole,
                  1e-13);
    }
  }
}

TEST(PartialAuc, IsCorrectedAsMcClishDoes) {
  // The curve goes (specificity 0, sensitivity 1), (0.5, 1), (1, 0.5), (1, 0). Above 0.8 it falls
  // from 0.7 to 0.5: 0.2 * 0.6 = 0.12. Chance has 0.02, perfection 0.2.
  const RocCurve curve = roc_curve(
      std::vector<double>{3, 2, 1, 2}, std::vector<double>{1, 1, 0, 0}, HigherMeans::success);
  const PartialAuc part = partial_auc(curve, 0.8, 1.0);
  EXPECT_NEAR(part.area.value(), 0.12, 1e-15);
  EXPECT_NEAR(part.corrected.value(), 0.5 * (1.0 + 0.1 / 0.18), 1e-14);

  const RocCurve below = roc_curve(
      std::vector<double>{1, 2, 3, 4}, std::vector<double>{1, 1, 0, 0}, HigherMeans::success);
  const PartialAuc none = partial_auc(below, 0.8, 1.0);
  EXPECT_EQ(none.area, 0.0);
  EXPECT_FALSE(none.corrected.has_value());
  EXPECT_TRUE(has(none.conditions, ConditionKind::below_diagonal));

  EXPECT_TRUE(has(partial_auc(RocCurve{}, 0.8, 1.0).conditions, ConditionKind::one_class));
  EXPECT_THROW(static_cast<void>(partial_auc(curve, 1.0, 0.8)), std::invalid_argument);
}

TEST(BestThresholds, NameEveryTie) {
  // Youden: (0.5, 1) and (1, 0.5) both give 1.5; both are as far from the corner.
  const RocCurve curve = roc_curve(
      std::vector<double>{3, 2, 1, 2}, std::vector<double>{1, 1, 0, 0}, HigherMeans::success);
  for (const BestBy criterion : {BestBy::youden, BestBy::closest_topleft}) {
    const std::vector<RocThreshold> best = best_thresholds(curve, criterion);
    ASSERT_EQ(best.size(), 2U);
    EXPECT_EQ(best[0].point.threshold, 1.5);
    EXPECT_EQ(best[0].accuracy, 0.75);
    EXPECT_EQ(best[0].ppv, 2.0 / 3.0);
    EXPECT_EQ(best[0].npv, 1.0);
    EXPECT_EQ(best[1].point.threshold, 2.5);
    EXPECT_EQ(best[1].ppv, 1.0);
    EXPECT_EQ(best[1].npv, 2.0 / 3.0);
  }
  EXPECT_TRUE(best_thresholds(RocCurve{}, BestBy::youden).empty());
}

TEST(SensitivityAt, TakesThePointOrTheLineBetween) {
  const RocCurve curve = roc_curve(
      std::vector<double>{3, 2, 1, 2}, std::vector<double>{1, 1, 0, 0}, HigherMeans::success);
  EXPECT_EQ(sensitivity_at(curve, 0.5), 1.0);
  EXPECT_EQ(sensitivity_at(curve, 0.75), 0.75);
  EXPECT_EQ(sensitivity_at(curve, 1.0), 0.5) << "the larger of the two there";
  EXPECT_FALSE(sensitivity_at(RocCurve{}, 0.5).has_value());
  EXPECT_THROW(static_cast<void>(sensitivity_at(curve, 1.5)), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
