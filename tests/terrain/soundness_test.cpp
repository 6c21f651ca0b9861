#include <gtest/gtest.h>

#include "analysis/study/terrain/terrain_soundness.hpp"

namespace tcert::terrain {
namespace {

TEST(Certified, HoldsNoUnsafeCellSafeInAThousandTerrains) {
  const study::Soundness found = study::soundness(1000, 1.0, false, 1);
  EXPECT_EQ(1000U, found.terrains);
  EXPECT_EQ(0U, found.with_unsafe_cells);
  EXPECT_EQ(0U, found.with_unsafe_visits);
  EXPECT_EQ(0U, found.contradicted);
  EXPECT_GT(found.reached, 250U);
  EXPECT_EQ(found.terrains, found.reached + found.not_reachable + found.limit);
}

TEST(Certified, SaysWhatAnUnderstatedConstantCosts) {
  const study::Soundness quarter = study::soundness(200, 0.75, false, 2);
  const study::Soundness half = study::soundness(200, 0.5, false, 2);
  RecordProperty("unsafe_25", static_cast<int>(quarter.with_unsafe_cells));
  RecordProperty("unsafe_50", static_cast<int>(half.with_unsafe_cells));
  EXPECT_LE(quarter.with_unsafe_cells, half.with_unsafe_cells);
  EXPECT_GE(quarter.with_unsafe_cells, 10U) << "the test must be able to see unsafe cells";
  EXPECT_GE(half.with_unsafe_cells, 50U);
  EXPECT_GT(half.contradicted, 0U) << "measurements contradict half the constant";
}

}  // namespace
}  // namespace tcert::terrain
