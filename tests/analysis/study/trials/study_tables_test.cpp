#include "analysis/study/trials/study_tables.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tcert::study {
namespace {

TrialRecord trial(const char* algorithm,
                  const char* lighting,
                  std::optional<bool> success,
                  const std::vector<double>& speeds) {
  TrialRecord record;
  record.row.trial.algorithm = algorithm;
  record.row.trial.lighting = lighting;
  record.row.trial.success = success;
  record.speed_cmd_mps = Tally(speeds);
  return record;
}

TEST(StudyRecord, PoolsSamplesSoThatALongTrialWeighsMore) {
  StudyRecord study;
  study.add(trial("M1", "Dark", true, {0.1}));
  study.add(trial("M1", "Indoor", true, {0.2, 0.2, 0.2}));
  const auto groups = study.by_algorithm();
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].trials, 2U);
  EXPECT_EQ(groups[0].speed_cmd_mps.median(), 0.2);
  EXPECT_FALSE(groups[0].loop_latency_ms.median().has_value());
}

TEST(StudyRecord, CountsKnownOutcomesOnly) {
  StudyRecord study;
  study.add(trial("M1", "Dark", true, {}));
  study.add(trial("M1", "Dark", false, {}));
  study.add(trial("M1", "Dark", std::nullopt, {}));
  const auto cells = study.by_cell();
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].trials, 3U);
  EXPECT_EQ(cells[0].known, 2U);
  EXPECT_EQ(cells[0].successes, 1U);
  EXPECT_EQ(study.rows().size(), 3U);
}

TEST(StudyRecord, ListsThePapersGroupsFirst) {
  StudyRecord study;
  for (const char* algorithm : {"another", "TVFH", "CB-V", "a-new-one", "M1"}) {
    study.add(trial(algorithm, "Outdoor", true, {}));
    study.add(trial(algorithm, "Dark", true, {}));
  }
  std::vector<std::string> names;
  for (const StudyGroup& group : study.by_algorithm()) {
    names.push_back(group.algorithm);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"CB-V", "M1", "TVFH", "a-new-one", "another"}));
  EXPECT_EQ(study.by_lighting().front().lighting, "Dark");
  EXPECT_EQ(study.by_cell().size(), 10U);
}

TEST(StudyRecord, IsOfThePaperOnlyWithThePapersAlgorithmsAlone) {
  StudyRecord study;
  EXPECT_FALSE(study.is_of_paper());
  study.add(trial("M3", "Dark", true, {}));
  study.add(trial("CB-V", "a tunnel", true, {}));
  EXPECT_TRUE(study.is_of_paper());
  study.add(trial("ours", "Dark", true, {}));
  EXPECT_FALSE(study.is_of_paper()) << "somebody else's robot among them";
  EXPECT_FALSE(is_paper_algorithm("Dark")) << "a lighting";
  EXPECT_FALSE(is_paper_algorithm(""));
  EXPECT_EQ(study.all().trials, 3U);
}

TEST(PublishedSpeed, IsKnownForThePapersNamesOnly) {
  EXPECT_EQ(published_speed_mps("M2"), 0.12);
  EXPECT_FALSE(published_speed_mps("").has_value());
}

}  // namespace
}  // namespace tcert::study
