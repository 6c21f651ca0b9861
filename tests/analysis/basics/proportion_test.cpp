#include "analysis/basics/proportion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tcert {
namespace {

TEST(Proportion, TheUpperBoundWithoutASuccessIsClosed) {
  // (1 - p)^n = 0.05.
  EXPECT_NEAR(clopper_pearson_upper(0, 60, 0.95), 1.0 - std::pow(0.05, 1.0 / 60.0), 1e-15);
  EXPECT_EQ(clopper_pearson_upper(7, 7, 0.95), 1.0);
}

TEST(Proportion, AgreesWithR) {
  // binom.test(7, 60, alternative = "less"), binom.test(53, 60), prop.test(53, 60, correct = FALSE)
  EXPECT_NEAR(clopper_pearson_upper(7, 60, 0.95), 0.207990937190798, 1e-12);
  const Interval exact = clopper_pearson_interval(53, 60, 0.95);
  EXPECT_NEAR(exact.low, 0.774283846854352, 1e-12);
  EXPECT_NEAR(exact.high, 0.951785158128658, 1e-12);
  const Interval wilson = wilson_interval(53, 60, 0.95);
  EXPECT_NEAR(wilson.low, 0.778212119758291, 1e-12);
  EXPECT_NEAR(wilson.high, 0.942322793599440, 1e-12);
}

TEST(Proportion, StaysWithinZeroAndOne) {
  EXPECT_EQ(wilson_interval(0, 5, 0.95).low, 0.0);
  EXPECT_EQ(wilson_interval(5, 5, 0.95).high, 1.0);
  EXPECT_EQ(clopper_pearson_interval(0, 5, 0.95).low, 0.0);
  EXPECT_EQ(clopper_pearson_interval(5, 5, 0.95).high, 1.0);
}

TEST(Proportion, RefusesWhatIsNone) {
  EXPECT_THROW((void)wilson_interval(1, 0, 0.95), std::invalid_argument);
  EXPECT_THROW((void)wilson_interval(3, 2, 0.95), std::invalid_argument);
  EXPECT_THROW((void)clopper_pearson_upper(1, 2, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
