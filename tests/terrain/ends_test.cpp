// How an exploration ends, named by what stands in the way.
#include <gtest/gtest.h>

#include <limits>
#include <terrain/explore.hpp>

#include "analysis/study/terrain/scenarios.hpp"
#include "datasets/terrain_file.hpp"
#include "terrain/vectors.hpp"

namespace tcert::terrain {
namespace {

Terrain flat(int rows, int columns, double value) {
  const Grid grid{rows, columns};
  return {grid, std::vector<double>(grid.size(), value)};
}

ExploreSetup setup_of(Cell start, std::optional<Cell> goal, double lipschitz) {
  ExploreSetup setup;
  setup.rules.threshold = 5.0;
  setup.rules.lipschitz = lipschitz;
  setup.start = start;
  setup.goal = goal;
  setup.prior = {100.0, 900.0, 8.0, 1.0};
  return setup;
}

CellSet wall(const Grid& grid, int row, int from, int to) {
  CellSet blocked(grid.size(), 0);
  for (int y = from; y <= to; ++y) {
    blocked[grid.index({row, y})] = 1;
  }
  return blocked;
}

TEST(Ends, ExploredIsNotUnreachable) {
  const ExploreResult result = explore(flat(12, 12, 100.0), setup_of({2, 2}, std::nullopt, 1.0));
  EXPECT_EQ(End::explored, result.end);
  EXPECT_EQ(144U, result.last().safe);
  EXPECT_EQ("explored: no cell can make the ground grow", to_string(result.end));
}

TEST(Ends, TheThresholdForbidsIt) {
  Terrain terrain = flat(20, 12, 100.0);
  for (int x = 9; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      terrain.values[terrain.grid.index({x, y})] = 0.0;
    }
  }
  EXPECT_EQ(End::not_reachable, explore(terrain, setup_of({2, 2}, Cell{17, 2}, 100.0)).end);
}

TEST(Ends, OnlyTheLipschitzConstantForbidsIt) {
  // A disc of (100 - 5) / 200 cells holds no neighbour.
  const ExploreResult result = explore(flat(12, 12, 100.0), setup_of({2, 2}, Cell{9, 9}, 200.0));
  EXPECT_EQ(End::only_lipschitz, result.end);
  EXPECT_EQ(1U, result.last().safe);
  EXPECT_EQ(End::reached, explore(flat(12, 12, 100.0), setup_of({2, 2}, Cell{9, 9}, 20.0)).end);
}

TEST(Ends, ObstaclesForbidWhatTheThresholdAllows) {
  Terrain terrain = flat(20, 12, 100.0);
  // A hole in the wall, but it lies on unsafe ground.
  terrain.values[terrain.grid.index({10, 11})] = 0.0;
  ExploreSetup setup = setup_of({2, 2}, Cell{17, 2}, 100.0);
  setup.blocked = wall(terrain.grid, 10, 0, 10);
  EXPECT_EQ(End::past_obstacles, explore(terrain, setup).end);
}

TEST(Ends, WhatAGapHoldsIsNotSaidToBreakTheThreshold) {
  Terrain terrain = flat(20, 12, 100.0);
  ExploreSetup setup = setup_of({2, 2}, Cell{17, 2}, 100.0);
  setup.blocked = wall(terrain.grid, 10, 0, 11);
  for (std::size_t i = 0; i < terrain.values.size(); ++i) {
    if (setup.blocked[i] != 0) {
      terrain.values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  EXPECT_EQ(End::past_obstacles, explore(terrain, setup).end);
}

TEST(Ends, TheRulesForbidIt) {
  // So steep an L that no disc holds a neighbour: Algorithm 1 cannot leave its seed.
  ExploreSetup setup = setup_of({2, 2}, Cell{9, 9}, 200.0);
  setup.rules.kind = RuleSet::thesis;
  setup.seeds = {{2, 2}};
  setup.max_steps = 200;
  const ExploreResult result = explore(flat(12, 12, 100.0), setup);
  EXPECT_EQ(End::only_rules, result.end) << to_string(result.end);
  EXPECT_EQ(1U, result.last().safe);
}

TEST(Ends, NothingIsSafe) {
  // A zero prior draws the one measurement down below the threshold.
  ExploreSetup setup = setup_of({2, 2}, Cell{9, 9}, 20.0);
  setup.rules.kind = RuleSet::published;
  setup.rules.threshold = 90.0;
  setup.prior = {0.0, 2.0, 30.0, 1.0};
  EXPECT_EQ(End::empty_safe_set, explore(flat(12, 12, 100.0), setup).end);
}

TEST(Ends, TheGoalLiesAtTheEdge) {
  // A ramp, whose goal in the corner is certified after some steps only: at the first plan depth is
  // not asked for.
  Terrain terrain = flat(60, 50, 0.0);
  for (std::size_t i = 0; i < terrain.values.size(); ++i) {
    terrain.values[i] = terrain.grid.cell(i).x;
  }
  ExploreSetup setup = setup_of({45, 4}, Cell{59, 49}, 0.003);
  setup.rules.kind = RuleSet::published;
  setup.rules.threshold = 30.0;
  for (int x = 30; x < 60; x += 4) {
    for (int y = 0; y < 24; y += 4) {
      setup.first_cells.push_back({x, y});
    }
  }
  setup.prior = {0.0, 2.0, 30.0, 1.0};
  setup.max_steps = 30;
  const ExploreResult result = explore(terrain, setup);
  EXPECT_EQ(End::goal_at_edge, result.end) << to_string(result.end);
  EXPECT_EQ(position({59, 49}), result.frontier);
  // Without a depth it is reached.
  setup.simplification = 0.0;
  EXPECT_EQ(End::reached, explore(terrain, setup).end);
}

TEST(Ends, TheLimitOfSteps) {
  ExploreSetup setup = setup_of({2, 2}, Cell{90, 90}, 40.0);
  setup.max_steps = 3;
  EXPECT_EQ(End::step_limit, explore(flat(100, 100, 100.0), setup).end);
}

TEST(Blocked, StartGoalAndFirstCellsAreRefused) {
  const Terrain terrain = flat(12, 12, 100.0);
  for (const Cell blocked : {Cell{2, 2}, Cell{9, 9}, Cell{2, 3}}) {
    ExploreSetup setup = setup_of({2, 2}, Cell{9, 9}, 20.0);
    setup.first_cells = {{2, 3}};
    setup.blocked.assign(terrain.grid.size(), 0);
    setup.blocked[terrain.grid.index(blocked)] = 1;
    EXPECT_THROW((void)explore(terrain, setup), std::invalid_argument);
  }
}

TEST(Blocked, GapsAreNeitherMeasuredNorEnteredUnderAnyRules) {
  for (const RuleSet kind : {RuleSet::certified, RuleSet::thesis, RuleSet::published}) {
    Terrain terrain = flat(20, 20, 100.0);
    ExploreSetup setup = setup_of({4, 9}, Cell{15, 9}, 20.0);
    setup.blocked = wall(terrain.grid, 10, 5, 14);
    for (std::size_t i = 0; i < terrain.values.size(); ++i) {
      if (setup.blocked[i] != 0) {
        terrain.values[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    setup.rules.kind = kind;
    setup.seeds = {{4, 9}};
    setup.simplification = 2.0;
    setup.prior = kind == RuleSet::published ? GpPrior{0.0, 2.0, 30.0, 1.0} : setup.prior;
    const ExploreResult result = explore(terrain, setup);
    EXPECT_EQ(End::reached, result.end) << to_string(kind) << ": " << to_string(result.end);
    ASSERT_TRUE(result.last().certificate);
    EXPECT_LE(result.last().safe, terrain.grid.size() - 10U);
    for (const Position& p : result.path) {
      EXPECT_EQ(0, setup.blocked[terrain.grid.index(nearest_cell(p))]) << to_string(kind);
    }
    for (const ExploreStep& s : result.steps) {
      EXPECT_EQ(100.0, s.value);
    }
  }
}

TEST(Limits, AreNamedBeforeAnythingOverflows) {
  const Terrain terrain = flat(12, 12, 100.0);
  const auto refused = [&](auto change, const std::string& part) {
    ExploreSetup setup = setup_of({2, 2}, Cell{9, 9}, 20.0);
    Terrain ground = terrain;
    change(setup, ground);
    try {
      (void)explore(ground, setup);
      ADD_FAILURE() << "taken: " << part;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string::npos, std::string(error.what()).find(part)) << error.what();
    }
  };
  refused([](ExploreSetup& s, Terrain&) { s.rules.lipschitz = 1e300; }, "lipschitz: found 1e+300");
  refused([](ExploreSetup& s, Terrain&) { s.rules.lipschitz = 1e-300; }, "lipschitz");
  refused([](ExploreSetup& s, Terrain&) { s.rules.threshold = -1e300; }, "threshold");
  refused([](ExploreSetup& s, Terrain&) { s.prior.variance = 1e300; }, "kernel-variance");
  refused([](ExploreSetup& s, Terrain&) { s.prior.length_scale = 1e-300; }, "kernel-length-scale");
  refused([](ExploreSetup& s, Terrain&) { s.max_steps = -1; }, "max-steps");
  refused([](ExploreSetup& s, Terrain&) { s.robot_radius = 1e300; }, "robot-radius");
  refused([](ExploreSetup&, Terrain& t) { t.values[7] = 1e300; }, "the value at (0, 7)");
  refused([](ExploreSetup&, Terrain& t) { t.values[7] = std::nan(""); }, "block the cell");
}

/// Of the README's table; the controller's end, not its nearness, is what counts.
TEST(Reactive, CountsEveryWayThatARouteFinished) {
  TCERT_NEED_VECTOR("terrain_600x400.csv.gz");
  auto file = read_terrain(test::vectors() / "terrain_600x400.csv.gz", {{}, TerrainHeader::yes});
  ASSERT_TRUE(file.terrain);
  const Terrain terrain{{file.terrain->rows, file.terrain->columns},
                        std::move(file.terrain->values)};
  const auto scenarios = study::scenarios();
  const std::size_t arrived[] = {3, 4};
  const std::size_t ways[] = {17, 47};
  const double by_route[] = {138.0, 472.0};
  for (std::size_t k = 0; k < 2; ++k) {
    const study::Scenario& s = scenarios[k];
    study::Variant variant = study::certified(s.threshold, 18.77, terrain.at(s.start));
    variant.motion = Motion::reactive;
    const ExploreResult result = explore(terrain, study::setup_of(terrain, s, variant, 0));
    EXPECT_EQ(ways[k], result.ways);
    EXPECT_EQ(arrived[k], result.ways - result.controller_fallbacks);
    EXPECT_NEAR(by_route[k], result.route_cells, 3.0);
    EXPECT_NEAR(result.last().travelled, result.controller_cells + result.route_cells, 1e-6);
  }
}

}  // namespace
}  // namespace tcert::terrain
