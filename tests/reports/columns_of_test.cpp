#include "reports/columns_of.hpp"

#include <gtest/gtest.h>

namespace tcert {
namespace {

struct Lap {
  int number = 0;
  std::optional<double> time_s;
};

struct Race {
  std::string name;
  std::optional<bool> won;
  std::optional<Lap> best;
  statistics::Interval interval;
};

ColumnsOf<Race> race_columns(bool with_interval) {
  ColumnsOf<Lap> lap;
  lap.integer("lap", "lap", &Lap::number).fixed("time_s", "time", "s", 1, &Lap::time_s);
  ColumnsOf<Race> columns;
  columns.text("name", "race", &Race::name)
      .doc("what it is called")
      .yes_or_no("won", "won", &Race::won)
      .part(lap, &Race::best);
  if (with_interval) {
    columns.ends({"low", "low"}, {"high", "high"}, &Race::interval);
  }
  return columns;
}

TEST(ColumnsOf, AValueThatIsNotThereIsMissing) {
  const std::vector<Race> races = {{"a", true, Lap{3, 12.25}, {}}, {"b", {}, Lap{4, {}}, {}}};
  EXPECT_EQ(render(race_columns(false).table("races", "Races", races), TableFormat::csv),
            "name,won,lap,time_s\na,yes,3,12.25\nb,,4,\n");
}

TEST(ColumnsOf, APartThatIsNotThereIsMissingInAllItsColumns) {
  const std::vector<TableCell> cells = race_columns(false).row({"c", false, {}, {}});
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(std::get<std::string>(cells[1]), "no");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(cells[2]));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(cells[3]));
}

TEST(ColumnsOf, AColumnThatIsNotAlwaysThereComesWithItsCells) {
  const std::vector<Race> races = {{"a", true, {}, {0.25, 0.75, 0.95}}};
  EXPECT_EQ(render(race_columns(true).table("races", "Races", races), TableFormat::csv),
            "name,won,lap,time_s,low,high\na,yes,,,0.25,0.75\n");
}

TEST(ColumnsOf, SaysWhatAColumnMeans) {
  const std::vector<ColumnDoc> docs = race_columns(false).docs();
  ASSERT_EQ(docs.size(), 4U);
  EXPECT_EQ(docs[0].doc, "what it is called");
  EXPECT_EQ(docs[3].unit, "s");
  EXPECT_EQ(docs[3].doc, "");
}

}  // namespace
}  // namespace tcert
