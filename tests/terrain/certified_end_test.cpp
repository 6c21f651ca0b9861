#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <table/random.hpp>
#include <terrain/components.hpp>
#include <terrain/explore.hpp>

#include "analysis/study/terrain/scenarios.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain {
namespace {

constexpr double kLipschitz = 20.0;

Terrain field_of(int rows, int columns, std::uint64_t seed, std::uint64_t number = 0) {
  TerrainFieldOptions field;
  field.rows = rows;
  field.columns = columns;
  field.length_scale = 8.0;
  field.lipschitz = kLipschitz;
  field.seed = seed;
  field.number = number;
  TerrainGrid made = random_terrain(field);
  return {{made.rows, made.columns}, std::move(made.values)};
}

ExploreSetup setup_of(const Terrain& terrain, Cell start, Cell goal, double threshold) {
  ExploreSetup setup;
  setup.rules.threshold = threshold;
  setup.rules.lipschitz = kLipschitz;
  setup.start = start;
  setup.goal = goal;
  setup.prior = {terrain.at(start), 1300.0, 8.0, 1.0};
  return setup;
}

/// Cells that the robot could measure and that might, for all that measurements and the Lipschitz
/// constant say, make the certified ground grow.
std::size_t cells_that_could_help(const Planner& planner, Cell robot) {
  const Grid& grid = planner.grid();
  const Rules& rules = planner.rules();
  const CellSet reach = component_of(grid, planner.ground(), robot);
  std::size_t helpful = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (reach[i] == 0) {
      continue;
    }
    double upper = std::numeric_limits<double>::infinity();
    bool measured = false;
    for (const Measurement& m : planner.measurements()) {
      const double d = (m.at - position(grid.cell(i))).norm();
      measured = measured || d == 0.0;
      upper = std::min(upper, m.value + rules.noise_bound + rules.lipschitz * d);
    }
    bool grows = false;
    for (std::size_t j = 0; j < grid.size() && !measured && !grows; ++j) {
      const double d = distance(grid.cell(i), grid.cell(j));
      grows = planner.safe()[j] == 0 && upper - rules.lipschitz * d >= rules.threshold + 1e-9;
    }
    helpful += grows ? 1U : 0U;
  }
  return helpful;
}

TEST(CertifiedEnd, DoesNotTakeTheModelsWordThatAGoalIsNotReachable) {
  const Terrain terrain = field_of(48, 36, 22);
  ExploreSetup setup = setup_of(terrain, {12, 35}, {40, 10}, 924.326);
  // Smoother than the terrain is: too sure of what it has not seen.
  setup.prior = study::prior_of(kLipschitz, 30.0, terrain.at(setup.start));
  std::size_t against_the_model = 0;
  const auto watch = [&](const Planner& planner, const ExploreStep&, const ExploreResult&) {
    against_the_model += planner.last_plan().against_the_model ? 1U : 0U;
  };
  EXPECT_EQ(End::reached, explore(terrain, setup, watch).end);
  EXPECT_GT(against_the_model, 0U) << "the model must have ruled every expander out";
  setup.rules.beta = 1e6;
  EXPECT_EQ(End::reached, explore(terrain, setup).end) << "whatever the model's band";
}

TEST(CertifiedEnd, LeavesNoCellThatCouldHelp) {
  int ended = 0;
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Terrain terrain = field_of(30, 24, 5, number);
    table::RandomStream random(5, 11, number);
    const auto cell = [&] {
      return terrain.grid.cell(random.below(static_cast<std::uint32_t>(terrain.grid.size())));
    };
    const Cell start = cell();
    const Cell goal = cell();
    ExploreSetup setup = setup_of(terrain, start, goal, terrain.at(start) - 30.0);
    setup.rules.noise_bound = number % 2 == 0 ? 0.0 : 5.0;
    setup.rules.selection = number % 3 == 0 ? Selection::look_ahead : Selection::thesis;
    std::size_t left = 0;
    const auto watch = [&](const Planner& planner, const ExploreStep& s, const ExploreResult&) {
      if (!s.next) {
        left = cells_that_could_help(planner, nearest_cell(s.at));
      }
    };
    const ExploreResult result = explore(terrain, setup, watch);
    EXPECT_NE(End::step_limit, result.end) << number;
    EXPECT_EQ(0U, result.most_unsafe_certified) << number;
    if (result.end == End::not_reachable || result.end == End::only_lipschitz) {
      ++ended;
      EXPECT_EQ(0U, left) << number;
    }
  }
  EXPECT_GT(ended, 15) << "the test needs goals that are not reachable";
}

TEST(CertifiedEnd, MeasuresNoCellTwice) {
  const Terrain terrain = field_of(60, 50, 3);
  ExploreSetup setup = setup_of(terrain, {8, 3}, {40, 30}, 1011.0);
  setup.rules.noise_bound = 5.0;
  setup.max_steps = 400;
  const ExploreResult result = explore(terrain, setup);
  std::set<std::pair<double, double>> cells;
  for (const ExploreStep& s : result.steps) {
    EXPECT_TRUE(cells.emplace(s.at.x(), s.at.y()).second)
        << "step " << s.step << " at " << s.at.transpose();
  }
  EXPECT_NE(End::step_limit, result.end);
  EXPECT_EQ(0U, result.most_unsafe_certified);
}

TEST(CertifiedEnd, IsSoundAndEndsWithNoisyMeasurements) {
  constexpr double kError = 5.0;
  std::size_t certified = 0;
  std::size_t steps = 0;
  for (std::uint64_t number = 0; number < 40; ++number) {
    const Terrain terrain = field_of(30, 24, 6, number);
    table::RandomStream random(6, 12, number);
    Cell robot = terrain.grid.cell(random.below(static_cast<std::uint32_t>(terrain.grid.size())));
    const ExploreSetup setup = setup_of(terrain, robot, robot, terrain.at(robot) - 30.0);
    Rules rules = setup.rules;
    rules.noise_bound = kError;
    Planner planner(terrain.grid, rules, setup.prior);
    for (;; ++steps) {
      // The bound's ends are the worst noise that is allowed.
      const double error = random.below(2) == 0 ? kError : -kError;
      planner.add({position(robot), terrain.at(robot) + error});
      const Plan& plan = planner.plan(std::nullopt, robot);
      for (std::size_t i = 0; i < terrain.grid.size(); ++i) {
        ASSERT_TRUE(planner.safe()[i] == 0 || terrain.values[i] >= rules.threshold) << number;
      }
      ASSERT_LE(planner.measurements().size(), terrain.grid.size()) << "does not end";
      if (!plan.next) {
        certified += plan.safe;
        break;
      }
      robot = *plan.next;
    }
    EXPECT_EQ(0, planner.contradictions());
    EXPECT_EQ(0U, cells_that_could_help(planner, robot));
  }
  EXPECT_GT(certified, 4000U);
  EXPECT_GT(steps, 400U);
}

}  // namespace
}  // namespace tcert::terrain
