#include <statistics/calibration/calibration.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <statistics/calibration/out_of_fold.hpp>
#include <stdexcept>
#include <table/random.hpp>

namespace tcert::statistics {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Predictions {
  std::vector<double> y;
  std::vector<double> p;
};

/// Outcomes that follow their probabilities, which take few values if `ties`.
Predictions honest(std::size_t n, bool ties = false) {
  table::RandomStream random(3, 1, 0);
  Predictions made;
  for (std::size_t i = 0; i < n; ++i) {
    const double p =
        ties ? 0.1 * (1.0 + random.below(4)) : 1.0 / (1.0 + std::exp(-1.5 * random.normal()));
    made.p.push_back(p);
    made.y.push_back(random.uniform() < p ? 1.0 : 0.0);
  }
  return made;
}

void expect_exact_sum(const BrierParts& parts) {
  EXPECT_NEAR(parts.score,
              parts.reliability - parts.resolution + parts.uncertainty + parts.within_variance -
                  parts.within_covariance,
              1e-15);
}

TEST(Calibration, ByHand) {
  const std::vector<double> y{0, 1, 0, 1, 1, 1};
  const std::vector<double> p{0.1, 0.2, 0.3, 0.5, 0.5, 0.8};
  CalibrationOptions options;
  options.bins = 3;
  const ModelCalibration result = calibration(y, p, nullptr, options);
  // Cut at 0.1, 0.2667, 0.5, 0.8: two, three and one trials.
  ASSERT_EQ(result.bins.size(), 3U);
  EXPECT_EQ(result.bins[0].trials, 2U);
  EXPECT_EQ(result.bins[1].events, 2U);
  EXPECT_NEAR(result.brier->score, (0.01 + 0.64 + 0.09 + 0.25 + 0.25 + 0.04) / 6.0, 1e-15);
  const double middle = 1.3 / 3.0;
  EXPECT_NEAR(result.brier->within_variance,
              (2.0 * 0.0025 + 2.0 * std::pow(0.5 - middle, 2) + std::pow(0.3 - middle, 2)) / 6.0,
              1e-15);
  EXPECT_NEAR(result.brier->reliability,
              (2.0 * std::pow(0.15 - 0.5, 2) + 3.0 * std::pow(middle - 2.0 / 3.0, 2) + 0.04) / 6.0,
              1e-15);
  EXPECT_NEAR(result.brier->uncertainty, 2.0 / 9.0, 1e-15);
  expect_exact_sum(*result.brier);
  EXPECT_NEAR(*result.expected_to_observed, 2.4 / 4.0, 1e-15);
  EXPECT_NEAR(result.hosmer_lemeshow->statistic,
              std::pow(1.0 - 0.3, 2) / (0.3 * 0.85) +
                  std::pow(2.0 - 1.3, 2) / (1.3 * (1.0 - middle)) + 0.04 / (0.8 * 0.2),
              1e-14);
  EXPECT_EQ(result.hosmer_lemeshow->df, 1U);
}

TEST(Calibration, ACutThatTiesIsOne) {
  // Quantiles 0, 1/3, 2/3, 1 are 0.2, 0.2, 0.5, 0.8: as R's cut() with unique breaks.
  CalibrationOptions options;
  options.bins = 3;
  const ModelCalibration result = calibration(std::vector<double>{0, 1, 0, 1, 1, 1},
                                              std::vector<double>{0.2, 0.2, 0.2, 0.5, 0.5, 0.8},
                                              nullptr,
                                              options);
  ASSERT_EQ(result.bins.size(), 2U);
  EXPECT_EQ(result.bins[0].trials, 5U);
  EXPECT_TRUE(has(result.conditions, ConditionKind::few_bins));
  EXPECT_FALSE(result.hosmer_lemeshow.has_value());
}

TEST(Calibration, HonestProbabilitiesHaveSlopeOneAndInterceptNought) {
  const Predictions made = honest(20000);
  const ModelCalibration result = calibration(made.y, made.p);
  EXPECT_NEAR(*result.slope.estimate, 1.0, 4.0 * *result.slope.standard_error);
  EXPECT_NEAR(*result.in_the_large.estimate, 0.0, 4.0 * *result.in_the_large.standard_error);
  EXPECT_NEAR(*result.expected_to_observed, 1.0, 0.02);
  EXPECT_GT(result.hosmer_lemeshow->p_value, 1e-4);
  expect_exact_sum(*result.brier);
  EXPECT_EQ(result.bins.size(), 10U);
}

TEST(Calibration, RecalibratingUndoesAShiftAndAStretch) {
  Predictions made = honest(500);
  const ModelCalibration before = calibration(made.y, made.p);
  for (double& p : made.p) {
    p = 1.0 / (1.0 + std::exp(-(0.5 + 2.0 * std::log(p / (1.0 - p)))));
  }
  const ModelCalibration after = calibration(made.y, made.p);
  EXPECT_NEAR(*after.slope.estimate, 0.5 * *before.slope.estimate, 1e-10);
  EXPECT_NEAR(
      *after.intercept.estimate, *before.intercept.estimate - 0.25 * *before.slope.estimate, 1e-10);
}

TEST(Calibration, TiesLeaveFewerBinsAndSaySo) {
  const Predictions made = honest(400, true);
  const ModelCalibration result = calibration(made.y, made.p);
  EXPECT_TRUE(has(result.conditions, ConditionKind::few_bins));
  EXPECT_LE(result.bins.size(), 4U);
  expect_exact_sum(*result.brier);
  std::size_t trials = 0;
  for (const CalibrationBin& bin : result.bins) {
    trials += bin.trials;
  }
  EXPECT_EQ(trials, 400U);
}

TEST(Calibration, RowOrderDoesNotMatterAndMissingRowsAreCounted) {
  Predictions made = honest(100);
  const ModelCalibration one = calibration(made.y, made.p);
  std::reverse(made.y.begin(), made.y.end());
  std::reverse(made.p.begin(), made.p.end());
  made.y.push_back(kNaN);
  made.p.push_back(0.5);
  made.y.push_back(1.0);
  made.p.push_back(kNaN);
  const ModelCalibration two = calibration(made.y, made.p);
  EXPECT_EQ(two.missing, 2U);
  EXPECT_EQ(two.rows, 100U);
  EXPECT_NEAR(*one.slope.estimate, *two.slope.estimate, 1e-12);
  EXPECT_NEAR(one.hosmer_lemeshow->statistic, two.hosmer_lemeshow->statistic, 1e-11);
}

TEST(Calibration, NamesWhatIsWrong) {
  const std::vector<double> y{0, 1, 0, 1};
  const auto conditions = [](const std::vector<double>& outcome, const std::vector<double>& p) {
    return calibration(outcome, p).conditions;
  };
  const ModelCalibration outside = calibration(y, std::vector<double>{0.1, 1.0, 0.3, 1.2});
  ASSERT_TRUE(has(outside.conditions, ConditionKind::bad_probability));
  EXPECT_EQ(outside.conditions[0].detail, "1 row, row 4 with 1.2");
  EXPECT_FALSE(outside.brier.has_value());
  EXPECT_TRUE(has(conditions({1, 1, 1}, {0.2, 0.3, 0.4}), ConditionKind::one_class));
  EXPECT_TRUE(has(conditions({kNaN}, {0.2}), ConditionKind::no_rows));
  EXPECT_TRUE(
      has(conditions({0, 0, 1, 1}, {0.1, 0.2, 0.8, 0.9}), ConditionKind::complete_separation));
  const ModelCalibration constant = calibration(y, std::vector<double>(4, 0.5));
  EXPECT_TRUE(has(constant.conditions, ConditionKind::constant_column));
  EXPECT_FALSE(constant.slope.estimate.has_value());
  EXPECT_NEAR(constant.in_the_large.estimate.value(), 0.0, 1e-12);
  EXPECT_FALSE(constant.hosmer_lemeshow.has_value());
  EXPECT_THROW(static_cast<void>(conditions({0, 2}, {0.5, 0.5})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(conditions({0, 1}, {0.5})), std::invalid_argument);
}

TEST(Calibration, ProbabilitiesOfNoughtAndOneKeepTheirBrierScore) {
  const std::vector<double> y{1, 0, 1, 0, 1, 0};
  const std::vector<double> p{0.9, 0.2, 1, 0.4, 0.7, 0};
  CalibrationOptions options;
  options.column = "p";
  options.place = [](std::size_t row) { return "line " + std::to_string(row + 2); };
  const ModelCalibration certain = calibration(y, p, nullptr, options);
  ASSERT_TRUE(has(certain.conditions, ConditionKind::certain_probability));
  EXPECT_EQ(certain.conditions[0].column, "p");
  EXPECT_EQ(certain.conditions[0].severity, ConditionSeverity::warning);
  EXPECT_EQ(certain.conditions[0].detail, "2 rows, the first is line 4 with 1");
  EXPECT_NEAR(certain.brier->score, (0.01 + 0.04 + 0.0 + 0.16 + 0.09 + 0.0) / 6.0, 1e-15);
  EXPECT_FALSE(certain.slope.estimate.has_value());
  EXPECT_FALSE(certain.in_the_large.estimate.has_value());
  EXPECT_FALSE(certain.hosmer_lemeshow.has_value()) << "a bin expects exactly none";
  EXPECT_EQ(certain.bins.size(), 6U) << "six predictions, all different";
  EXPECT_NEAR(certain.expected_to_observed.value(), 3.2 / 3.0, 1e-15);
  // One that is wrong for sure still has a score.
  EXPECT_NEAR(calibration(std::vector<double>{0, 1}, std::vector<double>{1, 0.5}).brier->score,
              1.25 / 2.0,
              1e-15);
}

TEST(Calibration, WithoutAnyPredictionNothingIsMissing) {
  const ModelCalibration none =
      calibration(std::vector<double>{0, 1, 0}, std::vector<double>(3, kNaN));
  EXPECT_TRUE(has(none.conditions, ConditionKind::no_prediction));
  EXPECT_FALSE(has(none.conditions, ConditionKind::no_rows));
}

LogisticInput input_of(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  LogisticInput input;
  input.design = Eigen::MatrixXd::Ones(n, 2);
  input.design.col(1) = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  input.columns = {"(Intercept)", "x"};
  input.terms = {"x"};
  input.term_of = {0, 1};
  input.successes = Eigen::Map<const Eigen::VectorXd>(y.data(), n);
  return input;
}

TEST(OutOfFold, PredictsWithTheOtherFolds) {
  const LogisticInput input = input_of({1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 0, 1, 0, 1, 0, 1});
  Folds folds;
  folds.count = 2;
  folds.of_row = {0, 0, 0, 0, 1, 1, 1, 1};
  const OutOfFold result = out_of_fold_probabilities(input, folds);
  const LogisticFit half = fit_logistic(input_of({5, 6, 7, 8}, {0, 1, 0, 1}));
  const double eta = *half.coefficients[0].estimate + 2.0 * *half.coefficients[1].estimate;
  EXPECT_NEAR(result.probability[1], 1.0 / (1.0 + std::exp(-eta)), 1e-12);
  EXPECT_TRUE(result.conditions.empty());
}

TEST(OutOfFold, NamesFoldsWithoutAFit) {
  Folds folds;
  folds.count = 2;
  folds.of_row = {0, 0, 0, 0, 1, 1, 1, 1};
  // Without fold 1 one class is left; without fold 2 the rest is separated.
  const OutOfFold bad = out_of_fold_probabilities(
      input_of({1, 2, 3, 4, 5, 6, 7, 8}, {0, 0, 1, 1, 1, 1, 1, 1}), folds);
  ASSERT_EQ(bad.conditions.size(), 2U);
  EXPECT_EQ(bad.conditions[0].kind, ConditionKind::one_class_fold);
  EXPECT_EQ(bad.conditions[1].kind, ConditionKind::fold_without_fit);
  EXPECT_EQ(bad.conditions[1].detail, "fold 2: they are separated");
  EXPECT_TRUE(std::isnan(bad.probability[0]));
  // A column that is constant outside the fold.
  const OutOfFold level = out_of_fold_probabilities(
      input_of({0, 0, 0, 0, 1, 1, 0, 0}, {0, 1, 1, 0, 1, 0, 1, 0}), folds);
  ASSERT_EQ(level.conditions.size(), 1U);
  EXPECT_EQ(level.conditions[0].detail, "fold 2: they do not determine every coefficient");
  EXPECT_FALSE(std::isnan(level.probability[0]));
  EXPECT_TRUE(std::isnan(level.probability[4]));
}

}  // namespace
}  // namespace tcert::statistics
