#include "datasets/driven/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "datasets/driven/scripted.hpp"

namespace tcert {
namespace {

using driven_test::box;

/// A wall 2 m ahead of the origin, and one far beyond the range.
WallIndex two_walls() {
  World world;
  world.bounds = {{-5.0, -5.0}, {8.0, 5.0}};
  world.obstacles = {box({2.0, -4.0}, {2.2, 0.5}), box({7.0, -4.0}, {7.2, 4.0})};
  return {world, 2.5};
}

Camera camera_of(const DriveParameters& parameters, Lighting lighting) {
  return {parameters, two_walls(), lighting, false, table::RandomStream(1, 0x7465'0008, 0)};
}

DriveParameters sharp_eyed() {
  DriveParameters parameters;
  parameters.seen_indoor = 1.0;
  parameters.camera_heading_sd_indoor_rad = 0.0;
  return parameters;
}

// 13 directions, 5 degrees apart from 30 to -30. The wall ends at y = 0.5, 14 degrees to the left,
// and at 2 / cos 30 = 2.31 m it is within range on the right.
TEST(Camera, SeesTheWallsWithinItsFanAndRange) {
  Camera camera = camera_of(sharp_eyed(), Lighting::indoor);
  const auto seen = camera.look(0, {});
  ASSERT_EQ(seen.size(), 9U);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double bearing = (10.0 - 5.0 * static_cast<double>(i)) * std::numbers::pi / 180.0;
    EXPECT_NEAR(seen[i].bearing_rad, bearing, 1e-12);
    EXPECT_NEAR(seen[i].range_m, 2.0 / std::cos(bearing), 1e-12);
  }
}

TEST(Camera, KeepsAFrameUntilTheNext) {
  Camera camera = camera_of(sharp_eyed(), Lighting::indoor);
  EXPECT_EQ(camera.look(0, {}).size(), 9U);
  EXPECT_EQ(camera.look(99'000'000, {{0.0, 0.0}, std::numbers::pi}).size(), 9U);
  EXPECT_EQ(camera.look(100'000'000, {{0.0, 0.0}, std::numbers::pi}).size(), 0U);
}

// 9 directions with a wall, each seen on its own: a binomial of 9 n. The offset of a frame is one
// number of the declared spread.
TEST(Camera, SeesWithTheProbabilityAndTheNoiseOfItsLighting) {
  const DriveParameters parameters;
  constexpr int kFrames = 2000;
  for (const auto& [lighting, share, sd] :
       {std::tuple{Lighting::dark, parameters.seen_dark, 0.12},
        std::tuple{Lighting::indoor, parameters.seen_indoor, 0.04},
        std::tuple{Lighting::outdoor, parameters.seen_outdoor, 0.07}}) {
    Camera camera = camera_of(parameters, lighting);
    std::size_t seen = 0;
    double sum2 = 0.0;
    int frames = 0;
    for (int i = 0; i < kFrames; ++i) {
      const auto frame = camera.look(100'000'000LL * i, {});
      seen += frame.size();
      double offset = std::numeric_limits<double>::quiet_NaN();
      for (const policies::Sighting& sighting : frame) {
        const double bearing = std::acos(2.0 / sighting.range_m);  // to the left or to the right
        const double left = sighting.bearing_rad - bearing;
        const double right = sighting.bearing_rad + bearing;
        if (std::isnan(offset) && bearing < 1e-4) {
          offset = left;
        } else if (!std::isnan(offset)) {
          EXPECT_TRUE(std::abs(left - offset) < 1e-9 || std::abs(right - offset) < 1e-6);
        }
      }
      if (!std::isnan(offset)) {
        sum2 += offset * offset;
        ++frames;
      }
    }
    const double n = 9.0 * kFrames;
    EXPECT_NEAR(static_cast<double>(seen), n * share, 4.0 * std::sqrt(n * share * (1.0 - share)));
    EXPECT_NEAR(std::sqrt(sum2 / frames), sd, 4.0 * sd / std::sqrt(2.0 * frames));
  }
}

}  // namespace
}  // namespace tcert
