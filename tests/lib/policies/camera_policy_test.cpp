#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <tcert/camera_policy.hpp>

#include "lib/policies/felt_run.hpp"

namespace tcert::policies {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kAhead = 0 - HeadingCosts::kLowest;

TEST(SeenRays, AreTheNearestSightingsOfTheirSectors) {
  const std::array sightings{
      Sighting{0.05, 0.6}, Sighting{-0.1, 0.45}, Sighting{0.3, 0.3}, Sighting{0.0, 2.0}};
  const SeenRays rays = seen_rays(sightings, 0.9);
  EXPECT_NEAR(rays[kAhead].depth, 0.5, 1e-15);
  EXPECT_NEAR(rays[kAhead + 1].depth, 2.0 / 3.0, 1e-15);
  EXPECT_TRUE(std::isnan(rays[kAhead - 1].depth)) << "nothing seen";
  EXPECT_NEAR(deepest(rays), 2.0 / 3.0, 1e-15);
}

TEST(SeenRays, LeaveOutWhatIsNoSighting) {
  const std::array sightings{Sighting{kNaN, 0.1},
                             Sighting{0.0, kNaN},
                             Sighting{std::numeric_limits<double>::infinity(), 0.1},
                             Sighting{0.0, 0.9}};
  for (const FeltRay& ray : seen_rays(sightings, 0.9)) {
    EXPECT_TRUE(std::isnan(ray.depth));
  }
  const std::array inside{Sighting{3.14159265, -1.0}, Sighting{-3.14159265, 0.5}};
  EXPECT_EQ(seen_rays(inside, 0.9).back().depth, 1.0);
}

TEST(CameraPolicy, TurnsFromWhatItSeesAndNotFromWhatItFeels) {
  PolicySetup setup = two_lobes();
  setup.line.lobes.clear();
  CameraPolicy policy(setup);
  Senses senses;
  senses.goal = {2.0, 0.0};
  const std::vector<RayReading> deep(setup.robot.rays.size(), RayReading{1.1, 1.0});
  senses.tick.rays = deep;
  const Command blind = policy.step(senses);
  EXPECT_EQ(blind.speed_mps, setup.parameters.cruise_mps);
  EXPECT_EQ(blind.yaw_rate_rps, 0.0);
  const std::array near{Sighting{0.05, 0.2}, Sighting{0.3, 0.2}, Sighting{0.5, 0.2}};
  senses.camera = near;
  const Command seeing = policy.step(senses);
  EXPECT_LT(seeing.speed_mps, setup.parameters.cruise_mps);
  EXPECT_LT(seeing.yaw_rate_rps, 0.0) << "away from the left";
}

}  // namespace
}  // namespace tcert::policies
