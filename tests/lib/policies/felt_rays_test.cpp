#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <tcert/felt_rays.hpp>

namespace tcert::policies {
namespace {

Robot robot() {
  Robot made;
  made.rays = {{"front", {0.2, 0.0}, 0.0, 0.5, RayKind::bend, {{0.0, 0.5, 1.0}, {0.4, 0.3, 0.0}}},
               {"left", {0.0, 0.1}, 0.5 * std::numbers::pi, 0.5, RayKind::range, {}}};
  return made;
}

TEST(RayReader, ReadsDepthThroughTheCalibration) {
  RayReader reader(robot(), {});
  const std::array<RayReading, 2> readings{{{0.5, 0.0}, {0.2, kMissing}}};
  const auto rays = reader.read(readings);
  ASSERT_EQ(rays.size(), 2U);
  // The calibration ends at 0.4 m, short of the reach.
  EXPECT_NEAR(rays[0].clearance_m, 0.3, 1e-15);
  EXPECT_NEAR(rays[0].depth, 0.25, 1e-15);
  EXPECT_NEAR(rays[0].tip().x_m, 0.5, 1e-15);
  EXPECT_NEAR(rays[1].depth, 0.6, 1e-15);
  EXPECT_NEAR(rays[1].tip().y_m, 0.3, 1e-15);
  EXPECT_NEAR(deepest(rays), 0.6, 1e-15);
  EXPECT_NEAR(left_excess(rays), 0.6, 1e-12);
}

TEST(RayReader, KeepsDepthWithinItsRange) {
  RayReader reader(robot(), {});
  for (const double value : {-1e300, -1.0, 0.0, 2.0, 1e300}) {
    const std::array<RayReading, 2> readings{{{value, 0.0}, {value, 0.0}}};
    for (const FeltRay& ray : reader.read(readings)) {
      EXPECT_GE(ray.depth, 0.0);
      EXPECT_LE(ray.depth, 1.0);
    }
  }
}

TEST(RayReader, ContactIsByForceWithHysteresis) {
  RayReader reader(robot(), {});  // on at 0.5 N, off below 0.3 N
  const auto touches = [&](double force_n) {
    const std::array<RayReading, 2> readings{{{0.9, force_n}, {0.5, 0.0}}};
    return reader.read(readings)[0].contact;
  };
  EXPECT_FALSE(touches(0.4)) << "deep, but without force it is no contact";
  EXPECT_TRUE(touches(0.5));
  EXPECT_TRUE(touches(0.4));
  EXPECT_FALSE(touches(0.2));
  EXPECT_FALSE(touches(0.4));
  reader.reset();
  EXPECT_FALSE(touches(0.4));
}

TEST(RayReader, WithoutAForceSensorContactIsByClearance) {
  RayReader reader(robot(), {});
  const std::array<RayReading, 2> free{{{0.0, 0.0}, {0.495, kMissing}}};
  EXPECT_FALSE(reader.read(free)[1].contact);
  const std::array<RayReading, 2> near{{{0.0, 0.0}, {0.485, kMissing}}};
  EXPECT_TRUE(reader.read(near)[1].contact);
}

TEST(RayReader, WhatIsMissingIsNotFelt) {
  RayReader reader(robot(), {});
  const auto rays = reader.read({});
  ASSERT_EQ(rays.size(), 2U);
  EXPECT_TRUE(std::isnan(rays[0].depth));
  EXPECT_FALSE(rays[0].contact);
  EXPECT_EQ(deepest(rays), 0.0);
  EXPECT_EQ(left_excess(rays), 0.0);
  EXPECT_TRUE(std::isnan(frontal_force(rays, 0.5)));
}

TEST(FrontalForce, IsThatOfTheRaysAhead) {
  RayReader reader(robot(), {});
  const std::array<RayReading, 2> readings{{{0.9, 3.0}, {0.1, 7.0}}};
  EXPECT_EQ(frontal_force(reader.read(readings), 0.5), 3.0);
  EXPECT_EQ(frontal_force(reader.read(readings), -1.0), 7.0);
}

}  // namespace
}  // namespace tcert::policies
