#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <tcert/policy.hpp>

#include "lib/policies/felt_run.hpp"

namespace tcert::policies {
namespace {

// Adding 0 turns -0 into 0, which is its own image.
Command image(const Command& command) { return {command.speed_mps, -command.yaw_rate_rps + 0.0}; }

// Right value 2. Two policies run side by side, one on the other's senses in the mirror.
TEST(Policies, MirroredSensesGiveTheMirroredCommandsBitForBit) {
  constexpr int kSteps = 10'000;
  for (const PolicyKind kind : kAllPolicies) {
    SCOPED_TRACE(name_of(kind));
    std::uint64_t turns = 0;
    std::uint64_t reversals = 0;
    std::size_t lobes = 0;
    std::uint64_t backing = 0;
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
      SCOPED_TRACE(seed);
      PolicySetup setup = two_lobes();
      setup.robot.min_turn_radius_m = seed % 2 == 0 ? 0.35 : 0.0;
      Policy policy(kind, setup);
      Policy reflection(kind, mirrored(setup));
      FeltRun run(seed, setup.robot.rays.size());
      Command last;
      for (int step = 0; step < kSteps; ++step) {
        last = policy.step(run.next(last));
        ASSERT_TRUE(same_bits(image(last), reflection.step(run.mirrored_senses())))
            << "step " << step << ": " << last.speed_mps << ", " << last.yaw_rate_rps;
        turns += last.yaw_rate_rps != 0.0 ? 1 : 0;
        reversals += last.speed_mps < 0.0 ? 1 : 0;
        lobes = std::max(lobes, policy.line().lobe());
        backing += policy.line().backing_out() ? 1 : 0;
      }
    }
    // The run was one in which all of it came into play.
    EXPECT_GT(turns, 1000U);
    EXPECT_GT(reversals, 100U);
    EXPECT_GT(backing, 100U);
    EXPECT_GE(lobes, 1U);
  }
}

// Right value 3.
void expect_equal_commands(PolicyKind one, const PolicySetup& setup, PolicyKind other) {
  for (const std::uint32_t seed : {1U, 2U}) {
    Policy first(one, setup);
    Policy second(other, setup);
    FeltRun run(seed, setup.robot.rays.size());
    Command last;
    for (int step = 0; step < 10'000; ++step) {
      const Senses& senses = run.next(last);
      last = first.step(senses);
      ASSERT_TRUE(same_bits(last, second.step(senses))) << "seed " << seed << ", step " << step;
    }
  }
}

TEST(Policies, M3WithoutMemoryIsM1BitForBit) {
  PolicySetup setup = two_lobes();
  setup.parameters.risk_weight = 0.0;
  expect_equal_commands(PolicyKind::m3, setup, PolicyKind::m1);
}

TEST(Policies, M2WithoutTerrainIsM1BitForBit) {
  PolicySetup setup = two_lobes();
  setup.parameters.terrain_weight_per_rad2 = setup.parameters.terrain_slowing_per_rad2 = 0.0;
  expect_equal_commands(PolicyKind::m2, setup, PolicyKind::m1);
}

TEST(Policies, TheirTermsDoSomething) {
  PolicySetup setup = two_lobes();
  setup.parameters.risk_weight = 3.0;
  for (const PolicyKind kind : {PolicyKind::m2,
                                PolicyKind::m3,
                                PolicyKind::tvfh,
                                PolicyKind::td_star_lite,
                                PolicyKind::cb_v}) {
    Policy first(PolicyKind::m1, setup);
    Policy second(kind, setup);
    FeltRun run(1, setup.robot.rays.size());
    Command last;
    int differ = 0;
    for (int step = 0; step < 5'000; ++step) {
      const Senses& senses = run.next(last);
      last = first.step(senses);
      differ += same_bits(last, second.step(senses)) ? 0 : 1;
    }
    EXPECT_GT(differ, 100) << name_of(kind);
  }
}

}  // namespace
}  // namespace tcert::policies
