// The bound of a field's scale, and of its Lipschitz constant.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <table/random.hpp>
#include <terrain/field_scale.hpp>
#include <terrain/lipschitz.hpp>
#include <terrain/session.hpp>

#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain {
namespace {

constexpr double kLengthScale = 8.0;

Terrain field_of(std::uint64_t number, double& lipschitz) {
  TerrainFieldOptions field;
  field.rows = 60;
  field.columns = 48;
  field.length_scale = kLengthScale;
  field.number = number;
  lipschitz = field.lipschitz;
  TerrainGrid made = random_terrain(field);
  return {{made.rows, made.columns}, std::move(made.values)};
}

std::vector<Measurement> disc_round(const Terrain& terrain, Cell start) {
  std::vector<Measurement> measurements;
  for (const Cell c : cells_round(terrain.grid, {}, start, 2)) {
    measurements.push_back({position(c), terrain.at(c)});
  }
  measurements.push_back({position(start), terrain.at(start)});
  return measurements;
}

TEST(ChiSquareQuantile, IsThatOfR) {
  // qchisq(level, freedom) of R 4.2.2.
  EXPECT_NEAR(0.102586588775101, chi_square_quantile(2.0, 0.05), 1e-12);
  EXPECT_NEAR(1.14547622606177, chi_square_quantile(5.0, 0.05), 1e-11);
  EXPECT_NEAR(0.000157087857909703, chi_square_quantile(1.0, 0.01), 1e-15);
  EXPECT_NEAR(77.9294651650174, chi_square_quantile(100.0, 0.05), 1e-9);
  EXPECT_NEAR(1.930588620611, chi_square_quantile(7.5, 0.025), 1e-10);
}

/// The same bound from the whole covariance matrix, by dense algebra.
double dense_bound(const std::vector<Measurement>& m, double noise_sd, double level) {
  const auto n = static_cast<Eigen::Index>(m.size());
  const auto form = [&](double v) {
    Eigen::MatrixXd k(n, n);
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Measurement& a = m[static_cast<std::size_t>(i)];
      y(i) = a.value;
      for (Eigen::Index j = 0; j < n; ++j) {
        const double d2 = (a.at - m[static_cast<std::size_t>(j)].at).squaredNorm();
        k(i, j) = v * std::exp(-0.5 * d2 / (kLengthScale * kLengthScale));
      }
      k(i, i) += v * 1e-6 + noise_sd * noise_sd;
    }
    const Eigen::MatrixXd inverse = k.inverse();
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(n);
    const double mean = one.dot(inverse * y) / one.dot(inverse * one);
    const Eigen::VectorXd r = y - mean * one;
    return r.dot(inverse * r);
  };
  const double quantile = chi_square_quantile(static_cast<double>(n - 1), level);
  double low = 1e-6;
  double high = 1e12;
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(low * high);
    (form(middle) < quantile ? high : low) = middle;
  }
  return high;
}

TEST(FieldScale, IsTheVarianceAtWhichTheQuadraticFormEqualsItsQuantile) {
  double lipschitz = 0.0;
  const Terrain terrain = field_of(3, lipschitz);
  for (const double noise_sd : {0.0, 5.0}) {
    std::vector<Measurement> apart;
    FieldScale scale({kLengthScale, noise_sd, 0.95, {}});
    for (int k = 0; k < 6; ++k) {
      const Cell c{5 + 9 * k, 7 + 6 * k};
      apart.push_back({position(c), terrain.at(c)});
      scale.add(apart.back());
    }
    ASSERT_EQ(6U, scale.places());
    ASSERT_TRUE(scale.renew());
    const double expected = dense_bound(apart, noise_sd, 0.0125);
    // With noise the bound is the upper end of an interval of one per cent.
    EXPECT_GE(scale.variance_bound(), expected * (1.0 - 1e-6));
    EXPECT_LE(scale.variance_bound(), expected * (noise_sd > 0.0 ? 1.0101 : 1.0 + 1e-6));
  }
}

TEST(FieldScale, TakesNoPlaceTwice) {
  double lipschitz = 0.0;
  const Terrain terrain = field_of(3, lipschitz);
  FieldScale scale({kLengthScale, 0.0, 0.95, {}});
  for (int twice = 0; twice < 2; ++twice) {
    for (const Measurement& m : disc_round(terrain, {30, 24})) {
      scale.add(m);
    }
  }
  EXPECT_LE(scale.places(), 13U);
  EXPECT_GE(scale.places(), 3U);
  EXPECT_FALSE(scale.variance_bound() < kUnbounded);
  EXPECT_TRUE(scale.renew());
  EXPECT_FALSE(scale.renew()) << "nothing new was measured";
}

TEST(FieldScale, APriorOfEarlierGroundLowersTheFirstBound) {
  double lipschitz = 0.0;
  const Terrain terrain = field_of(3, lipschitz);
  FieldScale alone({kLengthScale, 0.0, 0.95, {}});
  FieldScale told({kLengthScale, 0.0, 0.95, {lipschitz / 4.0, 20.0}});
  for (const Measurement& m : disc_round(terrain, {30, 24})) {
    alone.add(m);
    told.add(m);
  }
  ASSERT_TRUE(alone.renew());
  ASSERT_TRUE(told.renew());
  EXPECT_LT(told.lipschitz_bound(terrain.grid), alone.lipschitz_bound(terrain.grid));
  EXPECT_GT(told.lipschitz_bound(terrain.grid), lipschitz);
}

TEST(FieldScale, CoversTheLipschitzConstantAtAllTimesAndFalls) {
  constexpr int kRuns = 100;
  int covered = 0;
  int fell = 0;
  for (int run = 0; run < kRuns; ++run) {
    double lipschitz = 0.0;
    const Terrain terrain = field_of(static_cast<std::uint64_t>(run), lipschitz);
    ExploreSetup setup;
    setup.start = {32, 24};
    setup.rules.threshold = terrain.at(setup.start) - 600.0;
    setup.confidence = 0.95;
    setup.prior.length_scale = kLengthScale;
    setup.max_steps = 60;
    setup.first_cells = cells_round(terrain.grid, {}, setup.start, 2);
    settle(setup, terrain.grid, disc_round(terrain, setup.start), {});
    const ExploreResult result = explore(terrain, setup);
    bool all = true;
    for (const ExploreStep& step : result.steps) {
      all = all && step.lipschitz >= lipschitz;
    }
    covered += all ? 1 : 0;
    fell += result.last().lipschitz < 0.9 * result.steps.front().lipschitz ? 1 : 0;
  }
  RecordProperty("covered_of_100", covered);
  RecordProperty("fell_of_100", fell);
  EXPECT_GE(covered, 95);
  EXPECT_GT(fell, 50);
}

TEST(FieldScale, EqualValuesBoundNothingAndLaterOnesDo) {
  for (const double noise_sd : {0.0, 2.0}) {
    FieldScale scale({kLengthScale, noise_sd, 0.95, {}});
    for (int k = 0; k < 6; ++k) {
      scale.add({position({0, 4 * k}), 1000.1});
      EXPECT_FALSE(scale.renew());
      EXPECT_EQ(kUnbounded, scale.variance_bound());
      EXPECT_EQ(kUnbounded, scale.lipschitz_bound({60, 48}));
    }
    for (int k = 6; k < 12; ++k) {
      scale.add({position({0, 4 * k}), 1000.1 + 50.0 * (k - 5)});
      (void)scale.renew();
    }
    EXPECT_LT(scale.variance_bound(), kUnbounded);
    EXPECT_GT(scale.variance_bound(), 100.0);
  }
}

TEST(FieldScale, WhatContradictsABoundReplacesIt) {
  for (const double noise_sd : {0.0, 0.001}) {
    FieldScale scale({kLengthScale, noise_sd, 0.95, {}});
    // All but flat.
    for (int k = 0; k < 6; ++k) {
      scale.add({position({0, 4 * k}), k % 2 == 0 ? 10.0 : 10.01});
      (void)scale.renew();
    }
    const double flat = scale.variance_bound();
    ASSERT_LT(flat, 1.0);
    const int bounds = scale.bounds();
    scale.add({position({0, 24}), 30.0});
    EXPECT_TRUE(scale.renew());
    EXPECT_GT(scale.variance_bound(), 100.0 * flat);
    EXPECT_LE(scale.bounds(), bounds + 1);
  }
}

TEST(FieldScale, RefusesAssumptionsThatAreNone) {
  EXPECT_THROW(FieldScale({0.0, 0.0, 0.95, {}}), std::invalid_argument);
  EXPECT_THROW(FieldScale({8.0, -1.0, 0.95, {}}), std::invalid_argument);
  EXPECT_THROW(FieldScale({8.0, 0.0, 1.0, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::terrain
