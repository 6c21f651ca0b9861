#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <tcert/policy.hpp>

#include "lib/policies/felt_run.hpp"
#include "support/allocations.hpp"

namespace tcert::policies {
namespace {

double radius_of(std::uint32_t seed) { return seed % 2 == 0 ? 0.35 : 0.0; }

TEST(Policies, CommandsAreBoundedWhateverIsSensed) {
  for (const PolicyKind kind : kAllPolicies) {
    SCOPED_TRACE(name_of(kind));
    for (const std::uint32_t seed : {5U, 6U}) {
      PolicySetup setup = two_lobes();
      setup.robot.min_turn_radius_m = radius_of(seed);
      const double radius_m = setup.robot.min_turn_radius_m;
      const PolicyParameters& p = setup.parameters;
      Policy policy(kind, setup);
      FeltRun run(seed, setup.robot.rays.size(), true);
      Command last;
      for (int step = 0; step < 10'000; ++step) {
        last = policy.step(run.next(last));
        ASSERT_LE(std::abs(last.speed_mps), p.cruise_mps) << "step " << step;
        ASSERT_LE(std::abs(last.yaw_rate_rps), p.max_yaw_rate_rps) << "step " << step;
        // Of the rounding of a quotient.
        ASSERT_GE(std::abs(last.speed_mps) * (1.0 + 1e-15), radius_m * std::abs(last.yaw_rate_rps));
      }
    }
  }
}

TEST(Policies, HaltWithoutUsableSenses) {
  const PolicySetup setup = two_lobes();
  for (const PolicyKind kind : kAllPolicies) {
    SCOPED_TRACE(name_of(kind));
    Policy policy(kind, setup);
    Senses senses;
    senses.goal = {2.2, 0.3};
    senses.tick.pose = {{-1.5, 0.0}, 0.3};
    EXPECT_GT(policy.step(senses).speed_mps, 0.0) << "rays that are missing are not felt";
    senses.tick.stale = true;
    EXPECT_TRUE(same_bits(policy.step(senses), Command{}));
    senses.tick.stale = false;
    senses.tick.pose.yaw_rad = kMissing;
    EXPECT_TRUE(same_bits(policy.step(senses), Command{}));
    senses.tick.pose = {{2.0 * kLargestPose, 0.0}, 0.3};
    EXPECT_TRUE(same_bits(policy.step(senses), Command{}));
  }
}

TEST(Policies, AllocateNothingAfterConstruction) {
  const PolicySetup setup = two_lobes();
  for (const PolicyKind kind : kAllPolicies) {
    Policy policy(kind, setup);
    FeltRun run(7, setup.robot.rays.size());
    Command last;
    for (int step = 0; step < 5'000; ++step) {
      const Senses& senses = run.next(last);
      const std::size_t before = test_support::allocation_count();
      last = policy.step(senses);
      if (step % 1000 == 999) {
        policy.reset();
      }
      ASSERT_EQ(test_support::allocation_count(), before) << name_of(kind) << ", step " << step;
    }
  }
}

TEST(Policies, AResetOneAndACopyDriveAsAFreshOne) {
  const PolicySetup setup = two_lobes();
  for (const PolicyKind kind : kAllPolicies) {
    SCOPED_TRACE(name_of(kind));
    Policy used(kind, setup);
    FeltRun before(8, setup.robot.rays.size());
    Command last;
    for (int step = 0; step < 3'000; ++step) {
      last = used.step(before.next(last));
    }
    Policy copy = used;
    used.reset();
    Policy fresh(kind, setup);
    FeltRun run(9, setup.robot.rays.size());
    last = {};
    for (int step = 0; step < 3'000; ++step) {
      const Senses& senses = run.next(last);
      last = fresh.step(senses);
      ASSERT_TRUE(same_bits(last, used.step(senses))) << "step " << step;
      copy.step(senses);
      if (step == 1'000) {
        copy = fresh;
      }
    }
    const Senses& senses = run.next(last);
    EXPECT_TRUE(same_bits(fresh.step(senses), copy.step(senses)));
  }
}

TEST(Policies, HaveTheNamesOfThePaper) {
  for (const PolicyKind kind : kAllPolicies) {
    EXPECT_EQ(policy_named(name_of(kind)), kind);
    EXPECT_EQ(Policy(kind, two_lobes()).kind(), kind);
  }
  EXPECT_EQ(name_of(PolicyKind::td_star_lite), "TD*Lite");
  EXPECT_EQ(policy_named("M4"), std::nullopt);
}

TEST(PolicySetup, RefusesWhatNoPolicyCanUse) {
  const auto refuses = [](auto change) {
    PolicySetup setup = two_lobes();
    change(setup);
    EXPECT_THROW(Policy(PolicyKind::m1, setup), std::invalid_argument);
  };
  refuses([](PolicySetup& s) { s.parameters.cruise_mps = 0.0; });
  refuses([](PolicySetup& s) { s.parameters.caution = 1.0; });
  refuses([](PolicySetup& s) { s.parameters.vfh_min_speed_mps = 0.2; });
  refuses([](PolicySetup& s) { s.parameters.stall_moved_m = 0.2; });
  refuses([](PolicySetup& s) { s.parameters.vfh_reach_m = 10.0; });
  refuses([](PolicySetup& s) { s.parameters.lookahead_m = 10.0; });
  refuses([](PolicySetup& s) { s.control_period_s = 0.0; });
  refuses([](PolicySetup& s) { s.robot.rays.resize(65, s.robot.rays.front()); });
  refuses([](PolicySetup& s) { s.robot.body_width_m = -1.0; });
  refuses([](PolicySetup& s) { s.line.high = s.line.low; });
  PolicySetup large = two_lobes();
  large.parameters.max_policy_cells = 1000;
  EXPECT_NO_THROW(Policy(PolicyKind::m3, large));
  EXPECT_THROW(Policy(PolicyKind::tvfh, large), std::invalid_argument);
  EXPECT_THROW(Policy(PolicyKind::td_star_lite, large), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::policies
