#include "analysis/study/gate/even_chance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <statistics/basics/normal.hpp>
#include <stdexcept>
#include <vector>

#include "analysis/study/gate/gate_study.hpp"
#include "analysis/study/gate/profile_point.hpp"

namespace tcert::study {
namespace {

const std::vector<double> kMargins{-0.035, -0.031, -0.028, -0.022, -0.018, -0.015, -0.011,
                                   -0.008, -0.004, -0.001, 0.002,  0.004,  0.007,  0.011,
                                   0.014,  0.018,  0.021,  0.027,  0.03,   0.036};
const std::vector<std::uint8_t> kPassed{0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 1, 1, 1};

double relative(double found, double expected) { return std::abs(found / expected - 1.0); }

TEST(EvenChance, AgreesWithR) {
  EvenChanceOptions options;
  options.replicates = 0;
  const EvenChance found = even_chance(kMargins, kPassed, options);
  // glm(y ~ x, binomial) at epsilon 1e-15; the ends are roots by uniroot to 1e-12.
  EXPECT_LT(relative(found.intercept.value(), 0.368100678533631), 1e-10);
  EXPECT_LT(relative(found.slope.value(), 98.723931493440276), 1e-10);
  EXPECT_LT(relative(found.intercept_std_error.value(), 0.609443614144355), 1e-9);
  EXPECT_LT(relative(found.slope_std_error.value(), 42.462473661914885), 1e-9);
  EXPECT_LT(relative(found.slope_profile.value().low, 31.9411881991005), 1e-9);
  EXPECT_LT(relative(found.slope_profile.value().high, 207.8126459653655), 1e-9);
  EXPECT_LT(relative(found.point.value(), -0.00372858609827638), 1e-10);
  EXPECT_EQ(found.fieller.kind, ConfidenceSetKind::bounded);
  EXPECT_LT(relative(found.fieller.low, -0.0290073648180992), 1e-9);
  EXPECT_LT(relative(found.fieller.high, 0.0157857901484720), 1e-9);
  EXPECT_EQ(found.profile.kind, ConfidenceSetKind::bounded);
  EXPECT_LT(relative(found.profile.low, -0.01956830356428934), 1e-9);
  EXPECT_LT(relative(found.profile.high, 0.00979459010690725), 1e-9);
  EXPECT_TRUE(found.fieller.covers(0.0));
  EXPECT_EQ(found.bca.kind, ConfidenceSetKind::unknown) << "no bootstrap was asked for";
}

TEST(EvenChance, TheBootstrapIsPairedWithTheSeed) {
  EvenChanceOptions options;
  options.replicates = 400;
  const EvenChance one = even_chance(kMargins, kPassed, options);
  const EvenChance again = even_chance(kMargins, kPassed, options);
  ASSERT_EQ(one.percentile.kind, ConfidenceSetKind::bounded);
  EXPECT_EQ(one.percentile.low, again.percentile.low);
  EXPECT_EQ(one.bca.high, again.bca.high);
  EXPECT_LT(one.percentile.low, one.point.value());
  EXPECT_GT(one.percentile.high, one.point.value());
}

TEST(EvenChance, ASlopeNotToldFromZeroBoundsNothing) {
  std::vector<std::uint8_t> success;
  for (std::size_t i = 0; i < kMargins.size(); ++i) {
    success.push_back(i % 3 == 0 ? 0 : 1);
  }
  EvenChanceOptions options;
  options.replicates = 200;
  const EvenChance found = even_chance(kMargins, success, options);
  EXPECT_TRUE(found.point);
  EXPECT_NE(found.fieller.kind, ConfidenceSetKind::bounded);
  EXPECT_NE(found.profile.kind, ConfidenceSetKind::bounded);
  EXPECT_TRUE(found.profile.covers(*found.point));
  EXPECT_TRUE(found.fieller.covers(*found.point));
  EXPECT_EQ(found.bca.kind, ConfidenceSetKind::whole_line);
}

TEST(EvenChance, SeparatedPassesHaveNone) {
  std::vector<std::uint8_t> success;
  for (const double margin : kMargins) {
    success.push_back(margin > 0.0 ? 1 : 0);
  }
  const EvenChance found = even_chance(kMargins, success, {});
  EXPECT_FALSE(found.point);
  EXPECT_EQ(found.fieller.kind, ConfidenceSetKind::unknown);
  EXPECT_TRUE(statistics::has(found.conditions, statistics::ConditionKind::complete_separation));
  EXPECT_THROW((void)even_chance(kMargins, {}, {}), std::invalid_argument);
}

TEST(FiellerSet, HoldsWhereItsInequalityHolds) {
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  const double z = statistics::normal_factor(0.95);
  std::size_t shapes[4] = {};
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const double alpha = 3.0 * uniform();
    const double beta = 3.0 * uniform();
    const double va = 0.1 + std::abs(uniform());
    const double vb = 0.1 + std::abs(uniform());
    const double vab = 0.9 * uniform() * std::sqrt(va * vb);
    const ConfidenceSet set = fieller_set(alpha, beta, va, vab, vb, 0.95);
    ++shapes[static_cast<std::size_t>(set.kind)];
    for (double x = -20.0; x <= 20.0; x += 0.25) {
      const double left = std::pow(alpha + beta * x, 2);
      const double right = z * z * (va + 2.0 * x * vab + x * x * vb);
      if (std::abs(left - right) > 1e-9 * right) {
        ASSERT_EQ(set.covers(x), left < right) << x;
      }
    }
  }
  EXPECT_GT(shapes[1], 100U);
  EXPECT_GT(shapes[2], 100U);
  EXPECT_GT(shapes[3], 100U);
}

// The drop of the likelihood by a search over beta that knows nothing of derivatives.
double drop_by_search(const std::vector<double>& x,
                      const std::vector<std::uint8_t>& success,
                      double point,
                      double slope,
                      double x0) {
  const auto likelihood = [&](double beta, double at) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double eta = beta * (x[i] - at);
      sum += (success[i] != 0 ? eta : 0.0) - std::log1p(std::exp(eta));
    }
    return sum;
  };
  double low = -20.0;
  double high = 20.0;
  for (int step = 0; step < 90; ++step) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (likelihood(a, x0) < likelihood(b, x0) ? low : high) =
        likelihood(a, x0) < likelihood(b, x0) ? a : b;
  }
  return 2.0 * (likelihood(slope, point) - likelihood(0.5 * (low + high), x0));
}

TEST(ProfilePointSet, HoldsWhereTheTestDoesNotReject) {
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double target = std::pow(statistics::normal_factor(0.95), 2);
  std::size_t shapes[4] = {};
  for (int repeat = 0; repeat < 60; ++repeat) {
    std::vector<double> x;
    std::vector<std::uint8_t> success;
    const double slope = 2.0 * uniform();
    for (int i = 0; i < 30; ++i) {
      x.push_back(4.0 * uniform() - 2.0);
      success.push_back(uniform() < 1.0 / (1.0 + std::exp(-slope * (x.back() - 0.7))) ? 1 : 0);
    }
    EvenChanceOptions options;
    options.replicates = 0;
    const EvenChance found = even_chance(x, success, options);
    if (!found.point || std::abs(*found.slope) > 10.0) {
      continue;
    }
    ++shapes[static_cast<std::size_t>(found.profile.kind)];
    for (double x0 = -6.0; x0 <= 6.0; x0 += 1.0) {
      const double drop = drop_by_search(x, success, *found.point, *found.slope, x0);
      if (std::abs(drop - target) > 1e-6) {
        ASSERT_EQ(found.profile.covers(x0), drop < target) << x0 << " drops by " << drop;
      }
    }
  }
  EXPECT_GT(shapes[1], 10U);
  EXPECT_GT(shapes[2] + shapes[3], 10U);
}

TEST(GatePass, TakesTheBottleneckAndWhatWasKnownBeforeIt) {
  std::vector<CertifiedTick> series(10);
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i].travel_m = 0.1 * static_cast<double>(i);
    series[i].margin_m = i == 7 ? -0.01 : 0.3;
    series[i].certificate_m = -INFINITY;
    series[i].corridor_value_m = 0.5 - 0.01 * static_cast<double>(i);
  }
  series[1].margin_m = kMissing;
  series[1].corridor_value_m = -1.0;
  const GatePass pass = gate_pass(series, 0.45);
  EXPECT_EQ(pass.bottleneck_m, -0.01);
  // Before 0.7 - 0.45 m: ticks 0 and 2; tick 1 is no evidence.
  EXPECT_EQ(pass.before_m, 0.48);
  EXPECT_FALSE(gate_pass({}, 0.45).bottleneck_m);
}

TEST(GateStudy, CalibratesByGroupsOfLikeMargin) {
  std::vector<GateRow> rows;
  for (std::size_t i = 0; i < kMargins.size(); ++i) {
    rows.push_back({std::to_string(i), kPassed[i] != 0, {kMargins[i], 0.5 - kMargins[i] / 7.0}});
  }
  rows.push_back({"unknown", std::nullopt, {0.1, 0.2}});
  EvenChanceOptions options;
  options.replicates = 0;
  const GateStudy study = gate_study(rows, options);
  EXPECT_EQ(study.incomplete, 1U);
  ASSERT_EQ(study.calibration.size(), 5U);
  double predicted = 0.0;
  for (const GateCalibration& group : study.calibration) {
    EXPECT_EQ(group.passes, 4U);
    predicted += 4.0 * group.predicted;
  }
  // The score of the intercept is 0: predictions add up to the successes.
  EXPECT_NEAR(predicted, static_cast<double>(study.even.successes), 1e-9);
  ASSERT_TRUE(study.both);
  EXPECT_TRUE(statistics::has(study.both->conditions, statistics::ConditionKind::collinear_column));
}

}  // namespace
}  // namespace tcert::study
