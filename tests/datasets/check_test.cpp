#include "datasets/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/check_csv.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using Messages = std::vector<std::string>;
using test_support::TemporaryFolder;

Messages messages(const std::vector<Diagnostic>& diagnostics) {
  Messages out;
  for (const Diagnostic& diagnostic : diagnostics) {
    out.push_back(to_string(diagnostic));
  }
  return out;
}

constexpr const char* kBundle = R"({"format":"tcert-bundle","version":1,"robot":{},
"rays":[{"name":"left","bearing_rad":1.5,"reach_m":0.6,"kind":"range"}],
"course":{"start":{"disc":{"x_m":0,"y_m":0,"radius_m":0.5}},
          "goal":{"disc":{"x_m":2,"y_m":0,"radius_m":0.5}}}})";

TEST(CheckBundle, SummarisesEachTrialAndKeepsTheProblemsOfAll) {
  const TemporaryFolder folder;
  folder.write("bundle.json", kBundle);
  folder.write("trials.csv", "trial_id,success,time_s\ngood,1,2\nbad,0,1\naway,1,1\n");
  folder.write("logs/good/pose.csv",
               "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0.5,0.5,0,0\n1,0.5,0.001,0\n1.5,1,0,0\n2,2,0,0\n");
  folder.write("logs/good/tactile.csv", "time_s,left_range_m\n0,1\n1,1\n2,1\n");
  folder.write("logs/bad/pose.csv", "time_s,x_m,y_m,yaw_rad\n0,oops,0,0\n");
  folder.write("logs/away/ticks.csv",
               "time_s,x_m,y_m,yaw_rad,left_range_m\n0,5,1,0,1\n0.1,5,1,0,1\n3,5,1,0,1\n");
  const BundleResult opened = open_bundle(folder.path());
  ASSERT_TRUE(opened.bundle) << ::testing::PrintToString(messages(opened.diagnostics));
  const BundleCheck check = check_bundle(*opened.bundle);
  EXPECT_EQ(
      messages(check.diagnostics),
      (Messages{
          "logs/bad/pose.csv:2: error: column 'x_m': found 'oops', expected a finite number; "
          "--repair drops such rows",
          "logs/bad/tactile.csv: error: expected this file, or it with .gz or .zst, or "
          "ticks.csv instead",
          "logs/away/ticks.csv:4: warning: column 'time_s': found 'a step of 2.9 s', expected "
          "steps of at most 1 s; the path is broken here",
          "logs/away: warning: found 'a start at 5, 1', expected a first tick in the start "
          "region; without it there is no certificate"}));
  ASSERT_EQ(check.trials.size(), 3U);
  const TrialSummary& good = check.trials[0];
  EXPECT_FALSE(good.rejected);
  ASSERT_EQ(good.streams.size(), 2U);
  EXPECT_EQ(good.streams[0].name, "pose");
  EXPECT_EQ(good.streams[0].rows, 5U);
  EXPECT_EQ(good.streams[0].rate_hz, 2.0);
  EXPECT_EQ(good.streams[1].longest_gap_s, 1.0);
  EXPECT_EQ(good.duration_s, 2.0);
  EXPECT_EQ(good.distance_m, 2.0);
  EXPECT_EQ(good.ticks, 21U);
  EXPECT_EQ(good.stale_ticks, 8U);  // 0.6 to 0.9 s and 1.6 to 1.9 s
  EXPECT_EQ(good.starts_in_start, true);
  EXPECT_EQ(good.ends_in_goal, true);
  EXPECT_TRUE(check.trials[1].rejected);
  EXPECT_EQ(check.trials[2].breaks, 1U);
  EXPECT_EQ(check.trials[2].starts_in_start, false);
  EXPECT_EQ(check.trials[2].ends_in_goal, false);
}

TEST(CheckCsvFile, DescribesColumnsAndClock) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.csv",
                                 "Time;name;x;flat;none\n"
                                 "0;a;1.5;7;\n"
                                 "0.1;b;;7;\n"
                                 "0.2;c;-2;7;\n"
                                 "0.2;c;-2;7;\n"
                                 "0.3;c;-2;7;\n"
                                 "2;d;nan;7;\n");
  const CsvFileCheck check = check_csv_file(path);
  ASSERT_TRUE(check.summary);
  const CsvFileSummary& summary = *check.summary;
  EXPECT_EQ(summary.dialect.separator, ';');
  EXPECT_EQ(summary.header_line, 1U);
  EXPECT_EQ(summary.rows, 6U);
  EXPECT_EQ(summary.columns[1].type, ColumnType::text);
  EXPECT_EQ(summary.columns[2].type, ColumnType::number);
  EXPECT_EQ(summary.columns[2].missing, 1U);
  EXPECT_EQ(summary.columns[2].not_numbers, 1U);
  EXPECT_EQ(summary.columns[2].smallest, -2.0);
  EXPECT_EQ(summary.columns[2].largest, 1.5);
  EXPECT_TRUE(summary.columns[3].constant);
  EXPECT_EQ(summary.columns[4].type, ColumnType::empty);
  EXPECT_EQ(summary.time_column, "Time");
  EXPECT_EQ(summary.clock->not_increasing, 1U);
  EXPECT_EQ(summary.gaps, 1U);
  EXPECT_EQ(summary.repeated_rows, 1U);
  EXPECT_EQ(summary.frozen_rows, 1U);
  const std::string file = path.string();
  EXPECT_EQ(
      messages(check.diagnostics),
      (Messages{file + ":7: error: column 'x': found 'nan', expected a finite number",
                file + ": note: column 'flat': found '7', expected values that change; all "
                       "rows are the same",
                file + ": note: column 'none': found 'nothing', expected values that change; "
                       "all rows are the same",
                file + ":5: error: column 'Time': found '0.2 after 0.2', expected a time after "
                       "that of the row before; --repair sorts the rows",
                file + ":7: warning: column 'Time': found 'a step of 1.7 s', expected steps of "
                       "at most 1 s; the path is broken here",
                file + ":5: warning: found 'a copy of the row before', expected each row once",
                file + ":6: note: found 'the row before at another time', expected values that "
                       "change with time"}));
}

TEST(CheckCsvFile, NamesColumnsOfAFileWithoutAHeader) {
  const TemporaryFolder folder;
  const CsvFileCheck check = check_csv_file(folder.write("a.csv", "1 2 3\n4 5 6\n"));
  ASSERT_TRUE(check.summary);
  EXPECT_EQ(check.summary->header_line, 0U);
  EXPECT_EQ(check.summary->rows, 2U);
  EXPECT_EQ(check.summary->columns[2].name, "c3");
  EXPECT_EQ(check.summary->columns[2].largest, 6.0);
}

TEST(CheckCsvFile, HasNothingToSayOfAnEmptyFile) {
  const TemporaryFolder folder;
  const CsvFileCheck check = check_csv_file(folder.write("a.csv", ""));
  EXPECT_FALSE(check.summary);
  EXPECT_EQ(check.diagnostics.size(), 1U);
}

TEST(CheckCsvFile, ReadsARealFlipperRobotBehindItsPreamble) {
  const auto path = test_support::shared_data() / "turtle-robot" / "turtle_T1_2024-10-02.csv.gz";
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << "missing: " << path;
  }
  const CsvFileCheck check = check_csv_file(path);
  ASSERT_TRUE(check.summary);
  const CsvFileSummary& summary = *check.summary;
  EXPECT_EQ(summary.dialect.separator, ',');
  EXPECT_EQ(summary.preamble_records, 2U);
  EXPECT_EQ(summary.header_line, 3U);
  EXPECT_EQ(summary.rows, 5410U);
  EXPECT_EQ(summary.columns.size(), 32U);
  EXPECT_EQ(summary.time_column, "time");
  EXPECT_GT(1.0 / summary.clock->median_s, 410.0);
  EXPECT_LT(1.0 / summary.clock->median_s, 800.0);
  for (const ColumnSummary& column : summary.columns) {
    EXPECT_EQ(column.type, ColumnType::number) << column.name;
  }
  EXPECT_TRUE(summary.columns.back().constant);
  EXPECT_EQ(messages(check.diagnostics).front(),
            path.string() +
                ":3: warning: found '2 lines before the header', expected the header "
                "first; the lines before it are not used");
}

}  // namespace
}  // namespace tcert
