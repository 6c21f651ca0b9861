#include <statistics/equivalence/scores_by_group.hpp>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
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

Trials trials(std::size_t n, std::uint32_t groups, std::uint32_t days, bool nested = false) {
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
    made.group.codes.push_back(nested ? day % groups : random.below(groups));
    made.success.push_back(random.uniform() < 1.0 / (1.0 + std::exp(-x)) ? 1 : 0);
    made.time.stop.push_back(std::round(20.0 * random.uniform() + 5.0 - x));
    made.time.event.push_back(made.success.back());
  }
  round_times(made.time);
  return made;
}

/// Components of DeLong by definition, summed within days.
Eigen::VectorXd slow_influence(const Trials& t, std::uint32_t group, double auc) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(t.day.levels.size()));
  std::vector<std::size_t> good;
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < t.x.size(); ++i) {
    if (t.group.codes[i] == group) {
      (t.success[i] != 0 ? good : bad).push_back(i);
    }
  }
  const auto wins = [&](std::size_t i, std::size_t j) {
    return t.x[i] > t.x[j] ? 1.0 : (t.x[i] == t.x[j] ? 0.5 : 0.0);
  };
  const auto m = static_cast<double>(good.size());
  const auto n = static_cast<double>(bad.size());
  for (const std::size_t i : good) {
    double share = 0.0;
    for (const std::size_t j : bad) {
      share += wins(i, j) / n;
    }
    sums[t.day.codes[i]] += (share - auc) / m;
  }
  for (const std::size_t j : bad) {
    double share = 0.0;
    for (const std::size_t i : good) {
      share += wins(i, j) / m;
    }
    sums[t.day.codes[j]] += (share - auc) / n;
  }
  return sums;
}

TEST(AucByGroup, CovariancesAreThoseOfTheDefinition) {
  const Trials t = trials(300, 3, 12);
  const ScoresByGroup scores =
      auc_by_group({t.x, HigherMeans::success}, t.success, t.group, t.day.codes);
  ASSERT_TRUE(scores.joint.has_value());
  const Eigen::MatrixXd& covariance = scores.joint->covariance;
  const double factor = 12.0 / 11.0;  // every group has every day
  for (std::uint32_t g = 0; g < 3; ++g) {
    for (std::uint32_t h = g + 1; h < 3; ++h) {
      const double expected = factor * slow_influence(t, g, *scores.groups[g].value)
                                           .dot(slow_influence(t, h, *scores.groups[h].value));
      EXPECT_NEAR(covariance(g, h), expected, 1e-15);
      EXPECT_EQ(covariance(h, g), covariance(g, h));
    }
  }
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(covariance).eigenvalues().minCoeff(),
            0.0);
}

TEST(AucByGroup, AGroupByItselfIsItsClusteredDeLong) {
  const Trials t = trials(200, 2, 9);
  const ScoresByGroup scores =
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
  EXPECT_EQ(*scores.groups[1].value, *alone.auc);
  EXPECT_NEAR(scores.joint->covariance(1, 1), *alone.variance, 1e-16);
}

TEST(AucByGroup, GroupsThatShareNoClusterAreIndependent) {
  const Trials t = trials(300, 3, 12, true);
  const ScoresByGroup auc =
      auc_by_group({t.x, HigherMeans::success}, t.success, t.group, t.day.codes);
  const ScoresByGroup c =
      concordance_by_group(t.time, {"x", t.x, LargerMeans::shorter_time}, t.group, t.day);
  for (const ScoresByGroup* scores : {&auc, &c}) {
    EXPECT_EQ(scores->joint.value().covariance(0, 1), 0.0);
    EXPECT_EQ(scores->joint->covariance(1, 2), 0.0);
    EXPECT_GT(scores->joint->covariance(2, 2), 0.0);
  }
}

TEST(AucByGroup, TheSameTrialsTwiceAreWhollyDependent) {
  Trials t = trials(150, 1, 10);
  const std::size_t n = t.x.size();
  t.group.levels = {"a", "b"};
  for (std::size_t i = 0; i < n; ++i) {
    t.x.push_back(t.x[i]);
    t.success.push_back(t.success[i]);
    t.day.codes.push_back(t.day.codes[i]);
    t.group.codes.push_back(1);
    t.time.stop.push_back(t.time.stop[i]);
    t.time.event.push_back(t.time.event[i]);
  }
  const ScoresByGroup c =
      concordance_by_group(t.time, {"x", t.x, LargerMeans::shorter_time}, t.group, t.day);
  const Eigen::MatrixXd& covariance = c.joint.value().covariance;
  EXPECT_NEAR(covariance(0, 1), covariance(0, 0), 1e-12 * covariance(0, 0));
}

TEST(ConcordanceByGroup, CovariancesAreProductsOfDfbetas) {
  const Trials t = trials(300, 2, 10);
  const Predictor predictor{"x", t.x, LargerMeans::shorter_time};
  const ScoresByGroup scores = concordance_by_group(t.time, predictor, t.group, t.day);
  // Both groups as strata of one C, by the definition of the infinitesimal jackknife: a numerical
  // derivative by the weight of each day.
  const auto c_of = [&](std::uint32_t group, std::uint32_t day, double weight) {
    std::vector<double> weights(t.x.size(), 0.0);
    for (std::size_t i = 0; i < t.x.size(); ++i) {
      weights[i] = t.group.codes[i] != group ? 0.0 : (t.day.codes[i] == day ? weight : 1.0);
    }
    ConcordanceOptions options;
    options.weights = weights;
    return *concordance(t.time, {&predictor, 1}, options).estimates[0].c;
  };
  double expected = 0.0;
  for (std::uint32_t day = 0; day < 10; ++day) {
    const double h = 1e-5;
    const auto slope = [&](std::uint32_t group) {
      return (c_of(group, day, 1.0 + h) - c_of(group, day, 1.0 - h)) / (2.0 * h);
    };
    expected += slope(0) * slope(1);
  }
  EXPECT_NEAR(scores.joint.value().covariance(0, 1), expected, 1e-9);
}

TEST(ScoresByGroup, AGroupWithoutAnEstimateLeavesNoJointOne) {
  Trials t = trials(120, 2, 6);
  for (std::size_t i = 0; i < t.x.size(); ++i) {
    t.success[i] = t.group.codes[i] == 0 ? 1 : t.success[i];
  }
  const ScoresByGroup scores =
      auc_by_group({t.x, HigherMeans::success}, t.success, t.group, t.day.codes);
  EXPECT_FALSE(scores.joint.has_value());
  EXPECT_TRUE(has(scores.groups[0].conditions, ConditionKind::one_class));
  EXPECT_TRUE(scores.groups[1].value.has_value());
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
  const ScoresByGroup auc = auc_by_group(score, t.success, t.group, t.day.codes);
  const ScoresByGroup c = concordance_by_group(t.time, predictor, t.group, t.day);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_EQ(values[2 * g], *auc.groups[g].value);
    EXPECT_EQ(values[2 * g + 1], *c.groups[g].value);
  }
  const double range = range_of(whole, 0, 3)()(t.group.codes);
  EXPECT_EQ(range, auc.joint->values.maxCoeff() - auc.joint->values.minCoeff());
  EXPECT_TRUE(std::isnan(range_of(whole, 0, 4)()(t.group.codes)));
}

}  // namespace
}  // namespace tcert::statistics
