#include <statistics/equivalence/scores_by_group.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/equivalence/statistic_by_group.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

/// Trials of days in groups, with ties; the groups share days.
struct Trials {
  std::vector<double> x;
  std::vector<std::uint8_t> success;
  SurvivalOutcome time;
  table::Factor group;
  table::Factor day;
};

Trials trials(std::size_t n, std::uint32_t groups, std::uint32_t days) {
  table::RandomStream random(9, 1, n);
  Trials made;
  for (std::uint32_t g = 0; g < groups; ++g) {
    made.group.levels.push_back("g" + std::to_string(g));
  }
  for (std::uint32_t d = 0; d < days; ++d) {
    made.day.levels.push_back("d" + std::to_string(d));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t day = random.below(days);
    const double x = std::round(4.0 * (random.normal() + 0.3 * day)) / 4.0;
    made.x.push_back(x);
    made.day.codes.push_back(day);
    made.group.codes.push_back(random.below(groups));
    made.success.push_back(random.uniform() < 1.0 / (1.0 + std::exp(-x)) ? 1 : 0);
    made.time.stop.push_back(std::round(20.0 * random.uniform() + 5.0 - x));
    made.time.event.push_back(made.success.back());
  }
  round_times(made.time);
  return made;
}

TEST(AucByGroup, AGroupByItselfIsItsClusteredDeLong) {
  const Trials t = trials(200, 2, 9);
  const std::vector<GroupScore> scores =
      auc_by_group({t.x, HigherMeans::failure}, t.success, t.group, t.day.codes);
  std::vector<double> x;
  std::vector<double> y;
  std::vector<std::uint32_t> day;
  for (std::size_t i = 0; i < t.x.size(); ++i) {
    if (t.group.codes[i] == 1) {
      x.push_back(t.x[i]);
      y.push_back(t.success[i]);
      day.push_back(t.day.codes[i]);
    }
  }
  const AucEstimate alone = auc(x, y, HigherMeans::failure, {0.95, day});
  EXPECT_EQ(*scores[1].value, *alone.auc);
  EXPECT_NEAR(std::pow(*scores[1].standard_error, 2), *alone.variance, 1e-16);
}

TEST(ScoresByGroup, AGroupWithoutAnEstimateSaysSo) {
  Trials t = trials(120, 2, 6);
  for (std::size_t i = 0; i < t.x.size(); ++i) {
    t.success[i] = t.group.codes[i] == 0 ? 1 : t.success[i];
  }
  const std::vector<GroupScore> scores =
      auc_by_group({t.x, HigherMeans::success}, t.success, t.group, t.day.codes);
  EXPECT_TRUE(has(scores[0].conditions, ConditionKind::one_class));
  EXPECT_TRUE(scores[1].value.has_value());
  t.group.codes[3] = table::Factor::kMissing;
  EXPECT_THROW(
      static_cast<void>(auc_by_group({t.x, HigherMeans::success}, t.success, t.group, t.day.codes)),
      std::invalid_argument);
}

TEST(StatisticByGroup, IsTheStatisticOfEachGroupToTheLastBit) {
  const Trials t = trials(200, 3, 10);
  const Score score{t.x, HigherMeans::success};
  const Predictor predictor{"x", t.x, LargerMeans::shorter_time};
  const Statistic whole = joined(
      {auc_statistic({&score, 1}, t.success), concordance_statistic(t.time, {&predictor, 1})});
  const Statistic parts = by_group(whole, t.group);
  std::vector<double> values(parts.values);
  parts.make_kernel()(std::vector<std::uint32_t>(200, 1), values);
  const std::vector<GroupScore> auc = auc_by_group(score, t.success, t.group, t.day.codes);
  const std::vector<GroupScore> c = concordance_by_group(t.time, predictor, t.group, t.day);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_EQ(values[2 * g], *auc[g].value);
    EXPECT_EQ(values[2 * g + 1], *c[g].value);
  }
  const double range = range_of(whole, 0, 3)()(t.group.codes);
  const auto [least, most] = std::minmax({*auc[0].value, *auc[1].value, *auc[2].value});
  EXPECT_EQ(range, most - least);
  EXPECT_TRUE(std::isnan(range_of(whole, 0, 4)()(t.group.codes)));
}

}  // namespace
}  // namespace tcert::statistics
