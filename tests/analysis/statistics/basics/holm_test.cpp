#include <statistics/basics/holm.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

namespace tcert::statistics {
namespace {

using P = std::optional<double>;

TEST(Holm, EqualsPAdjust) {
  // p.adjust(c(0.01, 0.04, 0.03, 0.005, NA, 0.2), "holm"): 0.04 0.09 0.09 0.025 NA 0.20
  const std::vector<P> p{0.01, 0.04, 0.03, 0.005, std::nullopt, 0.2};
  const std::vector<P> adjusted = holm(p);
  EXPECT_DOUBLE_EQ(*adjusted[0], 0.04);
  EXPECT_DOUBLE_EQ(*adjusted[1], 0.09);
  EXPECT_DOUBLE_EQ(*adjusted[2], 0.09);
  EXPECT_DOUBLE_EQ(*adjusted[3], 0.025);
  EXPECT_FALSE(adjusted[4].has_value());
  EXPECT_DOUBLE_EQ(*adjusted[5], 0.2);
}

TEST(Holm, StopsAtOne) {
  EXPECT_EQ(holm(std::vector<P>{0.6, 0.7}), (std::vector<P>{1.0, 1.0}));
  EXPECT_EQ(holm(std::vector<P>{0.0, 1.0}), (std::vector<P>{0.0, 1.0}));
  EXPECT_TRUE(holm({}).empty());
}

TEST(Holm, RefusesWhatIsNoProbability) {
  EXPECT_THROW(static_cast<void>(holm(std::vector<P>{1.5})), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::statistics
