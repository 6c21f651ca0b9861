/// Runs whose every number is worked out by hand: absolute values, where most tests of the
/// certifier compare it with itself.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/bottleneck.hpp>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>
#include <vector>

namespace tcert {
namespace {

constexpr double kNoPath = -std::numeric_limits<double>::infinity();
constexpr double kStep = 0.05;

/// A body 0.4 m wide that turns at 0.2 m, with a ray to each side 0.1 m out that reaches 1 m. A
/// force of 0 is no contact.
Robot robot_of_test() {
  Robot robot;
  robot.body_width_m = 0.4;
  robot.min_turn_radius_m = 0.2;
  robot.rays = {{"left", {0.0, 0.1}, 0.5 * std::numbers::pi, 1.0, RayKind::range, {}},
                {"right", {0.0, -0.1}, -0.5 * std::numbers::pi, 1.0, RayKind::range, {}}};
  return robot;
}

/// Along y = 0 from x = 0 to 2.2 between walls at y = 0.45 and -0.35; from x = 1.0 to 1.1 the left
/// one stands at 0.30. `at` is where the frame of the log has x = 0.
struct Corridor {
  explicit Corridor(Point at, std::optional<Region> start)
      : origin(at), certifier(robot_of_test(), {start, Disc{at + Point{2.12, 0.0}, 0.1}}, {}) {}

  CertifiedTick next(double force_n = 0.0) {
    const double x_m = kStep * static_cast<double>(count);
    const bool in_gate = count >= 20 && count <= 22;
    readings = {{{in_gate ? 0.20 : 0.35, force_n}, {0.25, 0.0}}};
    return certifier.update(
        {100'000'000 * count++, {origin + Point{x_m, 0.0}, 0.0}, readings, false, false});
  }

  Point origin;
  Certifier certifier;
  std::int64_t count = 0;
  std::array<RayReading, 2> readings;
};

void expect_the_corridor(Corridor& corridor) {
  CertifiedTick now;
  while (corridor.count < 20) {
    now = corridor.next();
    // 0.45 + 0.35 less the body; straight, so that the turn radius is 1000 m.
    ASSERT_NEAR(now.left_m, 0.45, 1e-12);
    ASSERT_NEAR(now.right_m, 0.35, 1e-12);
    ASSERT_NEAR(now.margin_m, 0.40, 1e-12);
    ASSERT_NEAR(now.corridor_value_m, 0.40, 1e-12);
    ASSERT_NEAR(now.travel_m, kStep * static_cast<double>(corridor.count - 1), 1e-12);
    ASSERT_EQ(now.certificate_m, kNoPath);
    ASSERT_NEAR(series_value(now), 0.40, 1e-12) << "V before there is T";
    ASSERT_EQ(now.turn_radius_m, 1000.0);
    // Along a ray: what it says less the whole body.
    ASSERT_NEAR(corridor.certifier.ray_margins()[0], -0.05, 1e-12);
    ASSERT_NEAR(corridor.certifier.ray_margins()[1], -0.15, 1e-12);
  }
  now = corridor.next();
  EXPECT_NEAR(now.left_m, 0.30, 1e-12);
  EXPECT_NEAR(now.margin_m, 0.25, 1e-12);
  EXPECT_NEAR(corridor.certifier.ray_margins()[0], -0.20, 1e-12);
  // The left side remembers the gate over the last body width of travel, up to x = 1.5.
  while (corridor.count <= 30) {
    now = corridor.next();
    ASSERT_NEAR(now.margin_m, 0.25, 1e-12) << corridor.count;
  }
  while (corridor.count <= 40) {
    now = corridor.next();
    ASSERT_NEAR(now.margin_m, 0.40, 1e-12) << corridor.count;
    ASSERT_NEAR(now.corridor_value_m, 0.25, 1e-12) << "but the way back leads through it";
    ASSERT_EQ(now.flags, 0U);
  }
  EXPECT_EQ(now.certificate_m, kNoPath) << "x = 2.0 is short of G by 2 cm";
  EXPECT_EQ(corridor.certifier.bottleneck(), std::nullopt);
  EXPECT_EQ(now.nodes, 9U) << "one each quarter of a metre";
  EXPECT_EQ(now.edges, 8U);
  now = corridor.next();
  EXPECT_NEAR(now.certificate_m, 0.25, 1e-12) << "the first tick in G joins it";
  EXPECT_NEAR(series_value(now), 0.25, 1e-12);
  EXPECT_TRUE(now.issued);
  EXPECT_EQ(now.flags, flag_goal_reached);
  EXPECT_EQ(now.nodes, 10U);
  // Edge e runs from x = e/4 to (e + 1)/4 with both its ends: 3 to 6 hold ticks of the gate. Seen
  // from G the first of the narrowest is 6, whose first tick, at 1.5, still remembers it.
  const auto bottleneck = corridor.certifier.bottleneck();
  ASSERT_TRUE(bottleneck.has_value());
  EXPECT_EQ(bottleneck->edge, 6U);
  EXPECT_NEAR(bottleneck->pose.position.x_m, corridor.origin.x_m + 1.5, 1e-12);
  EXPECT_NEAR(bottleneck->width_m, 0.65, 1e-12);
  EXPECT_NEAR(bottleneck->margin_m, 0.25, 1e-12);
  EXPECT_EQ(bottleneck->turn_radius_m, 1000.0);
  const auto edges = corridor.certifier.graph().edges();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const bool narrow = e >= 3 && e <= 6;
    EXPECT_NEAR(edges[e].pass.margin_m, narrow ? 0.25 : 0.40, 1e-12) << e;
    EXPECT_NEAR(edges[e].pass.width.min, narrow ? 0.65 : 0.80, 1e-12) << e;
    EXPECT_NEAR(edges[e].pass.width.max, e == 4 || e == 5 ? 0.65 : 0.80, 1e-12) << e;
  }
}

TEST(HandWorked, ACorridorWithAGate) {
  Corridor corridor({}, Disc{{0.0, 0.0}, 0.1});
  expect_the_corridor(corridor);
}

TEST(HandWorked, ACourseWithoutAStartBeginsRoundItsFirstTickWhereverThatIs) {
  Corridor corridor({50.0, -30.0}, std::nullopt);
  expect_the_corridor(corridor);
}

TEST(HandWorked, ARunThatBeginsOutsideOfSNeverHasACertificate) {
  Corridor corridor({}, Disc{{0.0, 0.5}, 0.4});
  while (corridor.count < 44) {
    const CertifiedTick now = corridor.next();
    ASSERT_EQ(now.certificate_m, kNoPath);
    ASSERT_EQ(now.corridor_value_m, kNoPath);
    ASSERT_NE(now.flags & flag_start_outside, 0U);
    ASSERT_FALSE(now.issued);
  }
}

// One touch of the cap's force at (0, 0.45): the cell that holds it raises M to
// 0.1 exp(-d^2 / 2 sigma^2). Under the body, 0.2 m round the robot, the nearest centres to it are
// (+-0.05, 0.15): 0.05^2 + 0.30^2 = 0.0925, sigma 0.15.
TEST(HandWorked, WhatIsTouchedIsRememberedWhereItIs) {
  Corridor corridor({}, Disc{{0.0, 0.0}, 0.1});
  CertifiedTick now = corridor.next(5.0);
  const double expected = 0.1 * std::exp(-0.0925 / (2.0 * 0.15 * 0.15));
  EXPECT_NEAR(now.memory, expected, 1e-12);
  EXPECT_EQ(now.contacts, 1U);
  EXPECT_EQ(now.new_contacts, 1U);
  EXPECT_NEAR(now.corridor_value_m, 0.40 - 0.05 * expected, 1e-12) << "lambda is 0.05 m";
  // It halves in 20 s, and has no cell on the other side.
  const std::array<RayReading, 2> readings{{{0.35, 0.0}, {0.25, 0.0}}};
  now = corridor.certifier.update({20'000'000'000, {}, readings, false, false});
  EXPECT_NEAR(now.memory, 0.5 * expected, 1e-12);
  EXPECT_EQ(now.contacts, 0U);
}

// A circle of 0.5 m in a wide room: the chord of a tick is 1.0 sin(a / 2) long and turns by a.
TEST(HandWorked, ATurnLeavesWhatIsOverOfTheRadius) {
  Robot robot = robot_of_test();
  robot.curvature_buffer_per_m = 0.25;
  Certifier certifier(robot, {}, {});
  const std::array<RayReading, 2> readings{{{1.0, 0.0}, {1.0, 0.0}}};
  constexpr double kTurn = 0.1;
  CertifiedTick now;
  for (int k = 0; k < 20; ++k) {
    const double a = kTurn * k;
    const Pose pose{{0.5 * std::sin(a), 0.5 - 0.5 * std::cos(a)}, a};
    now = certifier.update({100'000'000 * k, pose, readings, false, false});
  }
  const double radius_m = std::sin(0.5 * kTurn) / kTurn;
  EXPECT_NEAR(now.turn_radius_m, radius_m, 1e-12);
  EXPECT_NEAR(now.margin_m, 1.0 / (1.0 / radius_m + 0.25) - 0.2, 1e-12);
  EXPECT_NEAR(now.travel_m, 19.0 * std::sin(0.5 * kTurn), 1e-12);
}

}  // namespace
}  // namespace tcert
