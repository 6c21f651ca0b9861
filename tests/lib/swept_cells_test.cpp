#include <gtest/gtest.h>

#include <random>
#include <set>
#include <tcert/swept_cells.hpp>
#include <utility>

namespace tcert {
namespace {

TEST(SweptCells, HoldWhatASetHolds) {
  std::mt19937 engine(1);
  const auto cell = [&engine] { return static_cast<std::int32_t>(engine() % 60) - 30; };
  SweptCells cells(1U << 14U);
  for (int round = 0; round < 3; ++round) {
    std::set<std::pair<std::int32_t, std::int32_t>> marked;
    for (int k = 0; k < 40; ++k) {
      const std::int32_t iy = cell();
      const std::int32_t first = cell();
      const std::int32_t last = first + static_cast<std::int32_t>(engine() % 20) - 3;
      cells.mark_run(iy, first, last);
      for (std::int32_t ix = first; ix <= last; ++ix) {
        marked.insert({ix, iy});
      }
    }
    for (std::int32_t iy = -32; iy < 32; ++iy) {
      for (std::int32_t ix = -50; ix < 50; ++ix) {
        ASSERT_EQ(cells.contains({ix, iy}), marked.count({ix, iy}) == 1) << ix << ", " << iy;
      }
    }
    EXPECT_FALSE(cells.full());
    cells.clear();
  }
}

TEST(SweptCells, SaySoWhenThereIsNoRoomAndMarkNothingElse) {
  SweptCells cells(64 * 16);
  for (std::int32_t block = 0; block < 40; ++block) {
    cells.mark({8 * block, 0});
  }
  EXPECT_TRUE(cells.full());
  int marked = 0;
  for (std::int32_t ix = 0; ix < 8 * 40; ++ix) {
    marked += cells.contains({ix, 0}) ? 1 : 0;
    EXPECT_FALSE(cells.contains({ix, 1}));
  }
  EXPECT_EQ(marked, 16);
  cells.clear();
  EXPECT_FALSE(cells.full());
  EXPECT_FALSE(cells.contains({0, 0}));
}

}  // namespace
}  // namespace tcert
