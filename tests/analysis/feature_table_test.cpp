#include "analysis/feature_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

FeatureTable written_table() {
  FeatureTable table;
  table.extra_columns = {"operator"};
  FeatureRow row;
  row.trial.trial_id = "t001";
  row.trial.algorithm = "CB-V";
  row.trial.lighting = "Dark";
  row.trial.day = "2024-05-01";
  row.trial.success = true;
  row.trial.time_s = 61.2;
  row.trial.end_reason = EndReason::goal;
  row.trial.extra = {"Ann, \"the\" first"};
  row.features.tc_early = 0.1 + 0.2;
  row.features.tc_landmark = 1.0 / 3.0;
  row.features.ticks = 612;
  row.features.issued = true;
  row.features.issued_s = 60.1;
  row.features.still_at_landmark = false;
  table.rows.push_back(row);
  FeatureRow failed;
  failed.trial.trial_id = "t002";
  failed.trial.success = false;
  failed.trial.extra = {""};
  failed.features.issued = false;
  failed.features.tc_early = -1e-300;
  table.rows.push_back(failed);
  return table;
}

class FeatureTableFile : public ::testing::Test {
 protected:
  [[nodiscard]] FeatureTableResult read(std::string_view text) const {
    const auto path = folder_.write("features.csv", text);
    const TextTableResult result = read_text_table(path);
    EXPECT_TRUE(result.table.has_value());
    return to_feature_table(result.table.value(), "features.csv");
  }

  test_support::TemporaryFolder folder_;
};

TEST_F(FeatureTableFile, ReadsBackToTheSameBytesAndBits) {
  const FeatureTable table = written_table();
  const std::string text = to_csv(table, "synthetic, seed 1");
  EXPECT_EQ(text.substr(0, text.find('\n')), "# synthetic, seed 1");
  const FeatureTableResult result = read(text);
  ASSERT_TRUE(result.table.has_value());
  EXPECT_EQ(to_csv(*result.table, "synthetic, seed 1"), text);
  ASSERT_EQ(result.table->rows.size(), 2U);
  const FeatureRow& row = result.table->rows[0];
  EXPECT_EQ(row.features.tc_early, 0.1 + 0.2);
  EXPECT_EQ(row.features.ticks, 612U);
  EXPECT_EQ(row.features.still_at_landmark, false);
  EXPECT_EQ(row.trial.end_reason, EndReason::goal);
  EXPECT_EQ(row.trial.extra, table.rows[0].trial.extra);
  EXPECT_EQ(result.table->rows[1].features.tc_early, -1e-300);
  EXPECT_EQ(result.table->rows[1].features.tc_landmark, std::nullopt);
  EXPECT_EQ(result.table->rows[1].trial.time_s, std::nullopt);
}

TEST_F(FeatureTableFile, WritesAMissingValueAsAnEmptyCell) {
  FeatureTable table = written_table();
  const std::string text = to_csv(table);
  const std::string last = text.substr(text.rfind("t002"));
  EXPECT_EQ(last.substr(0, last.find("-1")), "t002,,,,,0,,,,,");
}

TEST_F(FeatureTableFile, TakesAnyTableWithAnOutcome) {
  const FeatureTableResult result =
      read("world;success;tc_early;m1\n3;TRUE;0.25;NA\n4;0;NA;1.5\n5;;0.1;2\n");
  ASSERT_TRUE(result.table.has_value());
  EXPECT_EQ(result.table->extra_columns, (std::vector<std::string>{"world", "m1"}));
  EXPECT_EQ(result.table->rows[0].trial.trial_id, "1");
  EXPECT_EQ(result.table->rows[0].trial.success, true);
  EXPECT_EQ(result.table->rows[0].features.tc_early, 0.25);
  EXPECT_EQ(result.table->rows[0].trial.extra[1], "NA");
  EXPECT_EQ(result.table->rows[1].features.tc_early, std::nullopt);
  EXPECT_EQ(result.table->rows[2].trial.success, std::nullopt);
}

TEST_F(FeatureTableFile, NamesEveryBadCell) {
  const FeatureTableResult result =
      read("trial_id,success,time_s,tc_early,end_reason\na,2,1,0.5,goal\nb,1,soon,inf,tired\n");
  EXPECT_FALSE(result.table.has_value());
  ASSERT_EQ(result.diagnostics.size(), 4U);
  EXPECT_EQ(to_string(result.diagnostics[0]),
            "features.csv:2: error: column 'success': found '2', expected 0, 1, true, false or an "
            "empty cell");
  EXPECT_EQ(result.diagnostics[1].column, "time_s");
  EXPECT_EQ(result.diagnostics[2].value, "inf");
  EXPECT_EQ(result.diagnostics[3].line, 3U);
}

TEST_F(FeatureTableFile, AsksForAnOutcome) {
  const FeatureTableResult result = read("trial_id,tc_early\na,1\n");
  EXPECT_FALSE(result.table.has_value());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].column, "success");
}

TEST(FeatureTable, RefusesAnExtraColumnWithATakenName) {
  FeatureTable table;
  table.extra_columns = {"Dwell"};
  EXPECT_THROW(static_cast<void>(to_csv(table)), std::invalid_argument);
}

TEST(FeatureColumns, HaveDistinctNames) {
  std::set<std::string_view> names;
  for (const FeatureColumn& column : feature_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
  }
}

}  // namespace
}  // namespace tcert
