#include "analysis/study/federation/federation_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/study/federation/trial_submap.hpp"

namespace tcert::study {
namespace {

TEST(FederationStudy, WhatIsProvedTogetherIsAtMostTheTruthAndAtLeastWhatEachProves) {
  int joined = 0;
  for (std::uint64_t world = 0; world < 8; ++world) {
    const FederationOutcome outcome = federate_world(1, world);
    ASSERT_EQ(outcome.teams.size(), kTeams.size() * kFederationMethods.size());
    for (std::size_t i = 0; i < outcome.teams.size(); ++i) {
      const TeamOutcome& team = outcome.teams[i];
      const std::size_t robots = kTeams.at(i / kFederationMethods.size());
      ASSERT_GE(team.certificate_m, team.best_alone_m);
      if (kFederationMethods.at(i % kFederationMethods.size()) != FederationMethod::width) {
        ASSERT_LE(team.certificate_m, outcome.truth_m) << world << ' ' << robots;
      }
      ASSERT_EQ(team.time_s.has_value(), team.certificate_m > 0.0);
      if (robots == 1) {
        ASSERT_EQ(team.certificate_m, team.best_alone_m);
        ASSERT_EQ(team.joins, 0U);
      }
      ASSERT_LT(team.bytes, 20'000 * robots);
      ASSERT_GE(team.dwell_s, 0.0);
      joined += team.certificate_m > team.best_alone_m ? 1 : 0;
    }
    EXPECT_EQ(table::row_text(table::from_row<FederationOutcome>(table::row_text(outcome))),
              table::row_text(outcome));
  }
  EXPECT_GT(joined, 5) << "too few know more together to test anything";
}

TEST(SourceName, TellsTrialsOfOtherLogsApart) {
  const std::string digest(64, 'a');
  EXPECT_EQ(source_name("t 1", digest), "t_1/aaaaaaaaaaaa");
  EXPECT_TRUE(federation::is_name(source_name(std::string(500, 'x'), digest)));
}

}  // namespace
}  // namespace tcert::study
