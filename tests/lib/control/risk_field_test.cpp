#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <tcert/risk_field.hpp>

#include "support/allocations.hpp"

namespace tcert {
namespace {

// Values of the published formulas, worked out by hand (e 0.04 m^2, p_h 0.99, p_m 0.9999).
TEST(RiskIntensity, IsThePublishedOneWithItsInterval) {
  struct Case {
    double hits, misses, lambda, high, low;
  };
  for (const Case& c : {Case{0, 5, 0.0, 0.222612, 0.0},
                        Case{1, 9, 2.634013, 3.180465, 2.049813},
                        Case{3, 7, 8.916874, 10.058390, 7.625666},
                        Case{50, 50, 17.328680, 17.778160, 16.405473}}) {
    const CellCounts counts{c.hits, c.misses, 0.04};
    EXPECT_NEAR(lambda_intensity(counts), c.lambda, 5e-7);
    const IntensityRange range = lambda_interval(counts, 0.99, 0.9999);
    EXPECT_NEAR(range.high, c.high, 5e-7);
    EXPECT_NEAR(range.low, c.low, 5e-7);
    EXPECT_NEAR(
        1.0 - std::exp(-0.04 * lambda_intensity(counts)), c.hits / (c.hits + c.misses), 1e-15);
  }
  EXPECT_TRUE(std::isinf(lambda_intensity({2.0, 0.0, 0.04})));
}

TEST(RiskIntensity, ThePosteriorBeginsAtThePriorAndFollowsTheCounts) {
  EXPECT_NEAR(gamma_intensity({0.0, 0.0, 0.0025}, 3.42, 4.0), 3.42, 1e-12);
  // Many observations leave h / (e n).
  EXPECT_NEAR(gamma_intensity({500.0, 1500.0, 0.0025}, 3.42, 4.0), 100.0, 0.3);
  EXPECT_LT(gamma_intensity({0.0, 50.0, 0.0025}, 3.42, 4.0), 0.3);
}

RiskParameters of_prior(double per_m2) {
  RiskParameters parameters;
  parameters.prior_per_m2 = per_m2;
  return parameters;
}

TEST(RiskField, AWayOfOneIntensityHasItsChanceHoweverItIsCut) {
  const RiskField field(of_prior(2.0));
  const Point ahead = direction(0.3);
  for (const int pieces : {1, 10, 1000}) {
    double free = 1.0;
    for (int i = 0; i < pieces; ++i) {
      const double length_m = 2.5 / pieces;
      const Point from = (i * length_m) * ahead;
      free *= 1.0 - field.collision_probability(from, ahead, length_m, 0.45, 0.0);
    }
    EXPECT_NEAR(1.0 - free, 0.8946007754, 1e-9) << pieces;
  }
}

TEST(RiskField, AContactIsAHitAtTheTipAndMissesAlongTheRay) {
  RiskField field{RiskParameters{}};
  field.observe_ray({0.025, 0.025}, {1.0, 0.0}, 0.4, true, 0.0);
  EXPECT_EQ(field.counts_at({0.43, 0.02}, 0.0).hits, 1.0);
  EXPECT_EQ(field.counts_at({0.43, 0.02}, 0.0).misses, 0.0);
  for (double x = 0.075; x < 0.4; x += 0.05) {
    EXPECT_EQ(field.counts_at({x, 0.025}, 0.0).misses, 1.0) << x;
    EXPECT_EQ(field.counts_at({x, 0.025}, 0.0).hits, 0.0) << x;
  }
  EXPECT_EQ(field.counts_at({0.47, 0.025}, 0.0).misses, 0.0) << "nothing is known behind a contact";
  field.observe_ray({0.025, 0.025}, {1.0, 0.0}, 0.4, false, 0.0);
  EXPECT_EQ(field.counts_at({0.41, 0.025}, 0.0).hits, 1.0);
}

TEST(RiskField, TheBodyStandsWhereNothingIs) {
  RiskField field{RiskParameters{}};
  field.observe_body({0.0, 0.0}, 0.225, 0.0);
  double area_m2 = 0.0;
  for (int i = -8; i < 8; ++i) {
    for (int j = -8; j < 8; ++j) {
      area_m2 += 0.0025 * field.counts_at({0.05 * i + 0.025, 0.05 * j + 0.025}, 0.0).misses;
    }
  }
  EXPECT_NEAR(area_m2, std::numbers::pi * 0.225 * 0.225, 0.02);
}

TEST(RiskField, TheIntegralIsTheSumOverFineSteps) {
  RiskField field{RiskParameters{}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::uniform_real_distribution<double> turn(-3.0, 3.0);
  for (int i = 0; i < 300; ++i) {
    field.observe_ray(
        {place(random), place(random)}, direction(turn(random)), 0.5, i % 3 == 0, 0.0);
  }
  for (int i = 0; i < 50; ++i) {
    const Point from{place(random), place(random)};
    const Point ahead = direction(turn(random));
    double sum = 0.0;
    constexpr int kSteps = 20'000;
    for (int k = 0; k < kSteps; ++k) {
      sum += field.intensity_at(from + (1.2 * (k + 0.5) / kSteps) * ahead, 0.0);
    }
    EXPECT_NEAR(field.integral_along(from, ahead, 1.2, 0.0), 1.2 * sum / kSteps, 0.02);
  }
}

TEST(RiskField, ForgetsTowardsThePrior) {
  RiskParameters parameters;
  parameters.half_life_s = 10.0;
  RiskField field(parameters);
  for (int i = 0; i < 20; ++i) {
    field.observe_ray({0.0, 0.01}, {1.0, 0.0}, 0.42, true, 0.0);
  }
  const Point tip{0.42, 0.01};
  EXPECT_DOUBLE_EQ(field.counts_at(tip, 10.0).hits, 10.0);
  const double now = field.intensity_at(tip, 0.0);
  const double later = field.intensity_at(tip, 30.0);
  EXPECT_GT(now, later);
  EXPECT_NEAR(field.intensity_at(tip, 1000.0), parameters.prior_per_m2, 1e-6);
  field.observe_ray({0.0, 0.01}, {1.0, 0.0}, 0.42, true, 10.0);
  EXPECT_DOUBLE_EQ(field.counts_at(tip, 10.0).hits, 11.0);
}

// A coin a cell: how often a strip is met is what is predicted from its cells, to within chance.
TEST(RiskField, PredictsWhatComesOfCellsOfKnownIntensity) {
  std::mt19937 random(11);
  std::array<int, 10> met{};
  std::array<int, 10> tried{};
  std::array<double, 10> predicted{};
  for (int world = 0; world < 4000; ++world) {
    RiskParameters parameters;
    parameters.intensity = RiskIntensity::lambda;
    RiskField field(parameters);
    std::uniform_real_distribution<double> rate(0.0, 0.06);
    double free = 1.0;
    bool is_met = false;
    const double share = rate(random);
    for (int column = 0; column < 10; ++column) {
      // 400 looks at a cell that is taken at a share of them.
      std::binomial_distribution<int> hits(400, share);
      const int h = hits(random);
      const Point middle{0.05 * column + 0.025, 0.025};
      for (int i = 0; i < 400; ++i) {
        field.observe_ray(middle - Point{0.0, 0.001}, {0.0, 1.0}, 0.001, i < h, 0.0);
      }
      for (int i = h; i < 400; ++i) {
        field.observe_body(middle, 0.001, 0.0);
      }
      is_met = is_met || std::bernoulli_distribution(share)(random);
      free *= 1.0 - share;
    }
    const double p = field.collision_probability({0.0, 0.025}, {1.0, 0.0}, 0.5, 0.05, 0.0);
    EXPECT_NEAR(p, 1.0 - free, 0.12);
    const auto bin = std::min<std::size_t>(static_cast<std::size_t>(10.0 * p), 9);
    ++tried[bin];
    met[bin] += is_met ? 1 : 0;
    predicted[bin] += p;
  }
  for (std::size_t bin = 0; bin < met.size(); ++bin) {
    if (tried[bin] >= 100) {
      const double mean = predicted[bin] / tried[bin];
      const double error = 3.5 * std::sqrt(mean * (1.0 - mean) / tried[bin]);
      EXPECT_NEAR(static_cast<double>(met[bin]) / tried[bin], mean, error) << bin;
    }
  }
}

TEST(RiskField, AMirroredRunMakesTheMirroredField) {
  RiskField left{RiskParameters{}};
  RiskField right{RiskParameters{}};
  std::mt19937 random(3);
  std::uniform_int_distribution<int> grid(-20, 20);
  std::uniform_real_distribution<double> length(0.05, 0.8);
  for (int i = 0; i < 200; ++i) {
    const Point from{0.05 * grid(random), 0.05 * grid(random)};
    const Point ahead = i % 4 == 0 ? Point{1.0, 0.0} : direction(0.1 * grid(random));
    const double clear_m = length(random);
    left.observe_ray(from, ahead, clear_m, i % 2 == 0, 0.0);
    right.observe_ray({from.x_m, -from.y_m}, {ahead.x_m, -ahead.y_m}, clear_m, i % 2 == 0, 0.0);
  }
  for (int i = 0; i < 200; ++i) {
    const Point from{0.05 * grid(random), 0.05 * grid(random)};
    const Point ahead = i % 4 == 0 ? Point{1.0, 0.0} : direction(0.1 * grid(random));
    EXPECT_EQ(left.integral_along(from, ahead, 0.6, 0.0),
              right.integral_along({from.x_m, -from.y_m}, {ahead.x_m, -ahead.y_m}, 0.6, 0.0));
  }
}

TEST(RiskField, WhatFindsNoRoomStaysUnknown) {
  RiskParameters parameters;
  parameters.max_cells = 64;
  RiskField field(parameters);
  for (int i = 0; i < 100; ++i) {
    field.observe_body({2.0 * i, 0.0}, 0.2, 0.0);
  }
  EXPECT_TRUE(field.is_full());
  EXPECT_DOUBLE_EQ(field.intensity_at({198.0, 0.0}, 0.0), parameters.prior_per_m2);
  field.clear();
  EXPECT_FALSE(field.is_full());
}

TEST(RiskField, AllocatesNothingAndTakesPosesFromAfar) {
  RiskField field{RiskParameters{}};
  const std::size_t before = test_support::allocation_count();
  for (int i = 0; i < 100; ++i) {
    field.observe_ray({0.01 * i, 0.0}, direction(0.1 * i), 0.6, true, i);
    field.observe_body({0.01 * i, 0.0}, 0.225, i);
    field.observe_ray({1e9, -1e9}, {1.0, 0.0}, 0.6, true, i);
    EXPECT_GE(field.collision_probability({1e9, 0.0}, {1.0, 0.0}, 0.5, 0.45, i), 0.0);
  }
  EXPECT_EQ(test_support::allocation_count(), before);
}

}  // namespace
}  // namespace tcert
