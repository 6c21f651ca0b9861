#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <tcert/barrier_law.hpp>
#include <vector>

#include "support/allocations.hpp"

namespace tcert {
namespace {

constexpr double kHalfWidth = 0.225;

Robot robot_of_test() {
  Robot robot;
  for (const double bearing_rad : {0.0, 0.8, -0.8, 1.57, -1.57}) {
    robot.rays.push_back({"ray", {0.1, 0.0}, bearing_rad, 0.8, RayKind::range, {}});
  }
  return robot;
}

SpeedLaw law_of_test() {
  SpeedLaw law;
  law.kind = SpeedLawKind::barrier;
  return law;
}

Tick tick_at(const Pose& pose, std::span<const RayReading> rays) {
  return {0, pose, rays, false, false};
}

TEST(FeltPoints, KeepsTipsOfWhatWasMetOverABodyWidth) {
  FeltPoints felt(robot_of_test(), {});
  std::array<RayReading, 5> rays{};
  rays.fill({0.8, kMissing, kMissing});
  rays[0].value = 0.3;
  felt.add(tick_at({{1.0, 0.0}, 0.0}, rays), 0.0);
  FeltPoints::Nearest near = felt.nearest({1.0, 0.0});
  ASSERT_EQ(near.count, 1U) << "rays at their reach met nothing";
  EXPECT_NEAR(near.points[0].x_m, 1.4, 1e-12);
  EXPECT_NEAR(felt.front_m(), 0.1 + 0.3 - kHalfWidth, 1e-12);
  rays[0].value = 0.8;
  felt.add(tick_at({{1.0, 0.0}, 0.0}, rays), 0.0);
  EXPECT_EQ(felt.nearest({1.0, 0.0}).count, 0U) << "the same place is looked at anew";
  rays[3].value = 0.2;
  for (int i = 1; i <= 100; ++i) {
    felt.add(tick_at({{1.0 + 0.02 * i, 0.0}, 0.0}, rays), 0.02 * i);
  }
  near = felt.nearest({3.0, 0.2});
  EXPECT_EQ(near.count, FeltPoints::kNearest);
  EXPECT_TRUE(std::is_sorted(near.distances_m.begin(), near.distances_m.end()));
  EXPECT_GE(felt.nearest({1.0, 0.2}).distances_m[0], 3.0 - 1.0 - 0.45 - 0.1);
}

TEST(FeltPoints, NearestAreThoseOfSortingAll) {
  FeltPoints felt(robot_of_test(), {});
  std::mt19937 random(4);
  std::uniform_real_distribution<double> clear(0.05, 0.7);
  std::vector<Point> all;
  for (int i = 0; i < 12; ++i) {
    std::array<RayReading, 5> rays{};
    for (RayReading& ray : rays) {
      ray.value = clear(random);
    }
    const Pose pose{{0.03 * i, 0.0}, 0.1 * i};
    felt.add(tick_at(pose, rays), 0.03 * i);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const Ray ray = robot_of_test().rays[k];
      all.push_back(transform(pose, ray.mount + rays[k].value * direction(ray.bearing_rad)));
    }
  }
  std::vector<double> distances;
  for (const Point& point : all) {
    distances.push_back(distance(point, {0.2, 0.1}));
  }
  std::sort(distances.begin(), distances.end());
  const FeltPoints::Nearest near = felt.nearest({0.2, 0.1});
  for (std::size_t i = 0; i < near.count; ++i) {
    EXPECT_NEAR(near.distances_m[i], distances[i], 1e-12);
  }
}

// Driven on and on at what the filter leaves, the body comes ever closer and never touches.
TEST(BarrierCommand, NeverTouchesWhatWasFelt) {
  for (const double bearing_rad : {0.0, 0.3, -0.6, 1.2}) {
    FeltPoints felt(robot_of_test(), {});
    std::array<RayReading, 5> rays{};
    rays.fill({0.8, kMissing, kMissing});
    rays[0].value = 0.4;
    rays[1].value = 0.5;
    Pose pose;
    felt.add(tick_at(pose, rays), 0.0);
    const std::vector<Point> points{{0.5, 0.0}, {0.1 + 0.5 * std::cos(0.8), 0.5 * std::sin(0.8)}};
    double nearest_m = 1.0;
    for (int i = 0; i < 400; ++i) {
      const Command wanted{0.22, 0.5 * bearing_rad};
      const FilteredCommand kept =
          barrier_command(wanted, felt, pose, kHalfWidth, 0.1, law_of_test());
      ASSERT_GE(kept.command.speed_mps, 0.0);
      ASSERT_LE(kept.command.speed_mps, 0.22);
      pose.yaw_rad += 0.1 * kept.command.yaw_rate_rps;
      pose.position = pose.position + 0.1 * kept.command.speed_mps * direction(pose.yaw_rad);
      if (std::abs(pose.yaw_rad) > 1.5) {
        break;
      }
      for (const Point& point : points) {
        nearest_m = std::min(nearest_m, distance(point, pose.position) - kHalfWidth);
      }
    }
    EXPECT_GE(nearest_m, -1e-9) << bearing_rad;
  }
}

TEST(BarrierCommand, LeavesAloneWhatIsFarAndWhatReverses) {
  FeltPoints felt(robot_of_test(), {});
  std::array<RayReading, 5> rays{};
  rays.fill({0.8, kMissing, kMissing});
  felt.add(tick_at({}, rays), 0.0);
  const FilteredCommand far = barrier_command({0.2, 0.1}, felt, {}, kHalfWidth, 0.1, law_of_test());
  EXPECT_EQ(far.command.speed_mps, 0.2);
  EXPECT_EQ(far.command.yaw_rate_rps, 0.1);
  rays[0].value = 0.01;
  felt.add(tick_at({}, rays), 0.0);
  const FilteredCommand back =
      barrier_command({-0.1, 0.0}, felt, {}, kHalfWidth, 0.1, law_of_test());
  EXPECT_EQ(back.command.speed_mps, -0.1);
  const FilteredCommand held =
      barrier_command({0.2, 0.0}, felt, {}, kHalfWidth, 0.1, law_of_test());
  EXPECT_FALSE(held.feasible) << "the body is on it already";
  EXPECT_EQ(held.command.speed_mps, 0.0);
}

TEST(BarrierCommand, AllocatesNothing) {
  FeltPoints felt(robot_of_test(), {});
  std::array<RayReading, 5> rays{};
  rays.fill({0.3, kMissing, kMissing});
  const std::size_t before = test_support::allocation_count();
  for (int i = 0; i < 500; ++i) {
    felt.add(tick_at({{0.01 * i, 0.0}, 0.0}, rays), 0.01 * i);
    static_cast<void>(
        barrier_command({0.2, 0.1}, felt, {{0.01 * i, 0.0}, 0.0}, kHalfWidth, 0.1, law_of_test()));
  }
  EXPECT_EQ(test_support::allocation_count(), before);
}

}  // namespace
}  // namespace tcert
