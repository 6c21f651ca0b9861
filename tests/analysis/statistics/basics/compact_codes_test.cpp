#include <statistics/basics/compact_codes.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace tcert::statistics {
namespace {

TEST(CompactCodes, CountsCodesThatHaveARow) {
  const std::vector<std::uint32_t> codes{7, 2, 7, 900, 2};
  EXPECT_EQ(count_codes(codes), 3U) << "not the levels that there could be";
  EXPECT_EQ(compact_codes(codes).count, 3U);
  EXPECT_EQ(compact_codes(codes).codes, (std::vector<std::uint32_t>{1, 0, 1, 2, 0}));
  EXPECT_EQ(count_codes({}), 0U);
}

}  // namespace
}  // namespace tcert::statistics
