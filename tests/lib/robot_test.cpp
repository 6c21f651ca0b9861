#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <tcert/robot.hpp>

namespace tcert {
namespace {

TEST(Calibration, IsLinearBetweenKnotsAndFlatBeyond) {
  const Calibration table{{0.0, 0.5, 1.0}, {0.6, 0.3, 0.0}};
  EXPECT_EQ(calibrated_clearance(table, -1.0), 0.6);
  EXPECT_EQ(calibrated_clearance(table, 0.0), 0.6);
  EXPECT_NEAR(calibrated_clearance(table, 0.25), 0.45, 1e-15);
  EXPECT_NEAR(calibrated_clearance(table, 0.75), 0.15, 1e-15);
  EXPECT_EQ(calibrated_clearance(table, 2.0), 0.0);
}

TEST(Calibration, InvertsWhereItIsStrict) {
  const Calibration falling{{0.0, 0.5, 1.0}, {0.6, 0.3, 0.0}};
  const Calibration rising{{0.0, 0.5, 1.0}, {0.0, 0.1, 0.6}};
  for (const double clearance_m : {0.0, 0.05, 0.1, 0.3, 0.45, 0.6}) {
    EXPECT_NEAR(
        calibrated_clearance(falling, calibrated_bend(falling, clearance_m)), clearance_m, 1e-15);
    EXPECT_NEAR(
        calibrated_clearance(rising, calibrated_bend(rising, clearance_m)), clearance_m, 1e-15);
  }
}

TEST(Calibration, InvertsALevelStretchAtItsBeginning) {
  const Calibration falling{{0.0, 0.2, 0.4, 0.6}, {0.5, 0.3, 0.3, 0.1}};
  EXPECT_EQ(calibrated_bend(falling, 0.3), 0.2);
  const Calibration rising{{0.0, 0.2, 0.4, 0.6}, {0.1, 0.3, 0.3, 0.5}};
  EXPECT_EQ(calibrated_bend(rising, 0.3), 0.2);
  EXPECT_NEAR(calibrated_bend(rising, 0.4), 0.5, 1e-15);
}

TEST(Calibration, EndsTheReachOfItsRay) {
  Ray ray{"left", {}, 1.57, 0.6, RayKind::bend, {{0.0, 0.5}, {0.4, 0.0}}};
  EXPECT_EQ(longest_clearance(ray), 0.4);
  ray.calibration = {{0.0, 0.5}, {0.0, 0.5}};
  EXPECT_EQ(longest_clearance(ray), 0.5);
  ray.reach_m = 0.3;
  EXPECT_EQ(longest_clearance(ray), 0.3);
  ray.kind = RayKind::range;
  ray.calibration = {};
  EXPECT_EQ(longest_clearance(ray), 0.3);
}

TEST(Robot, RefusesWhatNoRobotCanBe) {
  Robot robot;
  EXPECT_NO_THROW(validate(robot));
  robot.body_width_m = 0.0;
  EXPECT_THROW(validate(robot), std::invalid_argument);
  robot.body_width_m = 0.45;
  robot.rays = {{"left", {}, 1.57, 0.6, RayKind::bend, {{0.0, 0.5}, {0.6, 0.3, 0.0}}}};
  EXPECT_THROW(validate(robot), std::invalid_argument);
  robot.rays[0].calibration = {{0.0, 0.0}, {0.6, 0.3}};
  EXPECT_THROW(validate(robot), std::invalid_argument);
  robot.rays[0].calibration = {{0.0, 0.5, 1.0}, {0.6, 0.3, 0.4}};
  EXPECT_THROW(validate(robot), std::invalid_argument);
  robot.rays[0].calibration = {{0.0, 0.5, 1.0}, {0.6, 0.3, 0.3}};
  EXPECT_NO_THROW(validate(robot));
  robot.rays[0].bearing_rad = 90.0;  // degrees
  EXPECT_THROW(validate(robot), std::invalid_argument);
}

TEST(Course, RefusesRegionsThatAreNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(validate(Course{}));
  EXPECT_NO_THROW(validate(Course{Disc{{}, 0.5}, Polygon{{{1, 0}, {2, 0}, {1, 1}}}}));
  for (const Region& region : {Region(Disc{{}, 0.0}),
                               Region(Disc{{kNaN, 0.0}, 1.0}),
                               Region(Disc{{}, kNaN}),
                               Region(Polygon{{{0, 0}, {1, 0}}}),
                               Region(Polygon{{{0, 0}, {1, 0}, {0, kNaN}}})}) {
    EXPECT_THROW(validate(Course{region, {}}), std::invalid_argument);
    EXPECT_THROW(validate(Course{{}, region}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace tcert
