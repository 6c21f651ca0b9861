#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/proxies.hpp>

namespace tcert {
namespace {

constexpr double kSquare = 0.5 * std::numbers::pi;

// Feeds ticks by hand to a robot with a tentacle on each side and one ahead.
class Felt {
 public:
  explicit Felt(Robot robot, CertificateParameters parameters = {})
      : parameters_(parameters), proxies_(robot, parameters), memory_(parameters) {}

  LocalGeometry at(double travel_m,
                   double yaw_rad,
                   std::vector<RayReading> readings,
                   bool inside_start = false) {
    Tick tick;
    tick.pose = {{travel_m, 0.0}, yaw_rad};
    tick.rays = readings;
    return proxies_.update(tick, travel_m, travel_m, inside_start, memory_);
  }
  Proxies& proxies() { return proxies_; }

 private:
  CertificateParameters parameters_;
  Proxies proxies_;
  ContactMemory memory_;
};

Robot three_rays() {
  Robot robot;
  robot.rays = {{"left", {0.1, 0.05}, kSquare, 0.6, RayKind::range, {}},
                {"right", {0.1, -0.05}, -kSquare, 0.6, RayKind::range, {}},
                {"ahead", {0.3, 0.0}, 0.0, 0.6, RayKind::range, {}}};
  return robot;
}

std::vector<RayReading> readings(double left_m, double right_m, double ahead_m = 0.6) {
  return {{left_m, 0.0}, {right_m, 0.0}, {ahead_m, 0.0}};
}

TEST(Proxies, WidthIsLeftPlusRightWithTheMounts) {
  Felt felt(three_rays());
  const LocalGeometry local = felt.at(0.0, 0.0, readings(0.30, 0.20));
  EXPECT_NEAR(local.left_m, 0.35, 1e-15);
  EXPECT_NEAR(local.right_m, 0.25, 1e-15);
  EXPECT_NEAR(local.width_m, 0.60, 1e-15);
}

TEST(Proxies, TheReachOfEachSideIsThatOfItsShortestRay) {
  Robot robot = three_rays();
  robot.rays[1].reach_m = 0.4;
  Felt felt(robot);
  EXPECT_NEAR(felt.proxies().reach_width_m(), (0.05 + 0.6) + (0.05 + 0.4), 1e-12);
  robot.rays.push_back({"left again", {0.0, 0.1}, kSquare, 0.3, RayKind::range, {}});
  EXPECT_NEAR(Felt(robot).proxies().reach_width_m(), (0.1 + 0.3) + (0.05 + 0.4), 1e-12);
  robot.rays.erase(robot.rays.begin() + 1);
  EXPECT_NEAR(Felt(robot).proxies().reach_width_m(), (0.1 + 0.3) + 0.5 * 0.45, 1e-12)
      << "a side without a ray is half the body";
}

TEST(Proxies, RadialReadingIsTheDiscOnTheRobot) {
  CertificateParameters parameters;
  parameters.clearance = ClearanceReading::radial;
  Felt felt(three_rays(), parameters);
  EXPECT_NEAR(felt.at(0.0, 0.0, readings(0.30, 0.20)).width_m, 0.50, 1e-15);
}

TEST(Proxies, ASlantedRayCountsByWhatItReachesAcross) {
  Robot robot = three_rays();
  robot.rays[0].bearing_rad = kSquare - std::numbers::pi / 6.0 + 1e-9;  // 60 degrees
  Felt felt(robot);
  EXPECT_NEAR(felt.at(0.0, 0.0, readings(0.40, 0.2)).left_m, 0.05 + 0.40 * std::sqrt(0.75), 1e-8);
  robot.rays[0].bearing_rad = kSquare - std::numbers::pi / 6.0 - 1e-3;  // beyond 30 of square
  Felt blind(robot);
  EXPECT_EQ(blind.at(0.0, 0.0, readings(0.40, 0.2)).left_m, 0.225);
}

TEST(Proxies, RaysAtTheVeryEdgeOfASideCountOnBothEdges) {
  for (const double degrees : {60.0, 120.0}) {
    Robot robot = three_rays();
    robot.rays[0].bearing_rad = degrees * std::numbers::pi / 180.0;
    robot.rays[1].bearing_rad = -degrees * std::numbers::pi / 180.0;
    Felt felt(robot);
    EXPECT_NEAR(felt.at(0.0, 0.0, readings(0.40, 0.40)).width_m,
                2.0 * (0.05 + 0.40 * std::sqrt(0.75)),
                1e-12);
  }
}

TEST(Proxies, ASideWithoutARayIsHalfTheBody) {
  Robot robot = three_rays();
  robot.rays.erase(robot.rays.begin());
  Felt felt(robot);
  const LocalGeometry local = felt.at(0.0, 0.0, {{0.30, 0.0}, {0.6, 0.0}});
  EXPECT_EQ(local.left_m, 0.225);
  EXPECT_NEAR(local.right_m, 0.35, 1e-15);
}

TEST(Proxies, AMissingRayIsFlaggedAndNeverCredited) {
  Felt felt(three_rays());
  const LocalGeometry local = felt.at(0.0, 0.0, readings(kMissing, 0.30));
  EXPECT_TRUE(local.missing_ray);
  EXPECT_EQ(local.left_m, 0.225);
}

TEST(Proxies, SidesRememberTheLastBodyWidthOfTravelSeparately) {
  Felt felt(three_rays());
  felt.at(0.00, 0.0, readings(0.10, 0.40));
  felt.at(0.20, 0.0, readings(0.40, 0.15));
  LocalGeometry local = felt.at(0.40, 0.0, readings(0.50, 0.50));
  EXPECT_NEAR(local.width_m, (0.10 + 0.05) + (0.15 + 0.05), 1e-15);
  local = felt.at(0.60, 0.0, readings(0.50, 0.50));  // the left throat is 0.60 back
  EXPECT_NEAR(local.width_m, (0.40 + 0.05) + (0.15 + 0.05), 1e-15);
  felt.proxies().restart_windows();
  local = felt.at(0.61, 0.0, readings(0.50, 0.50));
  EXPECT_NEAR(local.width_m, 1.10, 1e-15);
}

TEST(Proxies, BendIsReadThroughTheCalibrationAndClamped) {
  Robot robot = three_rays();
  robot.rays[0].kind = RayKind::bend;
  robot.rays[0].calibration = {{0.0, 1.0}, {0.7, -0.1}};
  Felt felt(robot);
  EXPECT_NEAR(felt.at(0.0, 0.0, readings(0.5, 0.3)).left_m, 0.35, 1e-15);
  EXPECT_NEAR(felt.proxies().clearances()[0], 0.30, 1e-15);
  felt.at(1.0, 0.0, readings(0.0, 0.3));
  EXPECT_EQ(felt.proxies().clearances()[0], 0.6);  // the reach
  felt.at(2.0, 0.0, readings(1.0, 0.3));
  EXPECT_EQ(felt.proxies().clearances()[0], 0.0);
}

TEST(Proxies, PathRadiusIsTravelOverTurn) {
  Felt felt(three_rays());
  for (int k = 0; k <= 10; ++k) {
    felt.at(0.025 * k, 0.05 * k, readings(0.3, 0.3));
  }
  // 0.25 m back: 0.5 rad on 0.25 m.
  EXPECT_NEAR(felt.at(0.25, 0.5, readings(0.3, 0.3)).turn_radius_m, 0.5, 1e-12);
}

TEST(Proxies, PathRadiusNeedsTravel) {
  Felt felt(three_rays());
  felt.at(0.0, 0.0, readings(0.3, 0.3));
  EXPECT_EQ(felt.at(0.09, 1.0, readings(0.3, 0.3)).turn_radius_m, 1000.0);
  EXPECT_NEAR(felt.at(0.10, 1.0, readings(0.3, 0.3)).turn_radius_m, 0.10, 1e-12);
}

// Its side rays then look along the way, and what stands beside it is not felt.
TEST(Proxies, ARobotThatMovesAcrossItsHeadingGetsLessOfItsSides) {
  Robot robot = three_rays();
  robot.body_width_m = 0.3;
  const auto ends_at = [&](double off_heading_rad, double turn_rad) {
    Proxies proxies(robot, {});
    ContactMemory memory({});
    const auto felt = readings(0.3, 0.3);
    LocalGeometry local;
    double yaw_rad = 0.7;
    Point at;
    for (int k = 0; k <= 20; ++k) {
      local = proxies.update({k, {at, yaw_rad}, felt}, 0.02 * k, 0.0, false, memory);
      at = at + 0.02 * direction(yaw_rad + off_heading_rad + 0.5 * turn_rad);
      yaw_rad += turn_rad;
    }
    return local;
  };
  for (const double along : {0.0, std::numbers::pi, 0.15, -0.15, std::numbers::pi + 0.15}) {
    EXPECT_FALSE(ends_at(along, 0.0).across_heading) << along;
    EXPECT_NEAR(ends_at(along, 0.0).width_m, 0.7, 1e-12);
  }
  // The rays look askew over the way: what they reach square to it is less.
  for (const double askew : {0.2, -0.5, std::numbers::pi + 0.4}) {
    EXPECT_TRUE(ends_at(askew, 0.0).across_heading) << askew;
    EXPECT_NEAR(ends_at(askew, 0.0).width_m, 0.7 * std::abs(std::cos(askew)), 1e-12);
  }
  EXPECT_FALSE(ends_at(0.0, 0.1).across_heading) << "an arc of radius 0.2 m";
  // Four steps aside and two back, and a turn on the spot, whose chord tells nothing.
  Proxies proxies(robot, {});
  ContactMemory memory({});
  const auto felt = readings(0.3, 0.3);
  LocalGeometry local;
  double travel_m = 0.0;
  Point at;
  for (int k = 0; k < 30; ++k) {
    local = proxies.update({k, {at, kSquare}, felt}, travel_m, 0.0, false, memory);
    at.x_m += k % 6 < 4 ? 0.01 : -0.01;
    travel_m += 0.01;
  }
  EXPECT_EQ(local.width_m, robot.body_width_m);
  proxies.clear();
  for (int k = 0; k < 40; ++k) {
    const double along_m = 0.01 * std::min(k, 25);
    const double yaw_rad = 0.1 * std::max(k - 25, 0);
    local = proxies.update({k, {{along_m, 0.0}, yaw_rad}, felt}, along_m, 0.0, false, memory);
    EXPECT_FALSE(local.across_heading) << k;
  }
  for (const double across : {0.6, -0.6, kSquare, -kSquare, std::numbers::pi + 0.6}) {
    EXPECT_TRUE(ends_at(across, 0.0).across_heading) << across;
    EXPECT_EQ(ends_at(across, 0.0).width_m, robot.body_width_m);
  }
}

TEST(Proxies, TurningInsideTheStartIsNoEvidence) {
  Felt felt(three_rays());
  felt.at(0.0, 0.0, readings(0.3, 0.3), true);
  EXPECT_EQ(felt.at(0.12, 2.0, readings(0.3, 0.3), true).turn_radius_m, 1000.0);
  // The window begins at the last tick in S: 0.1 rad on 0.12 m, not 2.1 on 0.24.
  EXPECT_NEAR(felt.at(0.24, 2.1, readings(0.3, 0.3)).turn_radius_m, 1.2, 1e-12);
}

TEST(Proxies, AnAlternatingPathIsNotReadAsStraight) {
  // Arcs of 0.25 m that bend left and right by 0.6 rad each.
  Felt felt(three_rays());
  double yaw = 0.0;
  double smallest_m = 1000.0;
  for (int k = 0; k <= 80; ++k) {
    yaw += (k / 10) % 2 == 0 ? 0.06 : -0.06;
    smallest_m = std::min(smallest_m, felt.at(0.025 * k, yaw, readings(0.3, 0.3)).turn_radius_m);
  }
  EXPECT_NEAR(smallest_m, 0.25 / 0.6, 1e-9);
}

TEST(Proxies, ForceContactHasHysteresis) {
  Felt felt(three_rays());
  const auto force = [](double newton) {
    return std::vector<RayReading>{{0.3, newton}, {0.3, 0.0}, {0.6, 0.0}};
  };
  EXPECT_EQ(felt.at(0.0, 0.0, force(0.4)).contacts, 0U);
  EXPECT_EQ(felt.at(0.1, 0.0, force(0.5)).new_contacts, 1U);
  const LocalGeometry held = felt.at(0.2, 0.0, force(0.3));
  EXPECT_EQ(held.contacts, 1U);
  EXPECT_EQ(held.new_contacts, 0U);
  EXPECT_EQ(felt.at(0.3, 0.0, force(0.29)).contacts, 0U);
  EXPECT_EQ(felt.at(0.4, 0.0, force(0.4)).contacts, 0U);
}

TEST(Proxies, WithoutForceAShortRayIsAContact) {
  Felt felt(three_rays());
  const auto clear = [](double left_m) {
    return std::vector<RayReading>{{left_m, kMissing}, {0.6, kMissing}, {0.6, kMissing}};
  };
  EXPECT_EQ(felt.at(0.0, 0.0, clear(0.595)).contacts, 0U);
  EXPECT_EQ(felt.at(0.1, 0.0, clear(0.585)).contacts, 1U);
}

// Its calibration ends at 0.5 m of a reach of 0.6 m: free is 0.5 m, not what it never reads.
TEST(Proxies, ARayIsFreeAtTheLongestClearanceThatItCanState) {
  Robot robot = three_rays();
  Ray& left = robot.rays[0];
  left.kind = RayKind::bend;
  left.calibration = {{0.0, 1.0}, {0.5, 0.0}};
  Felt felt(robot);
  const auto bent = [](double rad) {
    return std::vector<RayReading>{{rad, kMissing}, {0.6, kMissing}, {0.6, kMissing}};
  };
  EXPECT_EQ(felt.at(0.0, 0.0, bent(0.0)).contacts, 0U);
  EXPECT_EQ(felt.at(0.1, 0.0, bent(0.1)).new_contacts, 1U);
  EXPECT_EQ(felt.at(0.2, 0.0, bent(0.0)).contacts, 0U);
}

TEST(Proxies, NoCurvatureReadingIsStraight) {
  CertificateParameters parameters;
  parameters.curvature = CurvatureReading::none;
  Felt felt(three_rays(), parameters);
  felt.at(0.0, 0.0, readings(0.3, 0.3));
  EXPECT_EQ(felt.at(0.2, 2.0, readings(0.3, 0.3)).turn_radius_m, 1000.0);
}

// A joint carries one ray from side to side.
Robot one_swept_ray() {
  Robot robot;
  robot.rays = {{"whisker", {0.1, 0.05}, 0.0, 0.6, RayKind::range, {}}};
  return robot;
}

TEST(Proxies, ASideIsWhatASweptRayLastFeltThere) {
  Felt felt(one_swept_ray());
  EXPECT_EQ(felt.at(0.0, 0.0, {{0.5, 0.0, 0.0}}).left_m, 0.225);  // it looks ahead
  EXPECT_NEAR(felt.at(0.02, 0.0, {{0.30, 0.0, kSquare}}).left_m, 0.225, 1e-15);
  Felt again(one_swept_ray());
  EXPECT_NEAR(again.at(0.0, 0.0, {{0.30, 0.0, kSquare}}).left_m, 0.35, 1e-15);
  const LocalGeometry local = again.at(0.02, 0.0, {{0.40, 0.0, -kSquare}});
  EXPECT_NEAR(local.left_m, 0.35, 1e-15);
  EXPECT_EQ(local.right_m, 0.225);  // nobody had looked there at the first tick
}

TEST(Proxies, AnOldLookIsForgottenOverTheSideWindow) {
  CertificateParameters parameters;
  parameters.side_window_m = 0.2;
  Felt felt(one_swept_ray(), parameters);
  felt.at(0.0, 0.0, {{0.30, 0.0, kSquare}});
  EXPECT_NEAR(felt.at(0.19, 0.0, {{0.5, 0.0, 0.0}}).left_m, 0.35, 1e-15);
  EXPECT_EQ(felt.at(0.21, 0.0, {{0.5, 0.0, 0.0}}).left_m, 0.225);
}

TEST(Proxies, ABearingThatIsNoneMakesTheReadingAMissingOne) {
  for (const double bearing : {90.0, -90.0, std::numeric_limits<double>::infinity()}) {
    Felt felt(one_swept_ray());
    felt.at(0.0, 0.0, {{0.30, 0.0, kSquare}});
    const LocalGeometry local = felt.at(0.02, 0.0, {{0.30, 0.0, bearing}});
    EXPECT_TRUE(local.missing_ray) << bearing;
    EXPECT_TRUE(std::isnan(felt.proxies().clearances()[0]));
  }
}

// Readings that state what is known anyway change no bit, and a cleared trial starts as mounted.
TEST(Proxies, ABearingThatIsTheMountsOwnChangesNothing) {
  Felt silent(three_rays());
  Felt stating(three_rays());
  for (int trial = 0; trial < 2; ++trial) {
    for (int i = 0; i < 200; ++i) {
      const double at = 0.013 * i;
      std::vector<RayReading> felt = readings(
          0.25 + 0.2 * std::sin(7.0 * at), 0.3 + 0.1 * std::cos(11.0 * at), i % 3 == 0 ? 0.2 : 0.6);
      const LocalGeometry a = silent.at(at, 0.1 * at, felt);
      for (std::size_t k = 0; k < felt.size(); ++k) {
        felt[k].bearing_rad = three_rays().rays[k].bearing_rad;
      }
      const LocalGeometry b = stating.at(at, 0.1 * at, felt);
      ASSERT_EQ(a.left_m, b.left_m);
      ASSERT_EQ(a.right_m, b.right_m);
      ASSERT_EQ(a.turn_radius_m, b.turn_radius_m);
      ASSERT_EQ(a.contacts, b.contacts);
    }
    stating.at(3.0, 0.0, {{0.3, 0.0, -kSquare}, {0.3, 0.0, 0.0}, {0.3, 0.0, 0.0}});
    silent.proxies().clear();
    stating.proxies().clear();
  }
}

}  // namespace
}  // namespace tcert
