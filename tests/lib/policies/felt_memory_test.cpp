#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <tcert/felt_memory.hpp>
#include <tcert/headings.hpp>
#include <vector>

#include "lib/policies/felt_run.hpp"

namespace tcert::policies {
namespace {

FeltRay touching(double bearing_rad, double clearance_m, double force_n) {
  FeltRay ray;
  ray.ahead = unit(bearing_rad);
  ray.mount = 0.1 * ray.ahead;
  ray.clearance_m = clearance_m;
  ray.force_n = force_n;
  ray.contact = true;
  return ray;
}

struct Felt {
  explicit Felt(const PolicySetup& setup) : memory(setup) {}

  void take(const Pose& pose, const std::vector<FeltRay>& rays, int side) {
    Outlook now;
    now.body = BodyFrame::of(pose);
    now.rays = rays;
    now.side = side;
    senses.tick.time_ns += 100'000'000;
    memory.take(now, senses);
  }

  FeltMemory memory;
  Senses senses;
};

PolicySetup every_step() {
  PolicySetup setup = two_lobes();
  setup.parameters.memory_period_s = setup.control_period_s;
  return setup;
}

// Both sides and the front reach the same cells, so that the order in which they are added shows in
// the last bits; forces and clearances are often the same, as those of rounded logs are.
TEST(FeltMemory, MirroredContactsLeaveTheMirroredMemoryBitForBit) {
  Felt felt(every_step());
  Felt image(every_step());
  std::mt19937 engine(5);
  const auto some = [&](std::uint32_t n) { return 0.1 * static_cast<double>(engine() % n + 1); };
  for (int step = 0; step < 2'000; ++step) {
    const Pose pose{{1e-3 * static_cast<double>(engine() % 1000), 0.0137}, 0.31};
    const FeltRay left = touching(1.5, some(3), some(3));
    const FeltRay right = touching(-1.5, some(3), some(3));
    const FeltRay front = touching(0.0, some(3), some(3));
    const int side = engine() % 2 == 0 ? 1 : -1;
    felt.take(pose, {left, right, front}, side);
    const auto reflected = [](const FeltRay& ray, double bearing_rad) {
      return touching(bearing_rad, ray.clearance_m, ray.force_n);
    };
    image.take({{pose.position.x_m, -pose.position.y_m}, -pose.yaw_rad},
               {reflected(right, 1.5), reflected(left, -1.5), reflected(front, 0.0)},
               -side);
    for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
      const Point u = unit(0.31 + HeadingCosts::turn_rad(k));
      ASSERT_EQ(
          felt.memory.mean_along(pose.position, u, 0.6),
          image.memory.mean_along({pose.position.x_m, -pose.position.y_m}, {u.x_m, -u.y_m}, 0.6))
          << "step " << step << ", heading " << k;
    }
  }
}

TEST(FeltMemory, TakesTheContactsOfEveryTenthOfASecond) {
  Felt felt(two_lobes());  // control at 50 Hz
  const std::vector<FeltRay> rays{touching(0.0, 0.2, 5.0)};
  const auto at_tip = [&] { return felt.memory.largest_within({0.3, 0.0}, 0.08); };
  felt.take({}, rays, 1);
  const double once = at_tip();
  EXPECT_GT(once, 0.05);
  for (int step = 0; step < 4; ++step) {
    felt.take({}, rays, 1);
    EXPECT_LT(at_tip(), once) << "it only fades";
  }
  felt.take({}, rays, 1);
  EXPECT_GT(at_tip(), once);
  felt.memory.reset();
  EXPECT_EQ(at_tip(), 0.0);
}

TEST(FeltMemory, RemembersWhereTheBodyTouched) {
  Felt felt(two_lobes());
  Outlook now;
  now.bump = Point{0.2, 0.1};
  felt.senses.bump = Bump{0.4, 50.0};
  felt.memory.take(now, felt.senses);
  EXPECT_GT(felt.memory.largest_within({0.2, 0.1}, 0.08), 0.05);
}

}  // namespace
}  // namespace tcert::policies
