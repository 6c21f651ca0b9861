#include <gtest/gtest.h>

#include <tcert/region.hpp>

namespace tcert {
namespace {

TEST(Region, DiscHoldsItsBoundary) {
  const Region disc = Disc{{1.0, 2.0}, 0.5};
  EXPECT_TRUE(contains(disc, {1.5, 2.0}));
  EXPECT_FALSE(contains(disc, {1.500001, 2.0}));
}

TEST(Region, PolygonOfEitherWinding) {
  const Polygon l_shape{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  Polygon reversed = l_shape;
  std::swap(reversed.vertices[1], reversed.vertices[5]);
  std::swap(reversed.vertices[2], reversed.vertices[4]);
  for (const Region& region : {Region{l_shape}, Region{reversed}}) {
    EXPECT_TRUE(contains(region, {0.5, 1.5}));
    EXPECT_TRUE(contains(region, {1.5, 0.5}));
    EXPECT_FALSE(contains(region, {1.5, 1.5}));
    EXPECT_FALSE(contains(region, {-0.1, 0.5}));
  }
}

}  // namespace
}  // namespace tcert
