#include <statistics/basics/condition_groups.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tcert::statistics {
namespace {

Condition separated(const std::string& column) {
  return {ConditionKind::quasi_separation,
          ConditionSeverity::warning,
          column,
          "the estimate is +infinity, every row of " + column + " has y = 1"};
}

std::string factor_of(const std::string& column) {
  return column.starts_with("world") ? "world" : "";
}

TEST(ConditionGroups, SixtyColumnsOfAFactorAreOneLine) {
  Conditions conditions{separated("x")};
  for (int level = 1; level <= 60; ++level) {
    conditions.push_back(separated("worldw" + std::to_string(level)));
  }
  conditions.push_back(
      {ConditionKind::collinear_column, ConditionSeverity::warning, "worldw61", ""});
  const Conditions grouped = one_per_factor(conditions, factor_of);
  ASSERT_EQ(grouped.size(), 3U);
  EXPECT_EQ(grouped[0], conditions[0]);
  EXPECT_EQ(grouped[1].column, "world");
  EXPECT_EQ(grouped[1].detail,
            "60 columns (worldw1, worldw2, worldw3 and 57 more), the first: the estimate is "
            "+infinity, every row of worldw1 has y = 1");
  EXPECT_EQ(grouped[2], conditions.back()) << "another kind, and alone";
}

TEST(ConditionGroups, NamesAFewAndCountsTheRest) {
  EXPECT_EQ(some_of({"a"}), "a");
  EXPECT_EQ(some_of({"a", "b", "c", "d"}), "a, b, c, d");
  EXPECT_EQ(some_of({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}

TEST(ConditionGroups, KeepsApartWhatIsOfAnotherQuantity) {
  const Condition failed{
      ConditionKind::failed_replicates, ConditionSeverity::note, "", "AUC: 2 of 9"};
  const auto shared =
      shared_conditions({{"A", "AUC", failed}, {"B", "C", failed}, {"C", "AUC", failed}});
  ASSERT_EQ(shared.size(), 2U);
  EXPECT_EQ(shared[0].owners, (std::vector<std::string>{"A", "C"}));
  EXPECT_TRUE(shared[0].same_detail);
}

}  // namespace
}  // namespace tcert::statistics
