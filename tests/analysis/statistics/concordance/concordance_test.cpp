#include <statistics/concordance/concordance.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

ConcordanceResult one(const SurvivalOutcome& outcome,
                      const std::vector<double>& x,
                      const ConcordanceOptions& options = {}) {
  return concordance(outcome, std::vector<Predictor>{{"x", x}}, options);
}

TEST(Concordance, CountsPairsByHand) {
  // Times 1, 2, 2+, 3 (+ is censored) with x = 1, 3, 2, 2. Comparable: (1,2), (1,2+), (1,3) are
  // concordant as x rises; (2,2+) since the censored row outlives it, discordant; (2,3) discordant.
  // C = 3/5. Row by row concordant minus discordant: 3, 1-2, 1-1, 1-1, pairs 3, 3, 2, 2, and
  // dfbeta = (difference - (3-2)/5 pairs) / 5 / 2.
  const SurvivalOutcome outcome{{}, {1, 2, 2, 3}, {1, 1, 0, 1}};
  const ConcordanceResult result = one(outcome, {1, 3, 2, 2});
  const ConcordanceEstimate& estimate = result.estimates[0];
  EXPECT_EQ(estimate.counts.concordant, 3.0);
  EXPECT_EQ(estimate.counts.discordant, 2.0);
  EXPECT_EQ(estimate.counts.tied_x, 0.0);
  EXPECT_EQ(estimate.c, 0.6);
  EXPECT_EQ(result.events, 3U);
  const std::vector<double> expected{0.24, -0.16, -0.04, -0.04};
  double variance = 0.0;
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_NEAR(estimate.dfbeta[row], expected[row], 1e-15);
    variance += expected[row] * expected[row];
  }
  EXPECT_NEAR(estimate.variance.value(), variance, 1e-15);
}

TEST(Concordance, CountsTiesByHand) {
  // Three events at 1 with x = 1, 1, 2; one row later with x = 1.
  const SurvivalOutcome outcome{{}, {1, 1, 1, 4}, {1, 1, 1, 0}};
  const ConcordanceEstimate estimate = one(outcome, {1, 1, 2, 1}).estimates[0];
  EXPECT_EQ(estimate.counts.tied_x, 2.0);
  EXPECT_EQ(estimate.counts.discordant, 1.0);
  EXPECT_EQ(estimate.counts.tied_xy, 1.0);
  EXPECT_EQ(estimate.counts.tied_y, 2.0);
  EXPECT_DOUBLE_EQ(*estimate.c, 1.0 / 3.0);
}

TEST(Concordance, TurnsOverWithTheDirectionAndNeverByItself) {
  const SurvivalOutcome outcome{{}, {1, 2, 3, 4}, {1, 1, 0, 1}};
  const std::vector<double> x{4, 3, 1, 2};
  const ConcordanceResult result = concordance(
      outcome, std::vector<Predictor>{{"as risk", x, LargerMeans::shorter_time}, {"as time", x}});
  EXPECT_EQ(result.estimates[0].c, 1.0);
  EXPECT_EQ(result.estimates[1].c, 0.0);
  EXPECT_TRUE(has(result.estimates[0].conditions, ConditionKind::separated));
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_EQ(result.estimates[0].dfbeta[row], -result.estimates[1].dfbeta[row]);
  }
}

TEST(Concordance, LeavesOutRowsThatMissAPredictor) {
  const SurvivalOutcome outcome{{}, {1, 2, 3, 4, 5}, {1, 1, 1, 1, 1}};
  const std::vector<double> a{1, kNan, 2, 3, 4};
  const std::vector<double> b{1, 5, 2, kNan, kInf};
  const ConcordanceResult result = concordance(outcome, std::vector<Predictor>{{"a", a}, {"b", b}});
  EXPECT_EQ(result.missing, 2U);
  EXPECT_EQ(result.rows, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(result.estimates[0].counts.comparable(), 3.0);
  EXPECT_TRUE(has(result.differences[0].conditions, ConditionKind::same_ranking));
  EXPECT_EQ(result.differences[0].p_value, 1.0);
}

TEST(Concordance, NamesWhatItCannotEstimate) {
  const ConcordanceResult none = one({{}, {}, {}}, {});
  EXPECT_TRUE(has(none.conditions, ConditionKind::no_rows));
  EXPECT_FALSE(none.estimates[0].c.has_value());

  const ConcordanceResult single = one({{}, {1}, {1}}, {1});
  EXPECT_TRUE(has(single.conditions, ConditionKind::too_few_rows));
  EXPECT_TRUE(has(single.estimates[0].conditions, ConditionKind::no_comparable_pairs));
  EXPECT_FALSE(single.estimates[0].c.has_value());
  EXPECT_FALSE(single.estimates[0].variance.has_value());
  EXPECT_TRUE(std::isnan(single.covariance(0, 0)));

  const ConcordanceResult censored = one({{}, {1, 2}, {0, 0}}, {1, 2});
  EXPECT_TRUE(has(censored.conditions, ConditionKind::no_events));
  EXPECT_FALSE(censored.estimates[0].c.has_value());

  const ConcordanceResult tied = one({{}, {1, 2, 3}, {1, 1, 1}}, {7, 7, 7});
  EXPECT_EQ(tied.estimates[0].c, 0.5);
  EXPECT_EQ(tied.estimates[0].variance, 0.0);
  EXPECT_EQ(tied.estimates[0].null_variance, 0.0);
  EXPECT_TRUE(has(tied.estimates[0].conditions, ConditionKind::all_tied));
}

TEST(Concordance, HasNoVarianceForOneCluster) {
  const table::Factor day{{0, 0, 0}, {"mon"}};
  ConcordanceOptions options;
  options.cluster = &day;
  const ConcordanceResult result = one({{}, {1, 2, 3}, {1, 1, 1}}, {1, 3, 2}, options);
  EXPECT_TRUE(result.estimates[0].c.has_value());
  EXPECT_FALSE(result.estimates[0].variance.has_value());
  EXPECT_TRUE(has(result.conditions, ConditionKind::one_cluster));
}

TEST(Concordance, RefusesMisuse) {
  const SurvivalOutcome outcome{{}, {1, 2}, {1, 1}};
  const auto run = [](const SurvivalOutcome& rows,
                      const std::vector<double>& x,
                      const ConcordanceOptions& options) {
    static_cast<void>(one(rows, x, options));
  };
  EXPECT_THROW(run(outcome, {1}, {}), std::invalid_argument);
  EXPECT_THROW(run({{2, 1}, {1, 2}, {1, 1}}, {1, 2}, {}), std::invalid_argument);
  EXPECT_THROW(run({{}, {1, kNan}, {1, 1}}, {1, 2}, {}), std::invalid_argument);
  EXPECT_THROW(run({{}, {1, 2}, {1, 2}}, {1, 2}, {}), std::invalid_argument);
  const std::vector<double> negative{1, -1};
  ConcordanceOptions options;
  options.weights = negative;
  EXPECT_THROW(run(outcome, {1, 2}, options), std::invalid_argument);
  options = {};
  options.level = 1.0;
  EXPECT_THROW(run(outcome, {1, 2}, options), std::invalid_argument);
  options = {};
  options.earliest = 1.5;
  EXPECT_THROW(run({{}, {1, 2}, {0, 1}}, {1, 2}, options), std::invalid_argument);
  EXPECT_NO_THROW(run(outcome, {1, 2}, options));
}

TEST(Concordance, TakesALandmarkForNoTruncation) {
  const SurvivalOutcome plain{{}, {16, 20, 31, 40}, {1, 0, 1, 1}};
  SurvivalOutcome landmark = plain;
  landmark.start.assign(4, 15.0);
  ConcordanceOptions options;
  options.pair_weight = PairWeight::inverse_censoring_squared;
  const std::vector<double> x{3, 1, 2, 2};
  EXPECT_EQ(one(landmark, x, options).estimates[0].variance,
            one(plain, x, options).estimates[0].variance);
}

/// Random rows with many ties.
struct Case {
  SurvivalOutcome outcome;
  std::vector<double> x;
  std::vector<double> weights;
  table::Factor strata;
};

Case random_case(std::uint64_t index, std::size_t n, bool truncated) {
  table::RandomStream random(7, 1, index);
  Case rows;
  rows.strata.levels = {"a", "b", "c"};
  for (std::size_t row = 0; row < n; ++row) {
    const double start = random.below(6);
    rows.outcome.start.push_back(start);
    rows.outcome.stop.push_back(start + 1.0 + random.below(9));
    rows.outcome.event.push_back(random.below(3) == 0 ? 0 : 1);
    rows.x.push_back(random.below(8));
    rows.weights.push_back(static_cast<double>(random.below(5)) / (index % 3 == 0 ? 1.0 : 2.0));
    rows.strata.codes.push_back(random.below(3));
  }
  if (!truncated) {
    rows.outcome.start.clear();
  }
  return rows;
}

/// The definition, pair by pair.
struct Pairs {
  ConcordanceCounts counts;
  std::vector<RowPairs> rows;
};

double pair_weight(const Case& rows, PairWeight kind, std::size_t i) {
  const auto& [start, stop, event] = rows.outcome;
  const auto same = [&](std::size_t j) { return rows.strata.codes[j] == rows.strata.codes[i]; };
  const auto at_risk = [&](double time, bool after_events) {
    double sum = 0.0;
    for (std::size_t j = 0; j < stop.size(); ++j) {
      const bool dead = after_events && event[j] == 1 && stop[j] == time;
      if (same(j) && stop[j] >= time && (start.empty() || start[j] < time) && !dead) {
        sum += rows.weights[j];
      }
    }
    return sum;
  };
  double all = 0.0;
  std::vector<double> times;
  for (std::size_t j = 0; j < stop.size(); ++j) {
    if (same(j)) {
      all += rows.weights[j];
      times.push_back(stop[j]);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  double survival = 1.0;
  double free = 1.0;
  for (const double time : times) {
    if (time >= stop[i]) {
      break;
    }
    double dead = 0.0;
    double lost = 0.0;
    for (std::size_t j = 0; j < stop.size(); ++j) {
      if (same(j) && stop[j] == time) {
        (event[j] == 1 ? dead : lost) += rows.weights[j];
      }
    }
    if (dead > 0.0) {
      survival *= 1.0 - dead / at_risk(time, false);
    }
    if (lost > 0.0) {
      free *= 1.0 - lost / at_risk(time, true);
    }
  }
  const double n = at_risk(stop[i], false);
  switch (kind) {
    case PairWeight::equal:
      break;
    case PairWeight::survival:
      return all * survival / n;
    case PairWeight::survival_by_censoring:
      return all * survival / (free * n);
    case PairWeight::inverse_censoring_squared:
      return 1.0 / (free * free);
    case PairWeight::inverse_at_risk:
      return 1.0 / n;
  }
  return 1.0;
}

Pairs pair_by_pair(const Case& rows, PairWeight kind) {
  const auto& [start, stop, event] = rows.outcome;
  const std::vector<double>& x = rows.x;
  Pairs pairs;
  pairs.rows.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (event[i] == 0 || rows.weights[i] == 0.0) {
      continue;
    }
    const double weight = pair_weight(rows, kind, i);
    for (std::size_t j = 0; j < x.size(); ++j) {
      const bool outlives = stop[j] > stop[i] || (stop[j] == stop[i] && event[j] == 0);
      const bool both = j > i && event[j] == 1 && stop[j] == stop[i];
      if (rows.strata.codes[j] != rows.strata.codes[i] || (!outlives && !both) ||
          (!start.empty() && start[j] >= stop[i])) {
        continue;
      }
      double ConcordanceCounts::*kind_of_pair = &ConcordanceCounts::tied_x;
      double net = 0.0;
      if (both) {
        kind_of_pair = x[i] == x[j] ? &ConcordanceCounts::tied_xy : &ConcordanceCounts::tied_y;
      } else if (x[i] != x[j]) {
        net = x[i] < x[j] ? 1.0 : -1.0;
        kind_of_pair = net > 0.0 ? &ConcordanceCounts::concordant : &ConcordanceCounts::discordant;
      }
      pairs.counts.*kind_of_pair += weight * rows.weights[i] * rows.weights[j];
      pairs.rows[i].net += weight * rows.weights[j] * net;
      pairs.rows[j].net += weight * rows.weights[i] * net;
      pairs.rows[i].comparable += both ? 0.0 : weight * rows.weights[j];
      pairs.rows[j].comparable += both ? 0.0 : weight * rows.weights[i];
    }
  }
  return pairs;
}

void expect_near(double actual, double expected) {
  EXPECT_NEAR(actual, expected, 1e-11 * (1.0 + std::abs(expected)));
}

void expect_near(const ConcordanceCounts& actual, const ConcordanceCounts& expected) {
  expect_near(actual.concordant, expected.concordant);
  expect_near(actual.discordant, expected.discordant);
  expect_near(actual.tied_x, expected.tied_x);
  expect_near(actual.tied_y, expected.tied_y);
  expect_near(actual.tied_xy, expected.tied_xy);
}

TEST(Concordance, EqualsItsDefinitionPairByPair) {
  for (std::uint64_t index = 0; index < 60; ++index) {
    const bool truncated = index % 2 == 0;
    const Case rows = random_case(index, 5 + 2 * index, truncated);
    for (const PairWeight kind : {PairWeight::equal,
                                  PairWeight::survival,
                                  PairWeight::survival_by_censoring,
                                  PairWeight::inverse_censoring_squared,
                                  PairWeight::inverse_at_risk}) {
      ConcordanceOptions options;
      options.weights = rows.weights;
      options.strata = &rows.strata;
      options.pair_weight = kind;
      if (truncated && (kind == PairWeight::survival_by_censoring ||
                        kind == PairWeight::inverse_censoring_squared)) {
        EXPECT_THROW(static_cast<void>(one(rows.outcome, rows.x, options)), std::invalid_argument);
        continue;
      }
      const TimeOrder order = time_order(rows.outcome, rows.strata.codes, 3);
      const ConcordancePairs counted =
          concordance_pairs({&order, &rows.outcome, rows.weights, kind}, rows.x);
      const Pairs pairs = pair_by_pair(rows, kind);
      expect_near(counted.total(), pairs.counts);
      EXPECT_EQ(one(rows.outcome, rows.x, options).estimates[0].counts.concordant,
                counted.total().concordant);
      for (std::size_t row = 0; row < rows.x.size(); ++row) {
        const bool event_without_weight = rows.weights[row] == 0.0 && rows.outcome.event[row] == 1;
        if (!event_without_weight) {  // the loop above leaves its pairs out
          expect_near(counted.rows[row].net, pairs.rows[row].net);
          expect_near(counted.rows[row].comparable, pairs.rows[row].comparable);
        }
      }
    }
  }
}

TEST(Concordance, RowsThatEnterWhenAllEventsAreOverCountNothing) {
  // R 4.2.2: concordance(Surv(start, stop, e) ~ x) has a standard error of 0.3535534, all of it
  // from the first three rows.
  const SurvivalOutcome outcome{{0, 0, 0, 2, 2}, {1, 3, 3, 4, 4}, {1, 0, 0, 0, 0}};
  const ConcordanceEstimate estimate = one(outcome, {1, 2, 0, 0, 0}).estimates[0];
  EXPECT_NEAR(std::sqrt(estimate.variance.value()), std::sqrt(0.125), 1e-14);
  EXPECT_EQ(estimate.dfbeta[3], 0.0);
}

TEST(Concordance, DfbetaIsTheDerivativeByTheWeightWithLateEntry) {
  constexpr double kStep = 1e-4;
  std::size_t cases = 0;
  for (std::uint64_t index = 0; index < 300; ++index) {
    table::RandomStream random(19, 1, index);
    SurvivalOutcome outcome;
    std::vector<double> x;
    for (std::size_t row = 0; row < 4 + index % 7; ++row) {
      const double start = random.below(6);
      outcome.start.push_back(start);
      outcome.stop.push_back(start + 1.0 + random.below(4));
      outcome.event.push_back(random.below(2) == 0 ? 0 : 1);
      x.push_back(random.below(3));
    }
    const auto c_of = [&](const std::vector<double>& weights) {
      const TimeOrder order = time_order(outcome, {}, 1);
      return concordance_index(
          concordance_pairs({&order, &outcome, weights, PairWeight::equal}, x).total());
    };
    const ConcordanceEstimate estimate = one(outcome, x).estimates[0];
    if (!estimate.c) {
      continue;
    }
    ++cases;
    for (std::size_t row = 0; row < x.size(); ++row) {
      std::vector<double> more(x.size(), 1.0);
      std::vector<double> less = more;
      more[row] += kStep;
      less[row] -= kStep;
      EXPECT_NEAR(estimate.dfbeta[row], (c_of(more) - c_of(less)) / (2.0 * kStep), 1e-6)
          << "case " << index << ", row " << row;
    }
  }
  EXPECT_GT(cases, 150U);
}

TEST(Concordance, DoesNotDependOnTheOrderOfRows) {
  const Case rows = random_case(3, 25'000, false);
  Case turned = rows;
  std::reverse(turned.outcome.stop.begin(), turned.outcome.stop.end());
  std::reverse(turned.outcome.event.begin(), turned.outcome.event.end());
  std::reverse(turned.x.begin(), turned.x.end());
  const ConcordanceEstimate a = one(rows.outcome, rows.x).estimates[0];
  const ConcordanceEstimate b = one(turned.outcome, turned.x).estimates[0];
  EXPECT_EQ(a.c, b.c);
  EXPECT_EQ(a.counts.tied_y, b.counts.tied_y);
  EXPECT_NEAR(*a.variance, *b.variance, 1e-12 * *a.variance);
  for (std::size_t row = 0; row < rows.x.size(); ++row) {
    ASSERT_EQ(a.dfbeta[row], b.dfbeta[rows.x.size() - 1 - row]);
  }
}

TEST(Concordance, ComparesPredictorsAsTheirDfbetasSay) {
  const Case rows = random_case(5, 300, true);
  table::RandomStream random(8, 1, 5);
  std::vector<double> other;
  for (const double x : rows.x) {
    other.push_back(x + random.normal());
  }
  ConcordanceOptions options;
  options.cluster = &rows.strata;
  const ConcordanceResult result =
      concordance(rows.outcome, std::vector<Predictor>{{"x", rows.x}, {"y", other}}, options);
  const double variance =
      result.covariance(0, 0) + result.covariance(1, 1) - 2.0 * result.covariance(0, 1);
  const ConcordanceDifference& difference = result.differences[0];
  EXPECT_NEAR(difference.variance.value(), variance, 1e-14);
  EXPECT_NEAR(difference.z.value(), *difference.difference / std::sqrt(variance), 1e-8);
  EXPECT_EQ(result.clusters, 3U);
  EXPECT_TRUE(has(result.conditions, ConditionKind::few_clusters));
}

}  // namespace
}  // namespace tcert::statistics
