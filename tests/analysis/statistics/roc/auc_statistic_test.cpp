#include <statistics/roc/auc_statistic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

struct Data {
  std::vector<std::vector<double>> columns;
  std::vector<std::uint8_t> success;
  std::vector<std::uint32_t> cluster;

  [[nodiscard]] std::vector<Score> scores() const {
    return {{columns[0], HigherMeans::success}, {columns[1], HigherMeans::failure}};
  }
};

Data random_data(std::uint64_t seed, std::size_t rows, std::uint32_t levels) {
  table::RandomStream random(seed, 4, 0);
  Data data;
  data.columns.resize(2);
  for (std::size_t row = 0; row < rows; ++row) {
    data.success.push_back(random.below(4) == 0 ? 0 : 1);
    data.cluster.push_back(random.below(6));
    data.columns[0].push_back(random.below(levels) + data.success.back());
    data.columns[1].push_back(random.below(levels));
  }
  data.success[0] = 0;
  data.success[1] = 1;
  return data;
}

/// The rows written out as often as they stand.
double auc_written_out(const Data& data,
                       std::size_t column,
                       std::span<const std::uint32_t> multiplicity) {
  std::vector<double> score;
  std::vector<double> success;
  for (std::size_t row = 0; row < multiplicity.size(); ++row) {
    for (std::uint32_t k = 0; k < multiplicity[row]; ++k) {
      score.push_back(data.columns[column][row]);
      success.push_back(data.success[row]);
    }
  }
  return auc(score, success, data.scores()[column].higher)
      .auc.value_or(std::numeric_limits<double>::quiet_NaN());
}

void expect_same(double actual, double expected) {
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(actual));
  } else {
    EXPECT_EQ(actual, expected);
  }
}

TEST(AucStatistic, EqualsTheAucOfTheRowsWrittenOutBitForBit) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Data data = random_data(seed, 3 + seed, 2 + static_cast<std::uint32_t>(seed % 9) * 5);
    const Statistic statistic = auc_statistic(data.scores(), data.success, {{0, 1}, {1, 0}});
    ASSERT_EQ(statistic.values, 4U);
    const StatisticKernel kernel = statistic.make_kernel();
    const ResamplingPlan plan = ResamplingPlan::of_rows(data.success.size());
    std::vector<std::uint32_t> scratch(plan.units()), multiplicity(plan.rows(), 1);
    std::vector<double> values(4);
    for (std::uint64_t replicate = 0; replicate < 10; ++replicate) {
      kernel(multiplicity, values);
      const double first = auc_written_out(data, 0, multiplicity);
      const double second = auc_written_out(data, 1, multiplicity);
      expect_same(values[0], first);
      expect_same(values[1], second);
      if (!std::isnan(first)) {
        EXPECT_NEAR(values[2], first - second, 1e-15);
        EXPECT_EQ(values[3], -values[2]);
      }
      plan.draw(seed, 0, replicate, scratch, multiplicity);
    }
  }
}

TEST(AucStatistic, LeavesOutRowsAndClustersAsIfTheyWereNotThere) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Data data = random_data(seed, 5 + seed, 2 + static_cast<std::uint32_t>(seed % 7) * 4);
    const Statistic statistic = auc_statistic(data.scores(), data.success, {{0, 1}});
    Statistic by_kernel = statistic;
    by_kernel.leave_one_out = nullptr;
    for (const bool clusters : {false, true}) {
      const ResamplingPlan plan = clusters ? ResamplingPlan::of_clusters(data.cluster)
                                           : ResamplingPlan::of_rows(data.success.size());
      const auto fast = leave_one_out(statistic, plan);
      const auto slow = leave_one_out(by_kernel, plan);
      for (std::size_t value = 0; value < 3; ++value) {
        for (std::size_t unit = 0; unit < plan.units(); ++unit) {
          expect_same(fast[value][unit], slow[value][unit]);
        }
      }
    }
  }
}

TEST(AucStatistic, FailsWhereAResampleHasOneClass) {
  const std::vector<double> x{1, 2, 3};
  const std::vector<std::uint8_t> success{0, 1, 1};
  const Score score{x, HigherMeans::success};
  const Statistic statistic = auc_statistic({&score, 1}, success);
  const BootstrapResult result = bootstrap(statistic, ResamplingPlan::of_rows(3), {1000, 1, 0});
  const BootstrapEstimate estimate = bootstrap_estimate(result, 0);
  // No failure in three draws: 8/27; no success: 1/27.
  std::size_t failed = 0;
  for (const double t : result.replicates[0]) {
    failed += std::isnan(t) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(failed), 1000.0 / 3.0, 4.0 * 15.0);
  EXPECT_FALSE(estimate.interval.has_value()) << "the others are all 1";
  EXPECT_TRUE(has(estimate.conditions, ConditionKind::failed_replicates));
  EXPECT_TRUE(has(estimate.conditions, ConditionKind::constant_replicates));
}

TEST(AucStatistic, RefusesMisuse) {
  const std::vector<double> x{1, std::numeric_limits<double>::quiet_NaN()};
  const std::vector<double> y{1, 2};
  const std::vector<std::uint8_t> success{0, 1};
  const Score missing{x, HigherMeans::success};
  const Score known{y, HigherMeans::success};
  EXPECT_THROW(static_cast<void>(auc_statistic({&missing, 1}, success)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(auc_statistic({&known, 1}, success, {{0, 1}})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(auc_statistic({}, success)), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
