#include "analysis/study/trials/feature_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace tcert::study {
namespace {

TEST(FeatureColumns, HaveDistinctNames) {
  std::set<std::string_view> names;
  for (const FeatureColumn& column : feature_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
  }
}

TEST(FeatureColumns, GiveWhatIsKnown) {
  Features features;
  features.tc_early = -0.25;
  features.issued = true;
  for (const FeatureColumn& column : feature_columns()) {
    const auto value = column.get(features);
    if (column.name == "tc_early") {
      EXPECT_EQ(value, -0.25);
    } else if (column.name == "issued") {
      EXPECT_EQ(value, 1.0);
    } else {
      EXPECT_FALSE(value.has_value()) << column.name;
    }
  }
}

}  // namespace
}  // namespace tcert::study
