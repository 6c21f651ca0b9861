#include <gtest/gtest.h>

#include <tcert/pending_pass.hpp>

namespace tcert {
namespace {

Evidence felt(double margin_m, double width_m, double radius_m) {
  Evidence evidence;
  evidence.margin_m = margin_m;
  evidence.width_m = width_m;
  evidence.turn_radius_m = radius_m;
  return evidence;
}

TEST(PendingPass, SummarisesByType7Quantiles) {
  PendingPass pass;
  pass.restart(felt(0.5, 1.0, 10.0));
  for (int k = 2; k <= 21; ++k) {
    pass.add(felt(0.5 - 0.01 * (k == 7 ? 9 : 0), k, 10.0 * k));
  }
  const Pass done = pass.finish();
  EXPECT_NEAR(done.margin_m, 0.41, 1e-15);
  EXPECT_EQ(done.width_m, 7.0);
  EXPECT_EQ(done.turn_radius_m, 70.0);
  EXPECT_EQ(done.width.min, 1.0);
  EXPECT_NEAR(done.width.p05, 2.0, 1e-12);
  EXPECT_NEAR(done.width.p50, 11.0, 1e-12);
  EXPECT_NEAR(done.width.p95, 20.0, 1e-12);
  EXPECT_EQ(done.turn_radius.max, 210.0);
}

TEST(PendingPass, StandingStillCostsNoMemoryAndKeepsTheEnds) {
  PendingPass pass;
  pass.restart(felt(0.5, 0.0, 0.0));
  for (int k = 1; k <= 100'000; ++k) {
    pass.add(felt(k == 77'777 ? -0.2 : 0.5, k, k));
  }
  const Pass done = pass.finish();
  EXPECT_EQ(done.margin_m, -0.2);
  EXPECT_EQ(done.width.min, 0.0);
  EXPECT_EQ(done.width.max, 100'000.0);
  EXPECT_NEAR(done.width.p50, 50'000.0, 2'000.0);
}

}  // namespace
}  // namespace tcert
