#include "reports/experiment/cells_table.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcert {
namespace {

std::string withheld(const Table& table) {
  EXPECT_EQ(table.columns.back().name, "withheld");
  const TableCell& cell = table.rows.front().back();
  return std::holds_alternative<std::string>(cell) ? std::get<std::string>(cell) : "";
}

study::CellScores few_days() {
  study::CellScores scores;
  study::H1Panel panel;
  panel.rows.emplace_back();
  panel.rows.front().auc.value = 0.7;
  panel.withheld = "7 clusters of 'day', fewer than 10";
  scores.own.panels = {panel};
  return scores;
}

std::string withheld_of(const study::CellScores& scores) {
  Table table = cells_table({});
  add_cell({"full", {}}, "done", cell_panels(scores), table);
  return withheld(table);
}

TEST(CellsTable, SaysWhyIntervalsAreWithheld) {
  study::CellScores scores = few_days();
  EXPECT_EQ(withheld_of(scores), "7 clusters of 'day', fewer than 10");
  scores.against_full = scores.own;
  EXPECT_EQ(withheld_of(scores), "7 clusters of 'day', fewer than 10");
  scores.own.panels.front().withheld.clear();
  EXPECT_EQ(withheld_of(scores), "changes from full: 7 clusters of 'day', fewer than 10");
  scores.against_full.reset();
  EXPECT_EQ(withheld_of(scores), "");
}

TEST(CellsTable, SaysWhyTheSpeedHasNoIntervals) {
  study::H3Table h3;
  study::H3Group group;
  group.cases.emplace_back();
  group.cases.front().retained = 0.75;
  for (const char* const few : {"9 successes of 'M3'", "8 successes of 'CB-V'"}) {
    group.conditions.push_back(
        {statistics::ConditionKind::withheld, statistics::ConditionSeverity::warning, "", few});
  }
  h3.groups = {group};
  Table table = cell_speed_table({});
  add_cell({"full", {}}, "done", {cell_speed(h3)}, table);
  EXPECT_EQ(withheld(table), "9 successes of 'M3'; 8 successes of 'CB-V'");
  const std::size_t retained = table.columns.size() - 4;
  ASSERT_EQ(table.columns[retained].name, "retained");
  EXPECT_TRUE(std::holds_alternative<Estimate>(table.rows.front()[retained]))
      << "a share stays though its interval is withheld";
}

}  // namespace
}  // namespace tcert
