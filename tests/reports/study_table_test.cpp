#include "reports/study_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "reports/table_one.hpp"

namespace tcert {
namespace {

study::TrialRecord study_trial(const char* algorithm,
                               const char* lighting,
                               std::optional<bool> success,
                               const std::vector<double>& latency_ms) {
  study::TrialRecord record;
  record.row.trial.algorithm = algorithm;
  record.row.trial.lighting = lighting;
  record.row.trial.success = success;
  record.speed_cmd_mps = study::Tally(std::vector{0.1, 0.2});
  record.loop_latency_ms = study::Tally(latency_ms);
  return record;
}

study::StudyRecord two_by_two(const char* other) {
  study::StudyRecord study;
  study.add(study_trial("M3", "Dark", true, {19.0}));
  study.add(study_trial("M3", "Dark", false, {19.2}));
  study.add(study_trial("M3", "Indoor", true, {19.6}));
  study.add(study_trial(other, "Indoor", std::nullopt, {20.4}));
  return study;
}

TEST(TableOne, IsAsThePaperPrintsIt) {
  const Table table = table_one(two_by_two("M1"));
  EXPECT_EQ(render(table, TableFormat::csv),
            "algorithm,successes_Dark,successes_Indoor,successes_of_all_lightings\n"
            "M1,,,\n"
            "M3,1/2 (50.0 %),1/1 (100.0 %),2/3 (66.7 %)\n"
            "all,1/2 (50.0 %),1/1 (100.0 %),2/3 (66.7 %)\n");
  EXPECT_EQ(table.n, 3);
  EXPECT_EQ(render(table_from_json(render(table, TableFormat::json)), TableFormat::text),
            render(table, TableFormat::text));
}

TEST(TableOne, HasNoSumsOfOneAlone) {
  study::StudyRecord study;
  study.add(study_trial("", "", true, {}));
  EXPECT_EQ(render(table_one(study), TableFormat::csv),
            "algorithm,successes_\n(none),1/1 (100.0 %)\n");
  EXPECT_EQ(table_one(study).columns[1].heading, "(none)");
}

TEST(StudyCells, HaveEveryCellAndAllOfThemAsNumbers) {
  EXPECT_EQ(render(study_cells_table(two_by_two("M1")), TableFormat::csv),
            "algorithm,lighting,trials,known_outcomes,successes,share,speed_mps,latency_ms\n"
            "M1,Indoor,1,0,0,,0.15000000000000002,20.4\n"
            "M3,Dark,2,2,1,0.5,0.15000000000000002,19.1\n"
            "M3,Indoor,1,1,1,1,0.15000000000000002,19.6\n"
            "all,all,4,3,2,0.6666666666666666,0.15000000000000002,19.4\n");
}

TEST(LatencyLine, IsOneLine) {
  EXPECT_EQ(latency_line(two_by_two("ours")),
            "Policy-loop latency: median 19.4 ms; 19.1 to 20.4 over the 3 cells.");
  EXPECT_EQ(latency_line(two_by_two("M1")),
            "Policy-loop latency: median 19.4 ms; 19.1 to 20.4 over the 3 cells. The paper prints "
            "19.6 ms in every cell.");
  study::StudyRecord same;
  same.add(study_trial("x", "Dark", true, {17.21}));
  same.add(study_trial("x", "Indoor", true, {17.19}));
  EXPECT_EQ(latency_line(same),
            "Policy-loop latency: median 17.2 ms; 17.2 in each of the 2 cells.");
  study::StudyRecord none;
  none.add(study_trial("M3", "Dark", true, {}));
  EXPECT_EQ(latency_line(none), "") << "nothing was logged, and the paper's number stands alone";
}

/// Everything that `certify` writes of a study, in one string.
std::string everything(const study::StudyRecord& study) {
  std::string text;
  for (const Table& table : study_tables(study)) {
    for (const TableFormat format : {TableFormat::text, TableFormat::json, TableFormat::latex}) {
      text += render(table, format);
    }
  }
  return text;
}

TEST(StudyTables, PutNothingOfThePaperBesideSomebodyElsesRobot) {
  const std::string theirs = everything(two_by_two("ours"));
  for (const char* const word : {"ublished", "paper", "19.6 ms in every", "0.135", "camera"}) {
    EXPECT_EQ(theirs.find(word), std::string::npos) << word;
  }
  const std::string papers = everything(two_by_two("CB-V"));
  for (const char* const word : {"published_speed_mps", "0.135", "19.6 ms in every", "camera"}) {
    EXPECT_NE(papers.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace tcert
