#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <vector>

#include "analysis/study/terrain/terrain_soundness.hpp"

namespace tcert::terrain {
namespace {

study::Soundness soundness(std::size_t terrains, double told, std::uint64_t seed) {
  std::vector<study::TerrainOutcome> outcomes(terrains);
  tbb::parallel_for(std::size_t{0}, terrains, [&](std::size_t i) {
    outcomes[i] = study::explore_terrain({told}, seed, i);
  });
  study::Soundness sum;
  for (const study::TerrainOutcome& one : outcomes) {
    sum.add(one);
  }
  return sum;
}

TEST(Certified, HoldsNoUnsafeCellSafeInAThousandTerrains) {
  const study::Soundness found = soundness(1000, 1.0, 1);
  EXPECT_EQ(1000U, found.terrains);
  EXPECT_EQ(0U, found.with_unsafe_cells);
  EXPECT_EQ(0U, found.with_unsafe_visits);
  EXPECT_EQ(0U, found.contradicted);
  EXPECT_GT(found.reached, 250U);
  EXPECT_EQ(found.terrains, found.reached + found.not_reachable + found.limit);
}

TEST(Certified, SaysWhatAnUnderstatedConstantCosts) {
  const study::Soundness quarter = soundness(200, 0.75, 2);
  const study::Soundness half = soundness(200, 0.5, 2);
  RecordProperty("unsafe_25", static_cast<int>(quarter.with_unsafe_cells));
  RecordProperty("unsafe_50", static_cast<int>(half.with_unsafe_cells));
  EXPECT_LE(quarter.with_unsafe_cells, half.with_unsafe_cells);
  EXPECT_GE(quarter.with_unsafe_cells, 10U) << "the test must be able to see unsafe cells";
  EXPECT_GE(half.with_unsafe_cells, 50U);
  EXPECT_GT(half.contradicted, 0U) << "measurements contradict half the constant";
}

}  // namespace
}  // namespace tcert::terrain
