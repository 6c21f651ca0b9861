#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tcert/speed_left.hpp>
#include <tcert/speed_profile.hpp>
#include <vector>

namespace tcert {
namespace {

// The same by relaxing one place after another until nothing changes.
std::vector<double> relaxed(std::vector<double> v, double step_m, double now, double a, double b) {
  v[0] = std::min(v[0], now);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k + 1 < v.size(); ++k) {
      const double up = std::sqrt(v[k] * v[k] + 2.0 * a * step_m);
      const double down = std::sqrt(v[k + 1] * v[k + 1] + 2.0 * b * step_m);
      if (v[k + 1] > up || v[k] > down) {
        v[k + 1] = std::min(v[k + 1], up);
        v[k] = std::min(v[k], down);
        changed = true;
      }
    }
  }
  return v;
}

TEST(SpeedProfile, TwoPassesAreAsGoodAsAnyNumber) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> limit(0.0, 0.3);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> speeds(1 + static_cast<std::size_t>(i) % 40);
    std::ranges::generate(speeds, [&] { return limit(random); });
    const std::vector<double> slow = relaxed(speeds, 0.02, 0.1, 0.5, 1.0);
    limit_profile(speeds, 0.02, 0.1, 0.5, 1.0);
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      ASSERT_NEAR(speeds[k], slow[k], 1e-12);
    }
  }
}

TEST(SpeedProfile, BrakesForWhatIsNotExplored) {
  SpeedLaw law;
  law.kind = SpeedLawKind::profile;
  // From v the body brakes to v_min within the way ahead: v^2 = 0.08^2 + 2 * 1 * left.
  const double v = profile_speed(law, 0.22, 0.03, 0.22, 0.1);
  EXPECT_NEAR(v, std::sqrt(0.0064 + 2.0 * (0.03 - 0.022)), 1e-12);
  EXPECT_EQ(profile_speed(law, 0.22, 0.0, 0.22, 0.1), law.min_speed_mps) << "never 0";
  EXPECT_EQ(profile_speed(law, 0.22, 10.0, 0.22, 0.1), 0.22);
  EXPECT_NEAR(profile_speed(law, 0.22, 10.0, 0.10, 0.1), 0.15, 1e-12) << "gains 0.5 m/s^2";
  EXPECT_EQ(profile_speed(law, 0.0, 10.0, 0.10, 0.1), 0.0) << "no margin is known";
}

// What counts by remembering everything.
TEST(SpeedLeft, IsTheLargestThatStillCounts) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> speed(0.0, 0.3);
  struct Left {
    double speed_mps, hold_s;
    std::int64_t from_ns;
  };
  SpeedLeft left;
  std::vector<Left> all;
  std::int64_t now_ns = 0;
  for (int i = 0; i < 5000; ++i) {
    now_ns += 50'000'000;
    double expected = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool is_last = k + 1 == all.size();
      const double since_s =
          is_last ? 0.0 : 1e-9 * static_cast<double>(now_ns - all[k + 1].from_ns);
      if (since_s <= all[k].hold_s) {
        expected = std::max(expected, all[k].speed_mps);
      }
    }
    ASSERT_EQ(left.at(now_ns), expected) << i;
    // As the double integrator has it: the faster, the longer.
    const double next = i % 7 == 0 ? 0.0 : speed(random);
    all.push_back({next, next / 1.0, now_ns});
    left.command(next, next / 1.0, now_ns);
    if (all.size() > 40) {
      all.erase(all.begin());
    }
  }
}

TEST(SpeedLeft, ANewRunHasLeftNothing) {
  SpeedLeft left;
  left.command(0.2, 10.0, 0);
  left.command(0.0, 0.0, 100);
  EXPECT_EQ(left.at(200), 0.2);
  left.reset();
  EXPECT_EQ(left.at(300), 0.0);
}

}  // namespace
}  // namespace tcert
