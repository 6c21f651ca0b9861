#include "datasets/check_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/temporary_folder.hpp"

namespace tcert {
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
  EXPECT_TRUE(has(result.diagnostics, Severity::error, "1 cells that are no number"));
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
}  // namespace tcert
