// Ground certified by a band, and which of its border is measured next.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <table/random.hpp>
#include <terrain/frontier.hpp>
#include <terrain/session.hpp>

#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain {
namespace {

TEST(SeparableGp, AnUnknownMeanIsThatOfUniversalKriging) {
  const Grid grid{14, 11};
  const GpPrior prior{100.0, 2.0, 4.0, 0.01, true};
  SeparableGp gp(grid, prior);
  table::RandomStream random(3, 1, 4);
  std::vector<Measurement> m;
  for (int k = 0; k < 12; ++k) {
    const Cell c{static_cast<int>(random.below(14)), static_cast<int>(random.below(11))};
    m.push_back({position(c), 90.0 + 10.0 * random.uniform()});
    gp.add(m.back().at, m.back().value);
    const auto n = static_cast<Eigen::Index>(m.size());
    Eigen::MatrixXd k_mm(n, n);
    Eigen::VectorXd y(n);
    const auto kernel = [&](const Position& a, const Position& b) {
      return prior.variance * std::exp(-0.5 * (a - b).squaredNorm() / 16.0);
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      y(i) = m[static_cast<std::size_t>(i)].value;
      for (Eigen::Index j = 0; j < n; ++j) {
        k_mm(i, j) = kernel(m[static_cast<std::size_t>(i)].at, m[static_cast<std::size_t>(j)].at);
      }
      k_mm(i, i) += prior.noise_variance;
    }
    const Eigen::MatrixXd inverse = k_mm.inverse();
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(n);
    const double precision = one.dot(inverse * one);
    const double mean = one.dot(inverse * y) / precision;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      Eigen::VectorXd k_m(n);
      for (Eigen::Index j = 0; j < n; ++j) {
        k_m(j) = kernel(position(grid.cell(i)), m[static_cast<std::size_t>(j)].at);
      }
      const double rest = 1.0 - one.dot(inverse * k_m);
      EXPECT_NEAR(mean + k_m.dot(inverse * (y - mean * one)), gp.mean()[i], 1e-7);
      EXPECT_NEAR(prior.variance - k_m.dot(inverse * k_m) + rest * rest / precision,
                  gp.variance()[i],
                  1e-8);
    }
  }
}

/// 40 terrains of the covariance that is told, and half of it: what is held safe is.
TEST(Band, HoldsNoUnsafeGroundSafeOnTheFieldThatItAssumes) {
  int reached = 0;
  int unsafe = 0;
  for (std::uint64_t number = 0; number < 40; ++number) {
    TerrainFieldOptions field;
    field.rows = 60;
    field.columns = 48;
    field.mean = 0.0;
    field.length_scale = 8.0;
    field.number = number;
    TerrainGrid made = random_terrain(field);
    const Terrain terrain{{made.rows, made.columns}, std::move(made.values)};
    ExploreSetup setup;
    setup.rules.kind = RuleSet::band;
    setup.rules.threshold = 0.0;
    setup.rules.beta = kTrustedBeta;
    setup.confidence = 0.95;
    setup.prior.length_scale = number % 2 == 0 ? 8.0 : 4.0;
    const auto at = std::max_element(terrain.values.begin(), terrain.values.end());
    setup.start = terrain.grid.cell(static_cast<std::size_t>(at - terrain.values.begin()));
    setup.first_cells = cells_round(terrain.grid, {}, setup.start, 2);
    std::vector<Measurement> first;
    for (const Cell c : setup.first_cells) {
      first.push_back({position(c), terrain.at(c)});
    }
    first.push_back({position(setup.start), *at});
    settle(setup, terrain.grid, first, {});
    setup.max_steps = 100;
    const ExploreResult result = explore(terrain, setup);
    unsafe += result.most_unsafe_certified > 0 ? 1 : 0;
    reached += result.last().safe > 200 ? 1 : 0;
  }
  EXPECT_EQ(0, unsafe);
  EXPECT_GT(reached, 35) << "it is of use as well";
}

/// A plateau of 11 x 11 cells and a slope beyond it: equal values say nothing of the slope.
TEST(Band, DoesNotBeginOnGroundThatIsEqualEverywhere) {
  Terrain terrain{{60, 60}, std::vector<double>(3600)};
  for (std::size_t i = 0; i < terrain.values.size(); ++i) {
    const Cell c = terrain.grid.cell(i);
    const int off = std::max({0, std::abs(c.x - 30) - 5, std::abs(c.y - 30) - 5});
    terrain.values[i] = 1.0 - 0.4 * off;
  }
  for (const double noise_sd : {0.0, 0.01}) {
    ExploreSetup setup;
    setup.rules.kind = RuleSet::band;
    setup.rules.threshold = 0.0;
    setup.rules.beta = kTrustedBeta;
    setup.rules.noise_sd = setup.noise_sd = noise_sd;
    setup.confidence = 0.95;
    setup.prior.length_scale = 8.0;
    setup.start = {30, 30};
    for (const int radius : {2, 5, 9}) {
      std::vector<Measurement> first;
      setup.first_cells.clear();
      for (const Cell c : cells_round(terrain.grid, {}, setup.start, radius)) {
        if (terrain.at(c) >= 0.0) {
          setup.first_cells.push_back(c);
          first.push_back({position(c), terrain.at(c)});
        }
      }
      first.push_back({position(setup.start), 1.0});
      ExploreSetup settled = setup;
      if (radius < 9) {
        EXPECT_THROW(settle(settled, terrain.grid, first, {}), std::invalid_argument);
        continue;
      }
      settle(settled, terrain.grid, first, {});
      EXPECT_EQ(0U, explore(terrain, settled).most_unsafe_certified);
    }
  }
}

class Frontiers : public testing::Test {
 protected:
  Frontiers() {
    rules.threshold = 0.0;
    rules.lipschitz = 1.0;
    rules.travel_weight = 0.0;
    for (int x = 0; x < 5; ++x) {
      for (int y = 0; y < grid.columns; ++y) {
        safe[grid.index({x, y})] = 1;
      }
    }
    for (std::size_t i = 0; i < grid.size(); ++i) {
      depth2[i] =
          std::int64_t{1} * std::max(0, 5 - grid.cell(i).x) * std::max(0, 5 - grid.cell(i).x);
    }
  }
  [[nodiscard]] FrontierView view() const {
    return {grid, rules, mean, variance, 1.0, intervals, safe, blocked, depth2};
  }

  Grid grid{20, 10};
  Rules rules;
  std::vector<double> mean = std::vector<double>(grid.size(), 2.0);
  std::vector<double> variance = std::vector<double>(grid.size(), 1.0);
  Intervals intervals{grid.size()};
  CellSet safe = CellSet(grid.size(), 0);
  CellSet blocked;
  std::vector<std::int64_t> depth2 = std::vector<std::int64_t>(grid.size(), 0);
};

TEST_F(Frontiers, GrowthIsTheProbabilityThatTheDiscReachesOut) {
  // A disc of radius 2 expected, 1 needed: one standard deviation.
  EXPECT_NEAR(0.841344746068543, growth_probability(view(), grid.index({4, 3})), 1e-12);
  EXPECT_NEAR(0.158655253931457, growth_probability(view(), grid.index({2, 3})), 1e-12);
  variance.assign(grid.size(), 0.0);
  EXPECT_EQ(1.0, growth_probability(view(), grid.index({4, 3})));
  EXPECT_EQ(0.0, growth_probability(view(), grid.index({2, 3})));
}

TEST_F(Frontiers, TheBestOfTheFrontIsOnIt) {
  mean[grid.index({4, 2})] = 1.5;
  mean[grid.index({4, 9})] = 3.0;
  const Cell goal{15, 2};
  const std::vector<std::size_t> candidates{
      grid.index({3, 2}), grid.index({4, 2}), grid.index({4, 5}), grid.index({4, 9})};
  rules.growth_weight = 0.0;
  EXPECT_EQ((Cell{4, 2}), best_of_front(view(), candidates, goal, {0, 0}));
  rules.growth_weight = 1.0;
  EXPECT_EQ((Cell{4, 9}), best_of_front(view(), candidates, goal, {0, 0}));
  for (double weight = 0.0; weight <= 1.0; weight += 0.05) {
    rules.growth_weight = weight;
    const auto best = best_of_front(view(), candidates, goal, {0, 0});
    EXPECT_FALSE(best == (Cell{3, 2})) << "beaten by its neighbour in both";
  }
  EXPECT_FALSE(best_of_front(view(), {}, goal, {0, 0}));
}

TEST_F(Frontiers, AHorizonOfOneLooksAhead) {
  table::RandomStream random(2, 9, 9);
  for (int k = 0; k < 50; ++k) {
    for (double& m : mean) {
      m = 4.0 * random.uniform();
    }
    std::vector<std::size_t> candidates;
    for (int y = 0; y < grid.columns; ++y) {
      candidates.push_back(grid.index({4, y}));
    }
    rules.horizon = 1;
    rules.travel_weight = 0.1;
    const Cell goal{19, 4};
    EXPECT_EQ(look_ahead(view(), candidates, goal, {0, 4}),
              best_sequence(view(), candidates, goal, {0, 4}));
  }
}

TEST_F(Frontiers, SteadyGroundReachesNoFartherThanTheGrid) {
  rules.lipschitz = 1e-30;
  rules.horizon = 3;
  const std::vector<std::size_t> candidates{grid.index({4, 1}), grid.index({4, 8})};
  EXPECT_TRUE(best_sequence(view(), candidates, Cell{19, 4}, {2, 4}));
}

TEST_F(Frontiers, AHorizonSeesWhereAWayGoesOn) {
  // To the left of the goal's line the ground ends after one disc; to the right it goes on.
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Cell c = grid.cell(i);
    mean[i] = c.x <= 5 ? (c.y < 5 ? 3.2 : 3.0) : (c.y < 5 ? 0.0 : 3.0);
  }
  const std::vector<std::size_t> candidates{grid.index({4, 1}), grid.index({4, 8})};
  const Cell goal{19, 4};
  rules.horizon = 1;
  EXPECT_EQ((Cell{4, 1}), best_sequence(view(), candidates, goal, {2, 4}));
  rules.horizon = 4;
  EXPECT_EQ((Cell{4, 8}), best_sequence(view(), candidates, goal, {2, 4}));
}

}  // namespace
}  // namespace tcert::terrain
