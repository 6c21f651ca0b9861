#include <gtest/gtest.h>

#include <table/random.hpp>

#include <terrain/explore.hpp>
#include <terrain/lipschitz.hpp>
#include "analysis/study/terrain/baselines.hpp"

#include "analysis/study/terrain/scenarios.hpp"
#include "datasets/terrain_field/terrain_field.hpp"
#include "datasets/terrain_file.hpp"
#include "terrain/vectors.hpp"

namespace tcert::terrain {
namespace {

/// Two plateaus with a ravine between them, Lipschitz constant 10.
Terrain ravine(int width) {
  Terrain t{{40, 30}, {}};
  for (std::size_t i = 0; i < t.grid.size(); ++i) {
    const Cell c = t.grid.cell(i);
    const double into = std::max(0.0, 0.5 * width + 8.0 - std::abs(c.x - 20.0));
    t.values.push_back(60.0 - 10.0 * std::min(into, 12.0));
  }
  return t;
}

ExploreSetup setup_of(Cell start, std::optional<Cell> goal) {
  ExploreSetup setup;
  setup.rules.threshold = 0.0;
  setup.rules.lipschitz = 10.0;
  setup.start = start;
  setup.goal = goal;
  setup.prior = {60.0, 900.0, 8.0, 1.0};
  setup.rules.beta = 4.0;
  return setup;
}

TEST(Explore, CrossesWhereItCan) {
  const Terrain terrain = ravine(-20);
  const ExploreResult result = explore(terrain, setup_of({5, 15}, Cell{35, 15}));
  EXPECT_EQ(End::reached, result.end);
  EXPECT_EQ(position({35, 15}), result.path.back());
  ASSERT_TRUE(result.last().certificate);
  EXPECT_GE(*result.last().certificate, 0.0);
}

TEST(Explore, SaysThatAGoalIsNotReachable) {
  const Terrain terrain = ravine(4);
  const ExploreResult result = explore(terrain, setup_of({5, 15}, Cell{35, 15}));
  EXPECT_EQ(End::not_reachable, result.end);
  EXPECT_FALSE(result.last().certificate);
  EXPECT_GT(result.last().safe, 100U);
  EXPECT_LT(result.frontier.x(), 18.0);
  EXPECT_GT(result.frontier.x(), 5.0);
  EXPECT_EQ(0U, result.most_unsafe_certified);
}

TEST(Explore, GoesRoundPhysicalObstacles) {
  const Terrain terrain = ravine(-20);
  ExploreSetup setup = setup_of({5, 15}, Cell{35, 15});
  setup.blocked.assign(terrain.grid.size(), 0);
  for (int y = 5; y < 25; ++y) {
    setup.blocked[terrain.grid.index({20, y})] = 1;
  }
  const ExploreResult result = explore(terrain, setup);
  EXPECT_EQ(End::reached, result.end);
  for (const Position& p : result.path) {
    EXPECT_EQ(0, setup.blocked[terrain.grid.index(nearest_cell(p))]);
  }
  EXPECT_GT(result.last().travelled, 32.0);
}

TEST(Explore, RefusesWhatCannotBe) {
  const Terrain terrain = ravine(4);
  EXPECT_THROW(explore(terrain, setup_of({20, 15}, Cell{35, 15})), std::invalid_argument);
  EXPECT_THROW(explore(terrain, setup_of({-1, 15}, Cell{35, 15})), std::invalid_argument);
  EXPECT_THROW(explore(terrain, setup_of({5, 15}, Cell{40, 15})), std::invalid_argument);
}

TEST(Explore, RaisesAConstantThatIsContradicted) {
  const Terrain terrain = ravine(4);
  ExploreSetup setup = setup_of({5, 15}, Cell{35, 15});
  setup.rules.lipschitz = 4.0;
  const ExploreResult result = explore(terrain, setup);
  EXPECT_GT(result.last().lipschitz, 4.0);
  EXPECT_LE(result.last().lipschitz, 10.0 + 1e-9);
}

TEST(Explore, IsTheSameEveryTime) {
  const Terrain terrain = ravine(-20);
  ExploreSetup setup = setup_of({5, 15}, Cell{35, 15});
  setup.motion = Motion::reactive;
  const ExploreResult a = explore(terrain, setup);
  const ExploreResult b = explore(terrain, setup);
  ASSERT_EQ(a.path.size(), b.path.size());
  for (std::size_t k = 0; k < a.path.size(); ++k) {
    EXPECT_EQ(a.path[k], b.path[k]);
  }
}

TEST(Lipschitz, BoundHoldsForAllPairsAndIsTight) {
  TerrainFieldOptions field;
  field.rows = 36;
  field.columns = 28;
  field.length_scale = 9.0;
  for (std::uint64_t number = 0; number < 5; ++number) {
    field.number = number;
    const TerrainGrid made = random_terrain(field);
    const Grid grid{made.rows, made.columns};
    double steepest = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        steepest = std::max(
            steepest,
            std::abs(made.values[i] - made.values[j]) / distance(grid.cell(i), grid.cell(j)));
      }
    }
    EXPECT_LE(steepest, field.lipschitz * (1.0 + 1e-12));
    EXPECT_GT(steepest, 0.9 * field.lipschitz);
  }
}

TEST(Baselines, WalkStraightAndFail) {
  const Terrain terrain = ravine(4);
  const BaselineResult walk = straight_walk(terrain, {}, 0.0, {5, 15}, {35, 15});
  EXPECT_TRUE(walk.reached);
  EXPECT_GT(walk.unsafe_visits, 0U);
  EXPECT_DOUBLE_EQ(30.0, walk.length);
  SparseRrtOptions options;
  options.prior = {0.0, 900.0, 8.0, 1.0};
  options.inducing_spacing = 6.0;
  options.sensor_range = 10.0;
  options.nodes = 200;
  options.move = 5.0;
  table::RandomStream random(1, 2, 3);
  const BaselineResult rrt = sparse_rrt_walk(
      ravine(-20), 0.0, {5, 15}, {35, 15}, options, [&] { return random.uniform(); });
  EXPECT_TRUE(rrt.reached);
  EXPECT_EQ(0U, rrt.unsafe_visits);
}

TEST(Scenarios, RunOnThePublishedTerrain) {
  TCERT_NEED_VECTOR("terrain_600x400.csv.gz");
  auto file = read_terrain(test::vectors() / "terrain_600x400.csv.gz", {{}, TerrainHeader::yes});
  ASSERT_TRUE(file.terrain);
  const Terrain terrain{{file.terrain->rows, file.terrain->columns},
                        std::move(file.terrain->values)};
  const double lipschitz = lipschitz_bound(terrain.grid, terrain.values);
  EXPECT_NEAR(18.77, lipschitz, 0.01);
  const auto all = study::scenarios();
  const study::Scenario& general = all[0];
  const ExploreResult published =
      explore(terrain, study::setup_of(terrain, general, study::published(1000.0), 0));
  EXPECT_EQ(End::reached, published.end);
  EXPECT_NEAR(54.0, static_cast<double>(published.steps.size()), 3.0);
  EXPECT_EQ(0U, published.most_unsafe_certified);
  const ExploreResult printed =
      explore(terrain, study::setup_of(terrain, general, study::thesis_as_printed(1000.0), 0));
  EXPECT_EQ(239600U, printed.steps.front().safe) << "one step holds the whole map safe";
  EXPECT_GT(printed.most_unsafe_certified, 100000U);
  for (const study::Scenario& s : {all[0], all[1]}) {
    const ExploreResult ours =
        explore(terrain,
                study::setup_of(
                    terrain, s, study::certified(s.threshold, lipschitz, terrain.at(s.start)), 0));
    EXPECT_EQ(End::reached, ours.end);
    EXPECT_EQ(0U, ours.most_unsafe_certified);
    EXPECT_EQ(0U, ours.last().unsafe_visits);
    EXPECT_LT(ours.steps.size(), published.steps.size());
  }
}

}  // namespace
}  // namespace tcert::terrain
