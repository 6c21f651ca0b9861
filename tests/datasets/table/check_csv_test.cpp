#include <table/check_csv.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <table/read_data_table.hpp>
#include <utility>
#include <vector>

#include "support/temporary_folder.hpp"

namespace tcert::table {
namespace {

bool has(const std::vector<Diagnostic>& all, Severity severity, std::string_view found) {
  return std::ranges::any_of(all, [&](const Diagnostic& diagnostic) {
    return diagnostic.severity == severity && diagnostic.value == found;
  });
}

TEST(CheckCsvFile, NamesEveryFault) {
  const test_support::TemporaryFolder folder;
  const auto path = folder.write("run.csv",
                                 "robot;rev\n"
                                 "time;a;b;c\n"
                                 "0.0;1;7;x\n"
                                 "0.1;2;7;4\n"
                                 "0.1;3;7;5\n"
                                 "2.0;;7;6\n"
                                 "2.1;5;7\n"
                                 "2.2;6;7;8\n"
                                 "2.2;6;7;8\n");
  const CsvCheckResult result = check_csv_file(path, 1.0, {});
  ASSERT_TRUE(result.check);
  EXPECT_EQ(result.check->dialect.separator, ';');
  EXPECT_EQ(result.check->header_line, 2U);
  EXPECT_EQ(result.check->preamble_records, 1U);
  EXPECT_EQ(result.check->rows, 6U);
  EXPECT_EQ(result.check->columns[1].missing, 1U);
  EXPECT_EQ(result.check->columns[1].least, 1.0);
  EXPECT_EQ(result.check->columns[1].largest, 6.0);
  EXPECT_EQ(result.check->columns[3].texts, 1U);
  ASSERT_TRUE(result.check->clock);
  EXPECT_EQ(result.check->clock->column, "time");
  EXPECT_NEAR(result.check->clock->longest_gap_s, 1.9, 1e-12);
  EXPECT_TRUE(has(result.diagnostics, Severity::error, "0.1 after 0.1"));
  EXPECT_TRUE(has(result.diagnostics, Severity::error, "3 fields"));
  EXPECT_TRUE(std::ranges::any_of(result.diagnostics, [](const Diagnostic& one) {
    return one.severity == Severity::error && one.line == 3 && one.column == "c" &&
           one.value == "x" &&
           one.expectation ==
               "a number, as in its 5 other cells (a missing cell is empty, NA or nan)";
  }));
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "a gap of 1.9 s"));
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "an empty cell"));
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "the row before again"));
  EXPECT_TRUE(has(result.diagnostics, Severity::note, "always 7"));
}

TEST(CheckCsvFile, FindsNothingWrongWithAGoodFile) {
  const test_support::TemporaryFolder folder;
  const auto path = folder.write("run.csv", "time_s,a\n0,1\n0.5,2\n1,3\n");
  const CsvCheckResult result = check_csv_file(path);
  ASSERT_TRUE(result.check);
  EXPECT_TRUE(result.diagnostics.empty());
  EXPECT_NEAR(result.check->clock->median_rate_hz, 2.0, 1e-12);
}

TEST(CheckCsvFile, TellsNumbersTruthValuesMissingCellsAndNames) {
  const test_support::TemporaryFolder folder;
  const auto path = folder.write("t.csv",
                                 "r,ok,light,room,speed\n"
                                 "inf,True,dim,101,N/A\n"
                                 "-nan,False,N/A,B1,0.1\n"
                                 "2,NA,dark,101,null\n"
                                 "3,True,dim,B1,N/A\n");
  const CsvCheckResult result = check_csv_file(path);
  ASSERT_TRUE(result.check);
  const auto& columns = result.check->columns;
  EXPECT_EQ(columns[0].numbers, 3U);
  EXPECT_EQ(columns[0].missing, 1U);
  EXPECT_EQ(columns[1].truths, 3U);
  EXPECT_EQ(columns[1].missing, 1U);
  EXPECT_EQ(columns[1].texts, 0U);
  EXPECT_EQ(columns[2].texts, 4U);
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "inf"));
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "-nan"));
  // Beside names N/A is a name, and a warning; beside numbers it is an error.
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "N/A"));
  EXPECT_TRUE(has(result.diagnostics, Severity::warning, "B1"));
  const auto error = std::ranges::find(result.diagnostics, Severity::error, &Diagnostic::severity);
  ASSERT_NE(error, result.diagnostics.end());
  EXPECT_EQ(error->column, "speed");
  EXPECT_EQ(error->line, 2U);
  EXPECT_EQ(error->count, 3U);
}

/// However many distinct cells there are, what a check lets pass a fit takes for names too.
TEST(CheckCsvFile, JudgesAMixtureAsATableDoes) {
  const test_support::TemporaryFolder folder;
  for (const auto& [numbers, texts] : std::vector<std::pair<int, int>>{
           {3000, 1500}, {3000, 700}, {1500, 3000}, {900, 800}, {800, 900}, {8000, 1500}}) {
    std::string csv = "x,y\n";
    for (int i = 0; i < numbers; ++i) {
      csv += std::to_string(i) + ".5,1\n";
    }
    for (int i = 0; i < texts; ++i) {
      csv += "a" + std::to_string(i) + ",1\n";
    }
    const auto path = folder.write("mixed.csv", csv);
    const CsvCheckResult check = check_csv_file(path);
    const DataTableResult read = read_data_table(path);
    ASSERT_TRUE(read.table);
    const bool refused = std::ranges::any_of(check.diagnostics, [](const Diagnostic& one) {
      return one.severity == Severity::error && one.column == "x";
    });
    EXPECT_EQ(refused, read.table->find("x")->mixed.is_spoiled()) << numbers << ' ' << texts;
  }
}

TEST(CheckCsvFile, SaysWhatItCannotRead) {
  EXPECT_FALSE(check_csv_file("/nowhere/run.csv").check);
  const test_support::TemporaryFolder folder;
  const CsvCheckResult empty = check_csv_file(folder.write("empty.csv", ""));
  EXPECT_FALSE(empty.check);
  EXPECT_TRUE(has_error(empty.diagnostics));
}

TEST(CheckCsvFile, ReadsARealRobotsLogBehindItsPreamble) {
  const auto path = test_support::shared_data() / "turtle-robot/turtle_T1_2024-10-02.csv.gz";
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << "no real data: " << path << " is missing";
  }
  const CsvCheckResult result = check_csv_file(path);
  ASSERT_TRUE(result.check);
  EXPECT_EQ(result.check->preamble_records, 2U);
  EXPECT_EQ(result.check->header_line, 3U);
  EXPECT_EQ(result.check->rows, 5410U);
  EXPECT_EQ(result.check->columns.size(), 32U);
  ASSERT_TRUE(result.check->clock);
  EXPECT_NEAR(5410.0 / (result.check->clock->last_s - result.check->clock->first_s), 656.6, 0.1);
  const auto constant = std::ranges::count_if(
      result.check->columns, [](const ColumnCheck& column) { return column.is_constant(); });
  EXPECT_EQ(constant, 15);  // the depth, and two flippers that the cameras never saw
}

TEST(CheckCsvFile, NamesStampsInATableOfTrials) {
  const test_support::TemporaryFolder folder;
  const auto mixed = check_csv_file(
      folder.write("mixed.csv", "success,time_s\n1,5\n1,9\n1,13\n1,17\n0,1764174008\n"));
  EXPECT_TRUE(
      has(mixed.diagnostics, Severity::warning, "1764174008, 1.36e+08 times the median of 13"));
  const auto stamps = check_csv_file(
      folder.write("stamps.csv", "success,end_time\n1,1764174008\n1,1764174031\n0,1764174017\n"));
  EXPECT_TRUE(has(stamps.diagnostics, Severity::note, "stamps, from 1764174008 to 1764174031"));
  const auto durations =
      check_csv_file(folder.write("fine.csv", "success,time_s\n1,5\n1,9.5\n0,120\n"));
  EXPECT_TRUE(durations.diagnostics.empty());
}

}  // namespace
}  // namespace tcert::table
