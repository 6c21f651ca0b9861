#include <gtest/gtest.h>

#include <cmath>
#include <federation/join.hpp>
#include <random>

namespace tcert::federation {
namespace {

const Agent kAgent{0.45, 0.35, 0.0, 0.0};

double join_margin(const JoinEnd& from,
                   const JoinEnd& to,
                   const FrameError& error,
                   const Agent& agent) {
  const std::optional<JoinShape> shape = join_shape(from.pose, to.pose, error, agent);
  return shape ? federation::join_margin(from, to, *shape)
               : -std::numeric_limits<double>::infinity();
}

TEST(JoinMargin, OfOnePlaceIsTheLesserMargin) {
  const Pose pose{{1.0, 2.0}, 0.3};
  EXPECT_EQ(join_margin({pose, 0.3}, {pose, 0.2}, {}, kAgent), 0.2);
}

TEST(JoinMargin, OfALaneThatGoesOnLosesItsLength) {
  const double margin = join_margin({{{}, 0.0}, 0.5}, {{{0.2, 0.0}, 0.0}, 0.6}, {}, kAgent);
  EXPECT_NEAR(margin, 0.55 - 0.2, 1e-15);
  // Far behind in margin, the lesser end itself.
  EXPECT_EQ(join_margin({{{}, 0.0}, 1.5}, {{{0.2, 0.0}, 0.0}, 0.1}, {}, kAgent), 0.1);
}

TEST(JoinMargin, OfALaneAsideByHand) {
  // l = 0.2, offset 0.02: kappa = 2 x 0.02 / (2 x 0.04) = 0.5, so 2 - 0.35 = 1.65 m of turn slack;
  // the slope is at most 0.5 x 0.5 x 0.4 = 0.1, the length 0.4 sqrt(1.01).
  const JoinEnd to{{{0.4, 0.02}, 0.0}, 2.0};
  EXPECT_NEAR(join_margin({{{}, 0.0}, 2.0}, to, {}, kAgent), 2.0 - 0.4 * std::sqrt(1.01), 1e-12);
  // A quarter of the way, sixteen times the curvature: a radius of 0.125 m, and 0.35 are needed.
  const JoinEnd near{{{0.1, 0.02}, 0.0}, 2.0};
  EXPECT_NEAR(join_margin({{{}, 0.0}, 2.0}, near, {}, kAgent), 0.125 - 0.35, 1e-12);
}

TEST(JoinMargin, BesideAnEdgeByHand) {
  // The way above leaves its line by at most kappa L^2 / 8 = 0.5 x 0.16 / 8 = 0.01 m; its further
  // end is 0.02 m off the edge along x, whose path is 0.005 m off its line.
  const Pose from{{}, 0.0};
  const Pose to{{0.4, 0.02}, 0.0};
  const std::optional<JoinShape> shape = join_shape(from, to, {}, kAgent);
  ASSERT_TRUE(shape);
  const Stretch edge{{0.0, 0.0}, {0.5, 0.0}, 0.3, 0.005};
  EXPECT_NEAR(
      margin_beside(from, to, *shape, &edge, nullptr), 0.3 - 2.0 * (0.02 + 0.01 + 0.005), 1e-12);
  const Stretch wide{{0.0, 0.0}, {0.5, 0.0}, 9.0, 0.0};
  EXPECT_NEAR(margin_beside(from, to, *shape, &wide, nullptr), 2.0 - 0.35, 1e-12) << "the turn";
  const Stretch half{{0.0, 0.0}, {0.2, 0.0}, 0.3, 0.005};
  EXPECT_NEAR(margin_beside(from, to, *shape, &half, nullptr),
              0.3 - 2.0 * (std::hypot(0.2, 0.02) + 0.01 + 0.005),
              1e-12)
      << "beyond its end";
  // The rest lies beside an edge of the other robot. Changed over at 3/8 of the way, it is 0.0075 m
  // off the one and 0.0125 m off the other, whose spread is less by as much as that.
  const Stretch other{{0.1, 0.02}, {0.4, 0.02}, 0.3, 0.0};
  EXPECT_NEAR(margin_beside(from, to, *shape, &half, &other), 0.255, 1e-12);
  EXPECT_NEAR(margin_beside(from, to, *shape, nullptr, &other),
              0.3 - 2.0 * (std::hypot(0.1, 0.02) + 0.01),
              1e-12);
}

TEST(JoinMargin, NeedsWhatIsAhead) {
  EXPECT_LT(join_margin({{{}, 0.0}, 1.0}, {{{-0.1, 0.0}, 0.0}, 1.0}, {}, kAgent), 0.0);
  EXPECT_LT(join_margin({{{}, 0.0}, 1.0}, {{{0.0, 0.0}, 0.0}, 1.0}, {0.01, 0.0}, kAgent), 0.0);
  EXPECT_LT(join_margin({{{}, 0.0}, 1.0}, {{{0.2, 0.1}, 1.2}, 1.0}, {}, kAgent), 0.0);
}

TEST(JoinMargin, FallsWithTheErrorOfTheFrame) {
  const JoinEnd from{{{}, 0.0}, 1.0};
  const JoinEnd to{{{0.4, 0.02}, 0.1}, 1.0};
  double before = join_margin(from, to, {}, kAgent);
  for (int i = 1; i < 20; ++i) {
    const double now = join_margin(from, to, {0.002 * i, 0.001 * i}, kAgent);
    EXPECT_LT(now, before);
    before = now;
  }
}

/// The change of lanes itself, for one place that the second end may have: y'' = k up to t, then
/// -k, in the frame of the first.
struct Change {
  double length_m = 0.0;
  double curvature = 0.0;
  double bow_m = 0.0;
};

Change drive(double ahead_m, double aside_m, double slope) {
  // y(L) = k t^2 / 2 + k t (L - t) - k (L - t)^2 / 2 with t = (L + s / k) / 2: both roots of k.
  const double offset = aside_m - 0.5 * ahead_m * slope;
  const double l = 0.5 * ahead_m;
  const double size = (std::abs(offset) + std::hypot(offset, l * slope)) / (2.0 * l * l);
  Change best{1e9, 1e9, 1e9};
  for (const double k : {size, -size}) {
    const double t = k == 0.0 ? ahead_m : 0.5 * (ahead_m + slope / k);
    Change change;
    double y = 0.0;
    double dy = 0.0;
    constexpr int kSteps = 2000;
    const double h = ahead_m / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) * h;
      const double ddy = x < t ? k : -k;
      const double mid = dy + 0.5 * h * ddy;
      change.curvature = std::max(change.curvature, std::abs(ddy) / std::pow(1 + mid * mid, 1.5));
      change.length_m += h * std::sqrt(1.0 + mid * mid);
      y += h * mid;
      change.bow_m = std::max(change.bow_m, std::abs(y - (x + 0.5 * h) * aside_m / ahead_m));
      dy += h * ddy;
    }
    if (std::abs(y - aside_m) < 2e-3 * ahead_m && std::abs(dy - slope) < 2e-2) {
      best = change;
    }
  }
  return best;
}

TEST(JoinMargin, IsNoMoreThanThatOfAnyWayWithinTheErrorOfTheFrame) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int joined = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Pose from{{uniform(-3, 3), uniform(-3, 3)}, uniform(-3, 3)};
    const double off_m = uniform(0.0, 0.03);
    const double off_rad = uniform(0.0, 0.05);
    const Point local{uniform(0.05, 0.9), uniform(-0.1, 0.1)};
    const Pose to{transform(from, local), from.yaw_rad + uniform(-0.5, 0.5)};
    const double margin_m = uniform(0.5, 2.0);
    const double stated = join_margin({from, margin_m}, {to, margin_m}, {off_m, off_rad}, kAgent);
    if (!(stated > -0.3)) {
      continue;
    }
    ++joined;
    const double angle = uniform(-3.2, 3.2);
    const Pose true_to{to.position + uniform(0.0, off_m) * direction(angle),
                       to.yaw_rad + uniform(-0.5, 0.5) * off_rad};
    const Pose true_from{from.position, from.yaw_rad + uniform(-0.5, 0.5) * off_rad};
    const Point way = true_to.position - true_from.position;
    const Point heading = direction(true_from.yaw_rad);
    const Change change = drive(
        dot(way, heading), cross(heading, way), std::tan(true_to.yaw_rad - true_from.yaw_rad));
    ASSERT_LT(change.length_m, 1e8);
    const std::optional<JoinShape> shape = join_shape(from, to, {off_m, off_rad}, kAgent);
    ASSERT_LE(change.bow_m, shape->bow_m + 1e-9);
    ASSERT_LE(change.length_m, shape->length_m + 1e-9);
    const double felt = std::min(margin_m - change.length_m, 1.0 / change.curvature - 0.35);
    ASSERT_LE(stated, felt + 1e-9);
  }
  EXPECT_GT(joined, 5'000);
}

}  // namespace
}  // namespace tcert::federation
