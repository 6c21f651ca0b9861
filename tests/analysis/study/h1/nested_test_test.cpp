#include "analysis/study/h1/nested_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "support/data_table.hpp"

namespace tcert::study {
namespace {

TEST(NestedTest, IsTheJackknifeOfClustersByT) {
  const std::vector<double> without{
      0.35, 0.52, 0.38, 0.41, 0.44, 0.3, 0.47, 0.39, 0.36, 0.45, 0.42, 0.33};
  // R: 2 * pt(-0.4 / sqrt(11 / 12 * sum((without - 0.4)^2)), 11).
  EXPECT_NEAR(cluster_jackknife_p(0.4, without).value(), 0.07014704861035717, 1e-14);
  EXPECT_FALSE(cluster_jackknife_p(0.4, std::vector<double>(12, 0.4))) << "no spread";
  std::vector<double> failed = without;
  failed[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(cluster_jackknife_p(0.4, failed));
}

H1Options two_predictors() {
  H1Options options;
  options.predictors = {{"added", statistics::HigherMeans::success, ""},
                        {"rival", statistics::HigherMeans::success, ""}};
  options.replicates = 1;
  return options;
}

/// 22 days of 30 trials whose outcome, rival and added predictor are alike within a day (0.5); what
/// is added is unrelated to the outcome.
std::string study(std::uint64_t index) {
  table::RandomStream random(5, 3, index);
  std::string csv = "day,success,time_s,added,rival\n";
  const double half = std::sqrt(0.5);
  for (int day = 0; day < 22; ++day) {
    const double of_day[] = {
        half * random.normal(), half * random.normal(), half * random.normal()};
    for (int trial = 0; trial < 30; ++trial) {
      const double ability = of_day[0] + half * random.normal();
      const double rival = 0.3 * ability + 0.95 * (of_day[1] + half * random.normal());
      const double added = of_day[2] + half * random.normal();
      const bool success = ability > -1.19;
      csv += "d" + std::to_string(day) + (success ? ",1," : ",0,") +
             std::to_string(success ? 60.0 - 5.0 * ability : 120.0) + "," + std::to_string(added) +
             "," + std::to_string(rival) + "\n";
    }
  }
  return csv;
}

TEST(NestedTest, KeepsItsLevelWhereTrialsOfADayAreAlike) {
  constexpr int kStudies = 60;
  int rejected = 0;
  int rejected_in_time = 0;
  int by_likelihood_ratio = 0;
  for (int index = 0; index < kStudies; ++index) {
    H1Options options = two_predictors();
    const H1Row row =
        hypothesis_h1(test_support::table_of(study(static_cast<std::uint64_t>(index))), options)
            .panels[0]
            .rows.back();
    rejected += row.auc_p.value() < 0.05 ? 1 : 0;
    rejected_in_time += row.c_p.value() < 0.05 ? 1 : 0;
    by_likelihood_ratio += row.auc_lr_p.value() < 0.05 ? 1 : 0;
  }
  // Of 60 at a true 5 % more than 9 are seen once in 1,000 times; the likelihood ratio, which takes
  // trials as independent, rejects a third.
  EXPECT_LE(rejected, 9);
  EXPECT_LE(rejected_in_time, 9);
  EXPECT_GE(by_likelihood_ratio, 12);
}

TEST(NestedTest, ARowWithoutAFitHasNoP) {
  // `added` tells successes from failures without error.
  std::string csv = "day,success,time_s,added,rival\n";
  table::RandomStream random(5, 4, 0);
  for (int i = 0; i < 240; ++i) {
    const double margin = 0.1 + 0.01 * (i % 40);
    const bool success = margin > 0.25;
    csv += "d" + std::to_string(i % 12) + (success ? ",1," : ",0,") +
           std::to_string(20 + random.below(60)) + "," + std::to_string(margin) + "," +
           std::to_string(random.normal()) + "\n";
  }
  const H1Row row =
      hypothesis_h1(test_support::table_of(csv), two_predictors()).panels[0].rows.back();
  EXPECT_FALSE(row.auc_p);
  EXPECT_FALSE(row.auc_lr_p);
  EXPECT_TRUE(row.c_p) << "the Cox model has a fit";
  ASSERT_TRUE(statistics::has(row.conditions, statistics::ConditionKind::complete_separation));
  // The threshold in the units of the column, not in standard deviations.
  bool named = false;
  for (const statistics::Condition& condition : row.conditions) {
    named = named || condition.detail.find(
                         "every row with added >= 0.26 has success = 1, every row with added <= "
                         "0.25 has success = 0") != std::string::npos;
    EXPECT_EQ(condition.detail.find("added >= 1"), std::string::npos) << condition.detail;
  }
  EXPECT_TRUE(named);
  // Complete separation by the rival: nothing is left to add to.
  H1Options turned = two_predictors();
  std::swap(turned.predictors[0], turned.predictors[1]);
  const H1Row other = hypothesis_h1(test_support::table_of(csv), turned).panels[0].rows.back();
  EXPECT_FALSE(other.auc_p);
  EXPECT_FALSE(other.auc_lr_p) << "was 1.000";
}

/// 240 trials on 12 days; `added(i)` is the predictor under test of trial i.
template <class Added, class Success>
std::string trials(const Added& added, const Success& success) {
  std::string csv = "day,success,time_s,added,rival\n";
  table::RandomStream random(5, 6, 0);
  for (int i = 0; i < 240; ++i) {
    csv += "d" + std::to_string(i % 12) + (success(i) ? ",1," : ",0,") +
           std::to_string(20 + random.below(60)) + "," + std::to_string(added(i)) + "," +
           std::to_string(i == 15 ? 0.0 : std::sin(7.0 * i)) + "\n";
  }
  return csv;
}

H1Row last_row(const std::string& csv) {
  return hypothesis_h1(test_support::table_of(csv), two_predictors()).panels[0].rows.back();
}

TEST(NestedTest, ADayThatAloneMovesThePredictorLeavesNoTest) {
  const H1Row row = last_row(trials([](int i) { return i % 12 == 0 ? std::cos(3.0 * i) : 0.0; },
                                    [](int i) { return std::sin(5.3 * i) > -0.4; }));
  EXPECT_TRUE(row.c_lr_p) << "the model of all days has a fit";
  EXPECT_FALSE(row.c_p) << "without that day the coefficient is no 0, there is none";
  EXPECT_FALSE(row.auc_p);
  bool named = false;
  for (const statistics::Condition& condition : row.conditions) {
    named = named || (condition.kind == statistics::ConditionKind::no_jackknife &&
                      condition.detail == "Cox model: 1 of 12 clusters");
  }
  EXPECT_TRUE(named);
}

TEST(NestedTest, APredictorThatHasRunAwayHasNoP) {
  // Complete separation but for one failure, among the successes by a hair.
  const auto margin = [](int i) { return i == 15 ? 0.26001 : 0.1 + 0.01 * (i % 40); };
  const H1Row row = last_row(trials(margin, [&](int i) { return i != 15 && margin(i) > 0.255; }));
  EXPECT_TRUE(statistics::has(row.conditions, statistics::ConditionKind::near_separation));
  EXPECT_FALSE(row.auc_lr_p);
  EXPECT_FALSE(row.auc_p);
  EXPECT_TRUE(row.c_lr_p) << "the Cox model has a fit";
}

}  // namespace
}  // namespace tcert::study
