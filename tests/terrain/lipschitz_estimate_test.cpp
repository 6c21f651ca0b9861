#include <gtest/gtest.h>

#include <table/random.hpp>
#include <terrain/explore.hpp>
#include <terrain/lipschitz.hpp>

#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain {
namespace {

constexpr double kLengthScale = 8.0;

TEST(LipschitzEstimate, CoversAsStatedFromSpreadPlaces) {
  // Fields of one covariance: the constant is that of the field, not scaled to one.
  TerrainFieldOptions field;
  field.rows = 60;
  field.columns = 48;
  field.length_scale = 8.0;
  int covered = 0;
  constexpr int kRuns = 200;
  for (int run = 0; run < kRuns; ++run) {
    field.number = static_cast<std::uint64_t>(run);
    const TerrainGrid made = random_terrain(field);
    const Grid grid{made.rows, made.columns};
    table::RandomStream random(9, 1, field.number);
    std::vector<Measurement> measurements;
    // Within a corner of the field: what a robot knows early.
    for (int k = 0; k < 60; ++k) {
      const Cell c{static_cast<int>(random.below(30)), static_cast<int>(random.below(30))};
      measurements.push_back({position(c), made.values[grid.index(c)]});
    }
    const LipschitzEstimate estimate = estimate_lipschitz(grid, measurements, 8.0, 0.0, 0.9);
    covered += estimate.constant >= field.lipschitz ? 1 : 0;
  }
  EXPECT_GE(covered, 180);
  RecordProperty("covered_of_200", covered);
}

/// All cells within two of `start`, in rows: what is measured first.
std::vector<Measurement> disc_round(const Terrain& terrain, Cell start) {
  std::vector<Measurement> measurements;
  for (int x = start.x - 2; x <= start.x + 2; ++x) {
    for (int y = start.y - 2; y <= start.y + 2; ++y) {
      if (squared_distance({x, y}, start) <= 4.0) {
        measurements.push_back({position({x, y}), terrain.at({x, y})});
      }
    }
  }
  return measurements;
}

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

TEST(LipschitzEstimate, CoversAsStatedFromTheDiscRoundAStart) {
  // On multiples of the length scale and beside them: no lattice may split the disc.
  const std::vector<Cell> starts{{32, 16}, {32, 20}, {32, 24}, {16, 32}, {33, 17}, {29, 21}};
  constexpr int kRuns = 300;
  std::vector<int> covered_95(starts.size(), 0);
  std::vector<int> covered_99(starts.size(), 0);
  for (int run = 0; run < kRuns; ++run) {
    double lipschitz = 0.0;
    const Terrain terrain = field_of(static_cast<std::uint64_t>(run), lipschitz);
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const auto first = disc_round(terrain, starts[s]);
      const auto at = [&](double confidence) {
        const auto estimate =
            estimate_lipschitz(terrain.grid, first, kLengthScale, 0.0, confidence);
        EXPECT_EQ(1, estimate.patches);
        return estimate.constant;
      };
      covered_95[s] += at(0.95) >= lipschitz ? 1 : 0;
      covered_99[s] += at(0.99) >= lipschitz ? 1 : 0;
    }
  }
  for (std::size_t s = 0; s < starts.size(); ++s) {
    const std::string start = std::to_string(starts[s].x) + "_" + std::to_string(starts[s].y);
    RecordProperty("covered_95_of_300_from_" + start, covered_95[s]);
    RecordProperty("covered_99_of_300_from_" + start, covered_99[s]);
    EXPECT_GE(covered_95[s], 285) << start;
    EXPECT_GE(covered_99[s], 297) << start;
  }
}

TEST(LipschitzEstimate, CountsPlacesThatAreApart) {
  double lipschitz = 0.0;
  const Terrain terrain = field_of(1, lipschitz);
  const auto patches_of = [&](const std::vector<Cell>& starts) {
    std::vector<Measurement> all;
    for (const Cell start : starts) {
      const auto disc = disc_round(terrain, start);
      all.insert(all.end(), disc.begin(), disc.end());
    }
    return estimate_lipschitz(terrain.grid, all, kLengthScale, 0.0, 0.9).patches;
  };
  EXPECT_EQ(1, patches_of({{20, 20}, {25, 20}}));
  EXPECT_EQ(1, patches_of({{15, 20}, {34, 20}})) << "19 cells, less than three length scales";
  EXPECT_EQ(2, patches_of({{15, 20}, {45, 20}}));
  EXPECT_EQ(4, patches_of({{5, 5}, {35, 5}, {5, 35}, {35, 35}}));
}

TEST(LipschitzEstimate, SharesTheRiskOverARun) {
  double risk = 0.0;
  for (int k = 1; k < 30; ++k) {
    risk += 1.0 - confidence_of_estimate(0.95, k);
  }
  EXPECT_LE(risk, 0.05 + 1e-12);
  EXPECT_DOUBLE_EQ(0.975, confidence_of_estimate(0.95, 1));
}

TEST(LipschitzEstimate, IsNotLoweredOnTheWayAndCoversAllOfARun) {
  constexpr int kRuns = 100;
  int covered = 0;
  int ran = 0;
  for (int run = 0; run < kRuns; ++run) {
    double lipschitz = 0.0;
    const Terrain terrain = field_of(static_cast<std::uint64_t>(run), lipschitz);
    ExploreSetup setup;
    setup.start = {32, 24};
    setup.rules.threshold = terrain.at(setup.start) - 600.0;
    setup.rules.lipschitz = 1e-3;
    setup.lipschitz_confidence = 0.95;
    setup.prior = {terrain.at(setup.start), 1300.0, kLengthScale, 1.0};
    setup.max_steps = 60;
    for (const Measurement& m : disc_round(terrain, setup.start)) {
      if (!(m.at == position(setup.start))) {
        setup.first_cells.push_back(nearest_cell(m.at));
      }
    }
    const ExploreResult result = explore(terrain, setup);
    ran += result.steps.size() > 5 ? 1 : 0;
    bool all = true;
    for (std::size_t k = 0; k < result.steps.size(); ++k) {
      all = all && result.steps[k].lipschitz >= lipschitz;
      if (k > 0) {
        EXPECT_GE(result.steps[k].lipschitz, result.steps[k - 1].lipschitz);
      }
    }
    covered += all ? 1 : 0;
  }
  RecordProperty("covered_of_100", covered);
  EXPECT_GE(covered, 95);
  EXPECT_GT(ran, 50);
}

}  // namespace
}  // namespace tcert::terrain
