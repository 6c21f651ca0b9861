#include <statistics/resampling/bootstrap.hpp>

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <stdexcept>
#include <table/factor.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The mean of `values`.
Statistic mean_of(std::vector<double> values) {
  const std::size_t rows = values.size();
  return scalar_statistic(rows, [values] {
    return [values](std::span<const std::uint32_t> multiplicity) {
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t k = 0; k < values.size(); ++k) {
        sum += multiplicity[k] * values[k];
        count += multiplicity[k];
      }
      return sum / count;
    };
  });
}

TEST(ResamplingPlan, DrawsTheWordsOfItsStream) {
  const ResamplingPlan plan = ResamplingPlan::of_rows(50);
  std::vector<std::uint32_t> scratch(50), multiplicity(50), expected(50, 0);
  plan.draw(0x123456789abcdefULL, 7, 0x100000003ULL, scratch, multiplicity);
  table::RandomStream random(0x123456789abcdefULL, 7, 0x100000003ULL);
  for (int k = 0; k < 50; ++k) {
    ++expected[random.below(50)];
  }
  EXPECT_EQ(multiplicity, expected);
}

TEST(ResamplingPlan, DrawsWholeClustersWithinStrata) {
  // Clusters 9 and 4 in stratum 1, cluster 6 alone in stratum 0.
  const std::vector<std::uint32_t> cluster{9, 4, 9, 6, 6, 4, 9};
  const std::vector<std::uint32_t> strata{1, 1, 1, 0, 0, 1, 1};
  const ResamplingPlan plan = ResamplingPlan::of_clusters(cluster, strata);
  ASSERT_EQ(plan.units(), 3U);
  EXPECT_EQ(plan.strata(), 2U);
  EXPECT_EQ(plan.unit_of(0), 2U) << "units are in the order of the codes";
  EXPECT_EQ(plan.stratum_size(0), 2U);
  EXPECT_EQ(plan.stratum_size(1), 1U);
  std::vector<std::uint32_t> scratch(3), multiplicity(7);
  std::map<std::uint32_t, int> seen;
  for (std::uint64_t r = 0; r < 4000; ++r) {
    plan.draw(1, 0, r, scratch, multiplicity);
    EXPECT_EQ(multiplicity[0], multiplicity[2]);
    EXPECT_EQ(multiplicity[0], multiplicity[6]);
    EXPECT_EQ(multiplicity[1], multiplicity[5]);
    EXPECT_EQ(multiplicity[3], 1U) << "the only cluster of its stratum";
    EXPECT_EQ(multiplicity[0] + multiplicity[1], 2U);
    ++seen[multiplicity[0]];
  }
  // Binomial(2, 1/2), within four standard deviations.
  EXPECT_NEAR(seen[0], 1000, 4 * 27.4);
  EXPECT_NEAR(seen[1], 2000, 4 * 31.6);
}

TEST(ResamplingPlan, DrawsEveryRowAlikeOften) {
  const std::size_t n = 7;
  const ResamplingPlan plan = ResamplingPlan::of_rows(n);
  std::vector<std::uint32_t> scratch(n), multiplicity(n);
  std::vector<double> total(n, 0.0);
  constexpr int kReplicates = 20000;
  for (std::uint64_t r = 0; r < kReplicates; ++r) {
    plan.draw(3, 1, r, scratch, multiplicity);
    for (std::size_t k = 0; k < n; ++k) {
      total[k] += multiplicity[k];
    }
  }
  double chi_square = 0.0;
  for (const double count : total) {
    chi_square += (count - kReplicates) * (count - kReplicates) / kReplicates;
  }
  EXPECT_LT(chi_square, 22.46) << "0.999 quantile on 6 degrees of freedom";
}

TEST(ResamplingPlan, RefusesMisuse) {
  const std::vector<std::uint32_t> cluster{1, 1, 2};
  EXPECT_THROW(ResamplingPlan::of_clusters(cluster, std::vector<std::uint32_t>{1, 2, 2}),
               std::invalid_argument);
  EXPECT_THROW(ResamplingPlan::of_clusters(std::vector<std::uint32_t>{1, table::Factor::kMissing}),
               std::invalid_argument);
  EXPECT_THROW(ResamplingPlan::of_rows(0), std::invalid_argument);
  EXPECT_THROW(ResamplingPlan::of_rows(2, std::vector<std::uint32_t>{1}), std::invalid_argument);
}

TEST(Bootstrap, IsTheSameForAnyNumberOfThreads) {
  table::RandomStream random(5, 0, 0);
  std::vector<double> x(200);
  for (double& value : x) {
    value = random.normal();
  }
  const ResamplingPlan plan = ResamplingPlan::of_rows(x.size());
  std::vector<BootstrapResult> results;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(bootstrap(mean_of(x), plan, {2000, 9, 3}));
  }
  for (const BootstrapResult& result : results) {
    EXPECT_EQ(result.replicates, results[0].replicates);
    EXPECT_EQ(result.left_out, results[0].left_out);
  }
  const BootstrapResult fewer = bootstrap(mean_of(x), plan, {500, 9, 3});
  EXPECT_TRUE(std::equal(
      fewer.replicates[0].begin(), fewer.replicates[0].end(), results[0].replicates[0].begin()));
  EXPECT_NE(bootstrap(mean_of(x), plan, {500, 9, 4}).replicates, fewer.replicates);
  EXPECT_NE(bootstrap(mean_of(x), plan, {500, 8, 3}).replicates, fewer.replicates);
}

TEST(Bootstrap, OfAMeanIsAsTheAlgebraSays) {
  // SD of a bootstrap mean: sqrt((n - 1) / n) s / sqrt(n). Influence: (n - 1) (m - m_(-i)) = x - m.
  const std::vector<double> x{1, 2, 4, 8, 16};
  const ResamplingPlan plan = ResamplingPlan::of_rows(5);
  const BootstrapResult result = bootstrap(mean_of(x), plan, {40000, 1, 0});
  EXPECT_EQ(result.observed[0], 6.2);
  const BootstrapEstimate estimate = bootstrap_estimate(result, 0);
  EXPECT_NEAR(estimate.standard_error, std::sqrt(148.8 / 25.0), 0.03);
  EXPECT_NEAR(estimate.bias, 0.0, 0.05);
  double squares = 0.0;
  double cubes = 0.0;
  for (const double value : x) {
    squares += (value - 6.2) * (value - 6.2);
    cubes += (value - 6.2) * (value - 6.2) * (value - 6.2);
  }
  EXPECT_NEAR(result.acceleration[0].value(), cubes / (6.0 * std::pow(squares, 1.5)), 1e-13);
}

TEST(Bootstrap, PairsTheValuesOfJoinedStatistics) {
  const std::vector<double> x{1, 2, 4, 8, 16};
  std::vector<double> y;
  for (const double value : x) {
    y.push_back(value + 0.5);
  }
  const Statistic both = joined({mean_of(x), mean_of(y)});
  ASSERT_EQ(both.values, 2U);
  const ResamplingPlan plan = ResamplingPlan::of_rows(5);
  const BootstrapResult result = bootstrap(both, plan, {300, 1, 0});
  for (std::size_t r = 0; r < 300; ++r) {
    EXPECT_NEAR(result.replicates[1][r] - result.replicates[0][r], 0.5, 1e-13);
  }
  EXPECT_EQ(result.left_out[0], leave_one_out(mean_of(x), plan)[0]);
  EXPECT_THROW(joined({mean_of(x), mean_of({1, 2})}), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(bootstrap(both, ResamplingPlan::of_rows(4))),
               std::invalid_argument);
}

TEST(Jackknife, UsesTheSizeOfTheStratum) {
  const std::vector<std::uint32_t> strata{0, 0, 0, 1, 1};
  const ResamplingPlan plan = ResamplingPlan::of_rows(5, strata);
  const std::vector<double> L =
      jackknife_influence(plan, 1.0, std::vector<double>{0.5, 1.0, 2.0, 0.0, 3.0});
  EXPECT_EQ(L, (std::vector<double>{1.0, 0.0, -2.0, 1.0, -2.0}));
  const std::vector<double> centred =
      jackknife_influence(plan, 1.0, std::vector<double>{0.5, 1.0, 2.0, 0.0, 3.0}, true);
  EXPECT_NEAR(centred[0], 1.0 + 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(centred[3], 1.5, 1e-15);
  EXPECT_FALSE(acceleration(std::vector<double>{0.0, 0.0}).has_value());
  EXPECT_FALSE(acceleration(std::vector<double>{1.0, kNan}).has_value());
}

TEST(BootstrapInterval, ReadsOrderStatisticsByHand) {
  // 99 replicates 1, ..., 99: rank 100 alpha. At level 0.9 the ranks are 5 and 95.
  std::vector<double> t;
  for (int k = 99; k >= 1; --k) {
    t.push_back(k);
  }
  const BootstrapDistribution d = bootstrap_distribution(t, 50.5);
  EXPECT_EQ(d.below, 50U);
  const BootstrapInterval percentile = bootstrap_interval(d, BootstrapMethod::percentile, {}, 0.90);
  EXPECT_NEAR(percentile.interval->low, 5.0, 1e-12);
  EXPECT_NEAR(percentile.interval->high, 95.0, 1e-12);
  EXPECT_NEAR(percentile.low_rank, 5.0, 1e-12);
  const BootstrapInterval basic = bootstrap_interval(d, BootstrapMethod::basic, {}, 0.90);
  EXPECT_NEAR(basic.interval->low, 6.0, 1e-12);
  EXPECT_NEAR(basic.interval->high, 96.0, 1e-12);
  // Between order statistics: on the scale of normal quantiles.
  const BootstrapInterval between = bootstrap_interval(d, BootstrapMethod::percentile, {}, 0.95);
  const double part =
      (-1.959963984540054 + 2.053748910631823) / (-1.880793608151251 + 2.053748910631823);
  EXPECT_NEAR(between.interval->low, 2.0 + part, 1e-12);
}

TEST(BootstrapInterval, ExpandedPercentilesAreHesterbergs) {
  // R: pnorm(-sqrt(G / (G - 1)) * qt(0.975, G - 1)).
  EXPECT_NEAR(expanded_tail(0.95, 10), 8.550639024406370e-03, 1e-14);
  EXPECT_NEAR(expanded_tail(0.95, 22), 1.664564557193027e-02, 1e-14);
  EXPECT_NEAR(expanded_tail(0.95, 660), 2.470367319624876e-02, 1e-14);
  EXPECT_NEAR(expanded_tail(0.90, 22), 0.03909919036433189, 1e-14);
  // R: boot:::norm.inter(sin(1:999) + (1:999) / 500, c(tail, 1 - tail)), 22 units.
  std::vector<double> t;
  for (int k = 1; k <= 999; ++k) {
    t.push_back(std::sin(k) + k / 500.0);
  }
  const BootstrapDistribution d = bootstrap_distribution(t, 1.0);
  const auto expanded = bootstrap_interval(d, BootstrapMethod::expanded, {}, 0.95, 22).interval;
  EXPECT_NEAR(expanded->low, -0.7610204666454972, 1e-12);
  EXPECT_NEAR(expanded->high, 2.7608718869630646, 1e-12);
  const auto percentile = bootstrap_interval(d, BootstrapMethod::percentile).interval;
  EXPECT_LT(expanded->low, percentile->low);
  EXPECT_GT(expanded->high, percentile->high);
  EXPECT_THROW(static_cast<void>(bootstrap_interval(d, BootstrapMethod::expanded, {}, 0.95, 1)),
               std::invalid_argument);
}

TEST(BootstrapInterval, OfUnbiasedAndUnskewedReplicatesIsThePercentileOne) {
  std::vector<double> t;
  for (int k = 1; k <= 100; ++k) {
    t.push_back(k);
  }
  const BootstrapDistribution d = bootstrap_distribution(t, 50.5);
  const auto bca = bootstrap_interval(d, BootstrapMethod::bca, 0.0, 0.9).interval;
  const auto percentile = bootstrap_interval(d, BootstrapMethod::percentile, {}, 0.9).interval;
  EXPECT_NEAR(bca->low, percentile->low, 1e-10);
  EXPECT_NEAR(bca->high, percentile->high, 1e-10);
}

TEST(BootstrapInterval, NamesWhatIsWrongWithTheReplicates) {
  const auto interval = [](const std::vector<double>& t, double observed, double level = 0.95) {
    return bootstrap_interval(
        bootstrap_distribution(t, observed), BootstrapMethod::bca, 0.1, level);
  };
  const BootstrapInterval constant = interval(std::vector<double>(20, 0.5), 0.5);
  EXPECT_FALSE(constant.interval.has_value());
  EXPECT_TRUE(has(constant.conditions, ConditionKind::constant_replicates));

  const BootstrapInterval one_sided = interval({1, 2, 3, 4}, 0.5);
  EXPECT_FALSE(one_sided.interval.has_value());
  EXPECT_TRUE(has(one_sided.conditions, ConditionKind::infinite_bias));

  const BootstrapInterval failed = interval({1, kNan, 2, 3, 4}, 2.5, 0.1);
  EXPECT_TRUE(failed.interval.has_value());
  ASSERT_TRUE(has(failed.conditions, ConditionKind::failed_replicates));
  EXPECT_EQ(failed.conditions[0].detail, "1 of 5");

  const BootstrapInterval extreme = interval({1, 2, 3, 4}, 2.5);
  EXPECT_EQ(extreme.interval->low, 1.0);
  EXPECT_EQ(extreme.interval->high, 4.0);
  EXPECT_TRUE(has(extreme.conditions, ConditionKind::endpoint_out_of_range));

  EXPECT_TRUE(has_error(interval({1, 2, 3}, kNan).conditions));
  EXPECT_TRUE(has(interval({kNan, kNan}, 1.0).conditions, ConditionKind::failed_replicates));

  const BootstrapDistribution d = bootstrap_distribution(std::vector<double>{1, 2, 3, 4}, 2.5);
  EXPECT_TRUE(has(bootstrap_interval(d, BootstrapMethod::bca, {}, 0.9).conditions,
                  ConditionKind::no_acceleration));
  EXPECT_TRUE(has(bootstrap_interval(d, BootstrapMethod::bca, 2.0, 0.9).conditions,
                  ConditionKind::no_acceleration));
  EXPECT_THROW(static_cast<void>(bootstrap_interval(d, BootstrapMethod::basic, {}, 1.0)),
               std::invalid_argument);
}

TEST(Bootstrap, UnitsOfAValueMayBeFewerThanThoseDrawn) {
  std::vector<double> values;
  table::RandomStream random(3, 1, 0);
  for (int i = 0; i < 22; ++i) {
    values.push_back(random.normal());
  }
  BootstrapOptions options;
  options.replicates = 999;
  const BootstrapResult result = bootstrap(mean_of(values), ResamplingPlan::of_rows(22), options);
  // Expanded percentiles of G units are percentiles of a higher level.
  EXPECT_NEAR(expanded_tail(0.95, 10), 0.00855, 1e-4);
  EXPECT_NEAR(expanded_tail(0.95, 22), 0.0166, 1e-4);
  const BootstrapIntervals of_ten = bootstrap_intervals(result, 0, 0.95, 10);
  const BootstrapIntervals wider =
      bootstrap_intervals(result, 0, 1.0 - 2.0 * expanded_tail(0.95, 10));
  EXPECT_NEAR(of_ten.expanded->low, wider.percentile->low, 1e-9);
  EXPECT_NEAR(of_ten.expanded->high, wider.percentile->high, 1e-9);
  EXPECT_FALSE(bootstrap_intervals(result, 0, 0.95, 1).expanded);
  EXPECT_TRUE(bootstrap_intervals(result, 0, 0.95, 1).percentile);
}

TEST(Bootstrap, SaysWhyBcaAloneHasNoInterval) {
  BootstrapResult result;
  result.units = 12;
  result.observed = {0.0, 5.0};
  result.replicates = {{}, {}};
  for (int r = 1; r <= 199; ++r) {
    result.replicates[0].push_back(r);  // all above what was observed
    result.replicates[1].push_back(r % 11);
  }
  result.acceleration = {0.01, 0.01};
  const BootstrapIntervals none = bootstrap_intervals(result, 0);
  EXPECT_TRUE(none.expanded && none.percentile);
  EXPECT_FALSE(none.bca);
  EXPECT_EQ(none.no_bca.value().kind, ConditionKind::infinite_bias);
  EXPECT_FALSE(bootstrap_intervals(result, 1).no_bca);
  EXPECT_TRUE(bootstrap_intervals(result, 1).bca);
}

TEST(Bootstrap, TellsOfEachReplicateAndIsTheSameWatchedOrNot) {
  const Statistic mean = mean_of({1.0, 2.0, 4.0, 8.0});
  const ResamplingPlan plan = ResamplingPlan::of_rows(4);
  BootstrapOptions options;
  options.replicates = 500;
  const BootstrapResult alone = bootstrap(mean, plan, options);
  std::atomic<std::size_t> told = 0;
  options.advance = [&] { ++told; };
  const BootstrapResult watched = bootstrap(mean, plan, options);
  EXPECT_EQ(told, 500U);
  EXPECT_EQ(watched.replicates, alone.replicates);
}

}  // namespace
}  // namespace tcert::statistics
