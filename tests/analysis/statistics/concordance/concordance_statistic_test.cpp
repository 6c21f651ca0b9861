#include <statistics/concordance/concordance_statistic.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <stdexcept>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

/// C over all pairs of rows, each as often as it stands.
double all_pairs_c(const SurvivalOutcome& outcome,
                   const std::vector<double>& risk,
                   std::span<const std::uint32_t> times) {
  double wins = 0.0;
  double pairs = 0.0;
  for (std::size_t i = 0; i < risk.size(); ++i) {
    for (std::size_t j = 0; j < risk.size(); ++j) {
      const bool first = outcome.stop[i] < outcome.stop[j] ||
                         (outcome.stop[i] == outcome.stop[j] && outcome.event[j] == 0);
      if (outcome.event[i] != 0 && first) {
        const double count = static_cast<double>(times[i]) * times[j];
        pairs += count;
        wins += count * (risk[i] > risk[j] ? 1.0 : (risk[i] == risk[j] ? 0.5 : 0.0));
      }
    }
  }
  return wins / pairs;
}

struct Data {
  SurvivalOutcome outcome;
  std::vector<double> first, second;
  std::vector<std::uint8_t> success;

  [[nodiscard]] std::vector<Predictor> predictors() const {
    return {{"first", first, LargerMeans::shorter_time},
            {"second", second, LargerMeans::shorter_time}};
  }
};

Data random_data(std::uint64_t seed, std::size_t rows) {
  table::RandomStream random(seed, 8, 0);
  Data data;
  for (std::size_t row = 0; row < rows; ++row) {
    data.outcome.stop.push_back(1.0 + random.below(20));
    data.success.push_back(random.below(4) == 0 ? 0 : 1);
    data.outcome.event.push_back(data.success.back());
    data.first.push_back(random.below(9));
    data.second.push_back(random.below(5));
  }
  data.success[0] = data.outcome.event[0] = 0;
  return data;
}

TEST(ConcordanceStatistic, EqualsTheSumOverAllPairs) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Data data = random_data(seed, 6 + seed);
    const Statistic statistic =
        concordance_statistic(data.outcome, data.predictors(), {{0, 1}, {1, 0}});
    const StatisticKernel kernel = statistic.make_kernel();
    const ResamplingPlan plan = ResamplingPlan::of_rows(data.first.size());
    std::vector<std::uint32_t> scratch(plan.units()), times(plan.rows(), 1);
    std::vector<double> values(4);
    for (std::uint64_t replicate = 0; replicate < 5; ++replicate) {
      kernel(times, values);
      const double first = all_pairs_c(data.outcome, data.first, times);
      const double second = all_pairs_c(data.outcome, data.second, times);
      if (std::isnan(first)) {
        EXPECT_TRUE(std::isnan(values[0]));
      } else {
        EXPECT_EQ(values[0], first);
        EXPECT_EQ(values[1], second);
        EXPECT_NEAR(values[2], first - second, 1e-15);
        EXPECT_EQ(values[3], -values[2]);
      }
      plan.draw(seed, 0, replicate, scratch, times);
    }
  }
}

TEST(ConcordanceStatistic, LeavesOutUnitsAsItsKernelDoes) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Data data = random_data(seed, 6 + 2 * seed);
    table::RandomStream random(seed, 9, 0);
    const std::size_t rows = data.first.size();
    table::Factor strata{{}, {"a", "b", "c"}};
    std::vector<std::uint32_t> cluster;
    for (std::size_t row = 0; row < rows; ++row) {
      strata.codes.push_back(random.below(3));
      cluster.push_back(random.below(seed % 2 == 0 ? 4 : 30));
      if (seed % 3 == 0) {
        data.outcome.start.push_back(data.outcome.stop[row] - 0.5 - random.below(8));
      }
    }
    Statistic fast = concordance_statistic(
        data.outcome, data.predictors(), {{0, 1}}, seed % 5 == 0 ? nullptr : &strata);
    Statistic slow = fast;
    slow.leave_one_out = nullptr;
    for (const ResamplingPlan& plan :
         {ResamplingPlan::of_rows(rows), ResamplingPlan::of_clusters(cluster)}) {
      const auto expected = leave_one_out(slow, plan);
      const auto found = leave_one_out(fast, plan);
      for (std::size_t value = 0; value < expected.size(); ++value) {
        for (std::size_t unit = 0; unit < plan.units(); ++unit) {
          if (std::isnan(expected[value][unit])) {
            EXPECT_TRUE(std::isnan(found[value][unit]));
          } else {
            EXPECT_EQ(found[value][unit], expected[value][unit]);
          }
        }
      }
    }
  }
}

TEST(ConcordanceStatistic, SharesItsResamplesWithAnAuc) {
  const Data data = random_data(3, 60);
  const Score score{data.first, HigherMeans::success};
  const Statistic auc_alone = auc_statistic({&score, 1}, data.success);
  const Statistic c_alone = concordance_statistic(data.outcome, data.predictors());
  const ResamplingPlan plan = ResamplingPlan::of_rows(60);
  const BootstrapOptions options{200, 4, 1};
  const BootstrapResult both = bootstrap(joined({auc_alone, c_alone}), plan, options);
  const BootstrapResult one = bootstrap(auc_alone, plan, options);
  const BootstrapResult other = bootstrap(c_alone, plan, options);
  ASSERT_EQ(both.replicates.size(), 3U);
  EXPECT_EQ(both.replicates[0], one.replicates[0]);
  EXPECT_EQ(both.replicates[2], other.replicates[1]);
  EXPECT_EQ(both.left_out[0], one.left_out[0]);
  EXPECT_EQ(both.left_out[1], other.left_out[0]);
}

TEST(ConcordanceStatistic, RefusesMisuse) {
  const Data data = random_data(3, 10);
  EXPECT_THROW(static_cast<void>(concordance_statistic(data.outcome, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(concordance_statistic(data.outcome, data.predictors(), {{0, 2}})),
               std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
