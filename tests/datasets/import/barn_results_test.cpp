#include "datasets/import/barn_results.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "datasets/import/import_barn.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

table::TextTable read(std::string_view text, std::vector<std::string>& problems) {
  table::DiagnosticGroups groups;
  table::TextTable results =
      read_barn_results(table::Bytes::copy_of(text), "out.txt", "mine", groups);
  problems.clear();
  for (const table::Diagnostic& one : groups.take()) {
    problems.push_back(table::to_string(one));
  }
  return results;
}

TEST(BarnResults, AreToldFromTablesByTheirFirstLine) {
  EXPECT_TRUE(is_barn_results("108 1 0 0 22.2800 4.1806\n"));
  EXPECT_TRUE(is_barn_results("\n# a note\n  108\t1 0 0 22.28\r\n"));
  EXPECT_TRUE(is_barn_results("7 True False False 22.28 0.4\n"));
  EXPECT_FALSE(is_barn_results("world success collided timeout time nav_metric\n1 1 0 0 2 3\n"));
  EXPECT_FALSE(is_barn_results("planner,world,success,collided,timeout,time_s\n"));
  EXPECT_FALSE(is_barn_results("1,1,0,0,22.28\n"));
  EXPECT_FALSE(is_barn_results("1 1 0 0\n"));
  EXPECT_FALSE(is_barn_results("1 1 0 0 2 3 4\n"));
  EXPECT_FALSE(is_barn_results(""));
}

TEST(BarnResults, ReadLinesOfFiveAndOfSixWords) {
  std::vector<std::string> problems;
  const table::TextTable results =
      read("108 1 0 0 22.2800 4.1806\n\n18 0 1 0 3.5\r\n  90   0 0 1\t100 0.0  \n", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(
      results.columns,
      (std::vector<std::string>{"planner", "world", "success", "collided", "timeout", "time_s"}));
  EXPECT_EQ(results.cells,
            (std::vector<std::string>{"mine",
                                      "108",
                                      "1",
                                      "0",
                                      "0",
                                      "22.2800",
                                      "mine",
                                      "18",
                                      "0",
                                      "1",
                                      "0",
                                      "3.5",
                                      "mine",
                                      "90",
                                      "0",
                                      "0",
                                      "1",
                                      "100"}));
  EXPECT_EQ(results.lines, (std::vector<std::size_t>{1, 3, 4}));
}

TEST(BarnResults, NameLinesThatAreNoTrial) {
  std::vector<std::string> problems;
  EXPECT_EQ(read("1 1 0 0 2 3\n1 1 0\n1 1 0 0 2 3 4\n1 1 0", problems).rows(), 1U);
  EXPECT_EQ(problems,
            (std::vector<std::string>{
                "out.txt:2: error: found '3 words', expected world success collided timeout time "
                "nav_metric, the last one or not; the line is left out (and 1 more)",
                "out.txt:4: warning: found '3 words', expected world success collided timeout time "
                "nav_metric, the last one or not; the line is left out"}));
}

TEST(BarnResults, AreNamedByTheirFile) {
  EXPECT_EQ(planner_of_file("res/dwa_out.txt"), "dwa");
  EXPECT_EQ(planner_of_file("lics_ki_out.txt.gz"), "lics_ki");
  EXPECT_EQ(planner_of_file("eband-out.txt"), "eband");
  EXPECT_EQ(planner_of_file("applr.txt"), "applr");
  EXPECT_EQ(planner_of_file("layout.txt"), "layout");
  EXPECT_EQ(planner_of_file("some/out.txt"), "");
  EXPECT_EQ(planner_of_file("_out.txt"), "");
}

TEST(BarnResults, OfTheChallengeJoinTheMetricsOfItsWorlds) {
  const auto folder = test_support::shared_data();
  const table::BytesResult file = table::read_file(folder / "logs/barn/dwa_out.txt");
  const table::TextTableResult metrics =
      table::read_text_table(folder / "barn-worlds/difficulty_metrics.csv");
  if (!file.bytes || !metrics.table) {
    GTEST_SKIP() << "no real data in " << folder;
  }
  ASSERT_TRUE(is_barn_results(file.bytes->view()));
  table::DiagnosticGroups problems;
  const BarnTable trials[] = {
      {read_barn_results(*file.bytes, "dwa_out.txt", "dwa", problems), "dwa_out.txt"}};
  EXPECT_TRUE(problems.take().empty());
  const BarnImportResult result = import_barn(trials, {*metrics.table, "metrics.csv"});
  EXPECT_TRUE(result.csv);
  EXPECT_EQ(result.summary.bad, 0U);
  EXPECT_EQ(result.summary.unmeasured, 0U);
  EXPECT_EQ(result.summary.read, result.summary.written + result.summary.moving);
  // DWA, the challenge's baseline: some fail, most of the easy worlds do not.
  EXPECT_GT(result.summary.successes, result.summary.written / 2);
  EXPECT_LT(result.summary.successes, result.summary.written);
  ASSERT_EQ(result.summary.groups.size(), 1U);
  EXPECT_EQ(result.summary.groups[0].first, "dwa");
}

}  // namespace
}  // namespace tcert
