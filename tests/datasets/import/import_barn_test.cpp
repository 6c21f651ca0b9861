#include "datasets/import/import_barn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

constexpr std::string_view kMetrics =
    "world,m1,m2,m3,m4,m5\n"
    "0,3.5,6,3,5,1\n"
    "1,2.25,5,4,3,1.5\n"
    "2,nan,5,4,3,1.5\n";

table::TextTable table(std::string_view text) {
  table::DiagnosticGroups problems;
  table::CsvOptions csv;
  csv.file = "test.csv";
  return table::read_text_table(table::Bytes::copy_of(text), csv, {}, problems).value();
}

BarnImportResult import_of(std::string_view trials, const BarnImportOptions& options = {}) {
  const BarnTable some[] = {{table(trials), "trials.csv"}};
  return import_barn(some, {table(kMetrics), "metrics.csv"}, options);
}

bool says(const BarnImportResult& result, const std::string& line) {
  return std::any_of(
      result.diagnostics.begin(),
      result.diagnostics.end(),
      [&](const table::Diagnostic& diagnostic) { return table::to_string(diagnostic) == line; });
}

TEST(ImportBarn, ReadsTheOutcomeAsEveryOtherTableDoes) {
  const BarnImportResult result = import_of(
      "planner,world,success,collided,timeout,time_s\n"
      "dwa,1,True,False,False,22\ndwa,1,f,TRUE,0,12\ndwa,0,None,1,0,12\ndwa,0,1,0,0,-nan\n");
  EXPECT_EQ(result.csv,
            "planner,world,success,collided,timeout,time_s,m1,m2,m3,m4,m5\n"
            "dwa,1,1,0,0,22,2.25,5,4,3,1.5\n"
            "dwa,1,0,1,0,12,2.25,5,4,3,1.5\n");
  EXPECT_EQ(result.summary.bad, 2U);
  EXPECT_EQ(result.summary.successes, 1U);
}

TEST(ImportBarn, JoinsTrialsAndWorlds) {
  const BarnImportResult result = import_of(
      "planner,repo,seq,world,success,collided,timeout,time_s,nav_metric\n"
      "dwa,r,0,1,1,0,0,22.2800,4\n"
      "dwa,r,1,300,1,0,0,10,4\n"
      "lics,r,0,0,0,1,0,3.5,0\n"
      "mppi_ros2,r,0,0,0,0,1,100,0\n"
      "dwa,r,2,7,1,0,0,10,4\n"
      "dwa,r,3,2,1,0,0,10,4\n");
  EXPECT_EQ(result.csv,
            "planner,world,success,collided,timeout,time_s,m1,m2,m3,m4,m5\n"
            "dwa,1,1,0,0,22.2800,2.25,5,4,3,1.5\n"
            "lics,0,0,1,0,3.5,3.5,6,3,5,1\n"
            "mppi_ros2,0,0,0,1,100,3.5,6,3,5,1\n");
  const BarnSummary& summary = result.summary;
  EXPECT_EQ(summary.read, 6U);
  EXPECT_EQ(summary.written, 3U);
  EXPECT_EQ(summary.successes, 1U);
  EXPECT_EQ(summary.worlds, 2U);
  EXPECT_EQ(summary.moving, 1U);
  EXPECT_EQ(summary.unmeasured, 2U) << "world 7, and world 2, whose metrics are broken";
  EXPECT_EQ(summary.groups.size(), 3U);
  EXPECT_TRUE(says(result,
                   "metrics.csv:4: error: column 'm1': found 'nan', expected a finite number; the "
                   "world has no metrics"));
}

TEST(ImportBarn, LeavesOutPlannersOnRequest) {
  constexpr std::string_view kTrials =
      "planner,world,success,collided,timeout,time_s\n"
      "dwa,1,1,0,0,5\n"
      "lics,1,1,0,0,6\n"
      "ros2_maity,1,1,0,0,7\n";
  BarnImportOptions options;
  options.other_ports = false;
  EXPECT_EQ(import_of(kTrials, options).summary.written, 2U);
  EXPECT_EQ(import_of(kTrials, options).summary.other_ports, 1U);
  options.planners = {"lics"};
  const BarnImportResult one = import_of(kTrials, options);
  EXPECT_EQ(one.summary.written, 1U);
  EXPECT_EQ(one.summary.not_asked_for, 2U);
}

TEST(ImportBarn, NamesBadRowsAndLeavesThemOut) {
  const BarnImportResult result = import_of(
      "planner,world,success,collided,timeout,time_s\n"
      "dwa,1,1,0,0,0\n"
      "dwa,1,2,0,0,5\n"
      "dwa,1,1,1,0,5\n"
      "dwa,x,1,0,0,5\n"
      "dwa,1,0,1,0,soon\n"
      "dwa,1,0,0,1,13489.7\n");
  EXPECT_EQ(result.summary.bad, 5U);
  EXPECT_EQ(result.summary.written, 1U);
  EXPECT_TRUE(says(result,
                   "trials.csv:2: error: column 'time_s': found '0', expected a time above 0 s; "
                   "the row is left out (and 1 more)"));
  EXPECT_TRUE(says(result,
                   "trials.csv:3: error: column 'success': found '2', expected 0 or 1, true or "
                   "false; the row is "
                   "left out"));
  EXPECT_TRUE(says(result,
                   "trials.csv:4: error: column 'success': found '1', expected exactly one of "
                   "success, collided and timeout to be 1; the row is left out"));
  EXPECT_TRUE(says(result,
                   "trials.csv:5: error: column 'world': found 'x', expected a whole number, 0 or "
                   "more; the row is left out"));
  EXPECT_TRUE(says(result,
                   "trials.csv:7: warning: column 'time_s': found '13489.7', expected at most 101 "
                   "s, for a trial ends at 100; kept"));
}

TEST(ImportBarn, KnowsTheDatedTableByItsColumns) {
  const BarnImportResult result = import_of(
      "seq,first_commit_date,first_commit,world,success,collided,timeout,time_s\n"
      "0,2024-04-10,6e30,1,1,0,0,5\n");
  EXPECT_EQ(result.summary.group, "date");
  EXPECT_EQ(result.csv,
            "date,world,success,collided,timeout,time_s,m1,m2,m3,m4,m5\n"
            "2024-04-10,1,1,0,0,5,2.25,5,4,3,1.5\n");
}

TEST(ImportBarn, NamesMissingColumns) {
  const BarnImportResult result = import_of("planner,world,success\ndwa,1,1\n");
  EXPECT_FALSE(result.csv.has_value());
  EXPECT_TRUE(says(result, "trials.csv: error: column 'time_s': expected a column of this name"));
}

TEST(ImportBarn, WritesOneTableAfterAnother) {
  constexpr const char* kHeader = "planner,world,success,collided,timeout,time_s\n";
  const BarnTable some[] = {
      {table(std::string(kHeader) + "dwa,1,1,0,0,5\ndwa,0,x,0,0,5\n"), "a.csv"},
      {table(std::string(kHeader) + "lics,0,0,1,0,6\n"), "b.csv"}};
  const BarnImportResult result = import_barn(some, {table(kMetrics), "metrics.csv"});
  EXPECT_EQ(result.csv,
            "planner,world,success,collided,timeout,time_s,m1,m2,m3,m4,m5\n"
            "dwa,1,1,0,0,5,2.25,5,4,3,1.5\n"
            "lics,0,0,1,0,6,3.5,6,3,5,1\n");
  EXPECT_EQ(result.summary.read, 3U);
  EXPECT_EQ(planners_of(some), (std::vector<std::string>{"dwa", "lics"}));
  EXPECT_TRUE(says(result,
                   "a.csv:3: error: column 'success': found 'x', expected 0 or 1, true or false; "
                   "the row is left out"));
}

TEST(ImportBarn, MixesNoTablesByPlannerAndByDate) {
  const BarnTable some[] = {
      {table("planner,world,success,collided,timeout,time_s\ndwa,1,1,0,0,5\n"), "a.csv"},
      {table("first_commit_date,world,success,collided,timeout,time_s\nx,1,1,0,0,5\n"), "b.csv"}};
  const BarnImportResult result = import_barn(some, {table(kMetrics), "metrics.csv"});
  EXPECT_FALSE(result.csv);
  EXPECT_TRUE(says(result, "b.csv: error: column 'planner': expected a column of this name"));
}

TEST(ImportBarn, ReadsThePublicOutcomes) {
  const auto folder = test_support::shared_data();
  const auto read = [&](const char* name) { return table::read_text_table(folder / name); };
  const table::TextTableResult metrics = read("barn-worlds/difficulty_metrics.csv");
  const table::TextTableResult planners = read("barn-trials/trials.csv");
  const table::TextTableResult dated = read("barn-trials/mlda_dated.csv");
  if (!metrics.table || !planners.table || !dated.table) {
    GTEST_SKIP() << "no real data: the CSV files of " << folder << " are missing";
  }
  const BarnTable by_planner[] = {{*planners.table, "t"}};
  const BarnTable by_date[] = {{*dated.table, "d"}};
  const BarnImportResult a = import_barn(by_planner, {*metrics.table, "m"});
  EXPECT_EQ(a.summary.read, 7476U);
  EXPECT_EQ(a.summary.moving, 604U);
  EXPECT_EQ(a.summary.written, 6872U);
  EXPECT_EQ(a.summary.bad, 0U);
  EXPECT_EQ(a.summary.unmeasured, 0U);
  const BarnImportResult b = import_barn(by_date, {*metrics.table, "m"});
  EXPECT_EQ(b.summary.written, 6917U);
  EXPECT_EQ(b.summary.successes, 4864U);
  EXPECT_EQ(b.summary.groups.size(), 17U);
}

}  // namespace
}  // namespace tcert
