#include "analysis/study/driven/arm.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tcert::study {
namespace {

TEST(Arm, IsReadFromItsName) {
  SpeedLaw law;
  law.beta_per_m = 7.0;
  const Arm plain = parse_arm("TD*Lite", law);
  EXPECT_EQ(plain.policy, policies::PolicyKind::td_star_lite);
  EXPECT_FALSE(plain.law);
  const Arm gated = parse_arm("M3+clip12.5+guards", law);
  EXPECT_EQ(gated.law.value().kind, SpeedLawKind::clip);
  EXPECT_EQ(gated.law->beta_per_m, 12.5);
  EXPECT_TRUE(gated.guards);
  EXPECT_EQ(parse_arm("M3+squash", law).law.value().beta_per_m, 7.0);
  EXPECT_EQ(parse_arm("M3+guards", law).law.value().beta_per_m, 7.0);
  EXPECT_TRUE(parse_arm("M3+A1", law).without_memory);
  EXPECT_EQ(parse_arms("M1,M3+squash20,CB-V", law).size(), 3U);
}

TEST(Arm, RefusesWhatItDoesNotKnow) {
  for (const char* const wrong : {"",
                                  "M4",
                                  "m3",
                                  "M3+",
                                  "M3+squash+clip",
                                  "M3+guards+squash20",
                                  "M3+A1+A1",
                                  "M3+squash-1",
                                  "M3+squash5x",
                                  "M3+squash1e99",
                                  "M1,,M2",
                                  "M1,M1"}) {
    EXPECT_THROW(static_cast<void>(parse_arms(wrong, {})), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace tcert::study
