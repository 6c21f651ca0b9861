#include "analysis/study/h3/chosen_beta.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/data_table.hpp"

namespace tcert::study {
namespace {

/// What a trial of a day takes at beta 5, 10 and 20, and at which of them it is lost.
struct DayOf {
  double at_5, at_10, at_20;
  bool lost_at_20 = false;
};

/// Days of four gated trials, two in each of two lightings, and of two of the baseline.
std::string replays(const std::vector<DayOf>& days) {
  std::string csv =
      "trial_id,algorithm,lighting,day,success,speed_law,beta_per_m,length_m,logged_time_s,"
      "gated_time_s,speed_cmd_mps,gated_speed_cmd_mps,loop_latency_ms,stalls,kept\n";
  for (std::size_t d = 0; d < days.size(); ++d) {
    const DayOf& day = days[d];
    for (int i = 0; i < 6; ++i) {
      for (const auto& [beta, time] :
           {std::pair(5, day.at_5), std::pair(10, day.at_10), std::pair(20, day.at_20)}) {
        const bool lead = i > 3;
        const bool lost = !lead && day.lost_at_20 && beta == 20;
        const std::string logged =
            lead ? "30" : std::to_string(60.0 + i + 0.5 * static_cast<double>(d % 5));
        csv += (lead ? "c" : "m") + std::to_string(d) + '_' + std::to_string(i) + ',' +
               (lead ? "CB-V" : "M3") + ',' + (i % 2 == 0 ? "Dark" : "Indoor") + ",d" +
               (d < 10 ? "0" : "") + std::to_string(d) + ",1,squash," + std::to_string(beta) +
               ",6," + logged + ',' + (lead ? "30" : std::to_string(time)) + ",0.1,0.1,20," +
               (lost ? "1,0" : "0,1") + '\n';
      }
    }
  }
  return csv;
}

H3Table h3_of(const std::vector<DayOf>& days, const H3Beta& beta) {
  H3Options options;
  options.replicates = 100;
  options.beta = beta;
  return hypothesis_h3(test_support::table_of(replays(days)), options);
}

H3Beta by_folds(std::size_t folds) {
  H3Beta beta;
  beta.per_m.reset();
  beta.folds = folds;
  return beta;
}

TEST(ChosenBeta, IsChosenOnOtherDaysThanItIsJudgedOn) {
  // On every day but those of the first fold 10 is fastest; on these 20 is, by far.
  std::vector<DayOf> days(20, DayOf{55.0, 40.0, 50.0});
  for (std::size_t d = 0; d < days.size(); d += 5) {
    days[d] = {55.0, 54.0, 5.0};
  }
  const H3Table found = h3_of(days, by_folds(5));
  const H3Chosen& all = found.chosen.front();
  ASSERT_EQ(all.lighting, "all");
  // Without the first fold 10 wins; without another the first fold's days make 20 win:
  // 3 of 15 days... of 60 + ... s: 12 days at 50 and 4 at 5 against 12 at 40 and 4 at 54.
  const std::vector<std::pair<double, std::size_t>> expected{{10.0, 1}, {20.0, 4}};
  EXPECT_EQ(all.betas, expected);
  // The first fold's four days at 54 s, the others' sixteen at 50 s.
  double logged = 0.0;
  for (std::size_t d = 0; d < 20; ++d) {
    for (int i = 0; i < 4; ++i) {
      logged += 60.0 + i + 0.5 * static_cast<double>(d % 5);
    }
  }
  const double gated = 4.0 * (4.0 * 54.0 + 16.0 * 50.0);
  EXPECT_NEAR(*all.gain.value, 60.0 * 480.0 / gated - 60.0 * 480.0 / logged, 1e-9);
}

TEST(ChosenBeta, WhatLosesMoreThanTheMarginIsNotChosen) {
  std::vector<DayOf> days(12, DayOf{55.0, 50.0, 20.0});
  for (std::size_t d = 0; d < 12; d += 2) {
    days[d].lost_at_20 = true;
  }
  const H3Chosen all = h3_of(days, by_folds(4)).chosen.front();
  const std::vector<std::pair<double, std::size_t>> expected{{10.0, 4}};
  EXPECT_EQ(all.betas, expected);
  EXPECT_EQ(all.lost, 0U);
}

TEST(ChosenBeta, BeforehandItIsTheOneOfTheTable) {
  const std::vector<DayOf> days(12, DayOf{55.0, 50.0, 45.0});
  const H3Table found = h3_of(days, {});
  for (const H3Chosen& one : found.chosen) {
    for (const H3Group& group : found.groups) {
      if (group.lighting == one.lighting) {
        EXPECT_NEAR(*one.gain.value, *group.cases.at(1).gain.value, 1e-12);
        EXPECT_NEAR(*one.recovered.value, *group.cases.at(1).recovered.value, 1e-12);
        EXPECT_EQ(one.lost_upper, group.cases.at(1).lost_upper);
      }
    }
  }
  H3Beta other;
  other.per_m = 7.0;
  EXPECT_EQ(h3_of(days, other).chosen.front().betas.front().first, 10.0) << "the middle one";
  other.asked = true;
  EXPECT_THROW(static_cast<void>(h3_of(days, other)), std::invalid_argument);
}

TEST(ChosenBeta, AtOnceNeedsMoreThanAlone) {
  const H3Table found = h3_of(std::vector<DayOf>(12, DayOf{55.0, 50.0, 45.0}), {});
  ASSERT_EQ(found.chosen.size(), 3U) << "all, Dark, Indoor";
  EXPECT_EQ(found.chosen[0].holm, found.chosen[0].p) << "one law";
  for (const H3Chosen& one : found.chosen) {
    EXPECT_LT(*one.gain_p, 1e-6);
    EXPECT_EQ(*one.p, std::max(*one.gain_p, *one.loss_p));
    EXPECT_EQ(*one.holds, *one.holm <= 0.05);
    EXPECT_GE(*one.trials_for_power, 59.0);
  }
  EXPECT_EQ(*found.chosen[1].holm, 2.0 * *found.chosen[1].p) << "both lightings alike";
}

TEST(ChosenBeta, FewDaysHaveNoTests) {
  for (const H3Chosen& one : h3_of(std::vector<DayOf>(9, DayOf{55.0, 50.0, 45.0}), {}).chosen) {
    EXPECT_TRUE(one.gain.value);
    EXPECT_FALSE(one.gain.interval);
    EXPECT_FALSE(one.p);
    EXPECT_FALSE(one.holds);
    EXPECT_FALSE(one.lost_upper);
  }
}

}  // namespace
}  // namespace tcert::study
