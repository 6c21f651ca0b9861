#include <gtest/gtest.h>

#include <random>
#include <set>
#include <statistics/model/factor_levels.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {
namespace {

table::Factor random_factor(std::mt19937& random, std::size_t rows, std::uint32_t levels) {
  table::Factor factor;
  for (std::uint32_t k = 0; k < levels; ++k) {
    factor.levels.push_back("l" + std::to_string(k));
  }
  for (std::size_t row = 0; row < rows; ++row) {
    factor.codes.push_back(random() % 50 == 0 ? table::Factor::kMissing
                                              : static_cast<std::uint32_t>(random() % levels));
  }
  return factor;
}

// Every row by itself: its levels joined, or missing.
void expect_cross(const std::vector<table::Factor>& factors) {
  const table::Factor cross = crossed(factors, ", ");
  std::set<std::string> seen;
  ASSERT_EQ(cross.codes.size(), factors.front().codes.size());
  for (std::size_t row = 0; row < cross.codes.size(); ++row) {
    std::string name;
    bool missing = false;
    for (const table::Factor& factor : factors) {
      missing = missing || factor.codes[row] == table::Factor::kMissing;
      name += missing ? "" : (name.empty() ? "" : ", ") + factor.levels[factor.codes[row]];
    }
    ASSERT_EQ(cross.codes[row] == table::Factor::kMissing, missing) << row;
    if (!missing) {
      ASSERT_EQ(cross.levels[cross.codes[row]], name) << row;
      seen.insert(name);
    }
  }
  EXPECT_EQ(seen.size(), cross.levels.size()) << "only levels that occur";
}

TEST(Crossed, NamesTheLevelsOfEveryRow) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<table::Factor> factors;
    for (std::size_t k = 0; k < 2 + random() % 3; ++k) {
      factors.push_back(random_factor(random, 300, static_cast<std::uint32_t>(1 + random() % 9)));
    }
    expect_cross(factors);
  }
}

TEST(Crossed, HoldsWhereTheProductOfAllLevelsIsBeyond64Bits) {
  std::mt19937 random(4);
  std::vector<table::Factor> factors;
  for (int k = 0; k < 6; ++k) {
    factors.push_back(random_factor(random, 3000, 3000));
  }
  expect_cross(factors);
}

}  // namespace
}  // namespace tcert::statistics
