#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <tcert/certainty_grid.hpp>

#include "lib/policies/felt_run.hpp"

namespace tcert::policies {
namespace {

int certainty(const CertaintyGrid& grid, Point p) {
  return grid.certainties()[grid.grid().index(grid.grid().cell_at(p))];
}

// A ray that looks ahead from the body's centre.
FeltRay ahead(double clearance_m, bool contact) {
  FeltRay ray;
  ray.ahead = {1.0, 0.0};
  ray.clearance_m = clearance_m;
  ray.contact = contact;
  return ray;
}

TEST(CourseGrid, MirroredPointsLieInMirroredCells) {
  const CourseGrid grid(two_lobes());
  for (int i = -30; i <= 30; ++i) {
    const GridCell up = grid.cell_at({0.3, 0.025 * i});
    const GridCell down = grid.cell_at({0.3, -0.025 * i});
    EXPECT_EQ(up.y, -down.y) << i;
  }
  EXPECT_EQ(grid.cell_at({0.024, -0.024}), (GridCell{0, 0}));
  EXPECT_EQ(grid.cell_at({0.026, -0.076}), (GridCell{1, -2}));
}

TEST(CourseGrid, HoldsItsBoxAndNoMore) {
  const CourseGrid grid(two_lobes());
  EXPECT_EQ(grid.cells(), 93U * 73U);  // 91 x 71 of the box, one more on each side
  for (std::uint32_t i = 0; i < grid.cells(); ++i) {
    ASSERT_EQ(grid.index(grid.cell(i)), i);
  }
  EXPECT_EQ(grid.index(grid.cell_at({-2.2, 0.0})), CourseGrid::kOutside);
  EXPECT_EQ(grid.index(grid.cell_at({0.0, 1e9})), CourseGrid::kOutside);
  EXPECT_EQ(grid.clamped(grid.cell_at({1e9, -1e9})), (GridCell{51, -31}));
}

TEST(CertaintyGrid, RisesByThreeAndFallsByOne) {
  CertaintyGrid grid(two_lobes());
  Outlook now;
  const std::array touching{ahead(0.6, true)};
  now.rays = touching;
  for (const int expected : {3, 6, 9, 12, 15, 15}) {
    grid.take(now);
    EXPECT_EQ(certainty(grid, {0.6, 0.0}), expected);
    EXPECT_EQ(certainty(grid, {0.5, 0.0}), 0);
  }
  const std::array passing{ahead(0.8, false)};
  now.rays = passing;
  for (const int expected : {14, 13, 12}) {
    grid.take(now);
    EXPECT_EQ(certainty(grid, {0.6, 0.0}), expected);
    EXPECT_EQ(certainty(grid, {0.8, 0.0}), 0) << "without contact there is nothing at the tip";
  }
  grid.reset();
  EXPECT_EQ(certainty(grid, {0.6, 0.0}), 0);
}

TEST(CertaintyGrid, TheBodyCoversWhatIsFree) {
  CertaintyGrid grid(two_lobes());
  Outlook now;
  now.bump = Point{0.225, 0.0};
  grid.take(now);
  EXPECT_EQ(certainty(grid, {0.225, 0.0}), 3);
  now.body.origin = {0.2, 0.1};
  now.bump.reset();
  grid.take(now);
  EXPECT_EQ(certainty(grid, {0.225, 0.0}), 2);
}

TEST(CertaintyGrid, SaysWhichCellsItTouched) {
  CertaintyGrid grid(two_lobes());
  Outlook now;
  const std::array touching{ahead(0.6, true)};
  now.rays = touching;
  grid.take(now);
  ASSERT_EQ(grid.touched().size(), 1U);
  EXPECT_EQ(grid.touched()[0], grid.grid().index({12, 0}));
}

TEST(CertaintyGrid, WhatLiesOutsideIsNotHeld) {
  CertaintyGrid grid(two_lobes());
  Outlook now;
  now.body.origin = {2.4, 1.9};
  const std::array touching{ahead(0.6, true)};
  now.rays = touching;
  now.bump = Point{1e8, -1e8};
  grid.take(now);
  EXPECT_TRUE(grid.touched().empty());
}

}  // namespace
}  // namespace tcert::policies
