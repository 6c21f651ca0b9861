#include "analysis/study/driven/paired_arms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace tcert::study {
namespace {

const std::vector<std::string> kColumns{"world", "peak_force_n", "time_above_force_s", "stalls"};

TrialRow trial(
    const std::string& arm, int world, bool success, double time_s, const char* end = "") {
  TrialRow row;
  row.trial_id = arm + std::to_string(world);
  row.algorithm = arm;
  row.lighting = "Dark";
  row.day = "D" + std::to_string(world % 12);
  row.success = success;
  row.time_s = time_s;
  row.distance_m = 10.0;
  row.end_reason = success                   ? EndReason::goal
                   : std::string(end) == "c" ? EndReason::collision
                                             : EndReason::wedged;
  row.extra = {"w" + std::to_string(world), "20", "0.5", "1"};
  return row;
}

/// 48 worlds on 12 days: the gated arm is twice as fast and loses the worlds that it is told to.
std::vector<TrialRow> study_of(int lost, int won) {
  std::vector<TrialRow> trials;
  for (int world = 0; world < 48; ++world) {
    const bool base = world >= won;
    const bool own = world < won || world >= won + lost;
    trials.push_back(trial("M3", world, base, 100.0));
    trials.push_back(trial("M3+squash20", world, own, 50.0, "c"));
    trials.push_back(trial("CB-V", world, true, 60.0));
  }
  return trials;
}

const ArmComparison& gated(const PairedArms& compared) {
  EXPECT_EQ(compared.arms.front().arm, "M3+squash20");
  return compared.arms.front();
}

TEST(CompareArms, CountsWhatIsLostAndWon) {
  const PairedArms compared = compare_arms(study_of(5, 3), kColumns, {});
  const ArmComparison& found = gated(compared);
  EXPECT_EQ(found.pairs, 48U);
  EXPECT_EQ(found.lost, 5U);
  EXPECT_EQ(found.won, 3U);
  EXPECT_EQ(found.both, 40U);
  EXPECT_EQ(found.base.successes, 45U);
  EXPECT_EQ(found.own.successes, 43U);
  EXPECT_EQ(found.own.collisions, 5U);
  EXPECT_EQ(found.base.wedged, 3U);
  EXPECT_NEAR(found.difference, -2.0 / 48.0, 1e-15);
  EXPECT_NEAR(found.mcnemar_p.value(), 0.7265625, 1e-12);  // binom.test(3, 8)
  EXPECT_EQ(found.non_inferior, false);
}

/// 10 m in 100 s are 6 m/min, in 50 s 12, in 60 s 10: the gap is 4, the gain 6, were it not for
/// one world.
TEST(CompareArms, RatesAreThoseOfWorldsInWhichBothArrive) {
  std::vector<TrialRow> trials = study_of(5, 3);
  for (TrialRow& row : trials) {
    row.time_s = row.extra.front() == "w20" ? *row.time_s + 1.0 : *row.time_s;
  }
  const PairedArms compared = compare_arms(trials, kColumns, {});
  const ArmComparison& found = gated(compared);
  // 40 worlds in which M3 and the gated arm arrive, 45 in which M3 and the lead do.
  const double base = 60.0 * 400.0 / (40.0 * 100.0 + 1.0);
  const double gain = 60.0 * 400.0 / (40.0 * 50.0 + 1.0) - base;
  const double gap = 60.0 * 450.0 / (45.0 * 60.0 + 1.0) - 60.0 * 450.0 / (45.0 * 100.0 + 1.0);
  EXPECT_NEAR(found.base_rate.value.value(), base, 1e-12);
  EXPECT_NEAR(found.gain.value.value(), gain, 1e-12);
  EXPECT_NEAR(compared.gap.value.value(), gap, 1e-12);
  EXPECT_NEAR(found.recovered.value.value(), gain / gap, 1e-12);
}

/// Nothing differs: the bound is the exact one, 1 - 0.05^(1/48).
TEST(CompareArms, WithoutADifferenceTheBoundIsExact) {
  const PairedArms compared = compare_arms(study_of(0, 0), kColumns, {});
  EXPECT_NEAR(gated(compared).loss_upper.value(), 1.0 - std::pow(0.05, 1.0 / 48.0), 1e-12);
  EXPECT_EQ(gated(compared).non_inferior, false);  // 6 % and more could be lost
  EXPECT_FALSE(gated(compared).pairs_needed);
}

/// A loss more never tightens the bound, and what is won does not buy it off.
TEST(CompareArms, TheBoundOfTheLossRisesWithTheLoss) {
  double before = 0.0;
  for (int lost = 0; lost <= 48; ++lost) {
    const PairedArms compared = compare_arms(study_of(lost, 0), kColumns, {});
    const double bound = gated(compared).loss_upper.value();
    EXPECT_GE(bound, before) << lost;
    EXPECT_GE(bound, static_cast<double>(lost) / 48.0);
    before = bound;
  }
  EXPECT_EQ(before, 1.0);
  const double won = gated(compare_arms(study_of(0, 1), kColumns, {})).loss_upper.value();
  EXPECT_NEAR(won, 1.0 - std::pow(0.05, 1.0 / 48.0), 1e-12);
}

/// Nothing varies, and yet all of it is known: 0.05^(1/48) at least is lost.
TEST(CompareArms, WhereAllIsLostTheLossIsShown) {
  const PairedArms compared = compare_arms(study_of(48, 0), kColumns, {});
  EXPECT_EQ(gated(compared).difference, -1.0);
  EXPECT_EQ(gated(compared).non_inferior, false);
  EXPECT_GT(gated(compared).loss_lower.value(), 0.85);
}

/// The order of trials does not matter, nor does a trial of a world that the base did not drive.
TEST(CompareArms, DoesNotDependOnTheOrderOfTrials) {
  std::vector<TrialRow> trials = study_of(5, 3);
  const PairedArms compared = compare_arms(trials, kColumns, {});
  trials.push_back(trial("M3+squash20", 99, false, 10.0));
  std::mt19937_64 random(1);
  const auto first = std::find_if(trials.begin(), trials.end(), [](const TrialRow& row) {
    return row.algorithm == "M3+squash20";
  });
  std::iter_swap(trials.begin() + 1, first);
  std::shuffle(trials.begin() + 3, trials.end(), random);
  const PairedArms again = compare_arms(trials, kColumns, {});
  EXPECT_EQ(gated(again).lost, gated(compared).lost);
  EXPECT_EQ(gated(again).pairs, gated(compared).pairs);
  EXPECT_EQ(gated(again).gain.value, gated(compared).gain.value);
}

TEST(CompareArms, FewDaysHaveNoIntervals) {
  std::vector<TrialRow> trials = study_of(5, 3);
  for (TrialRow& row : trials) {
    row.day = row.day == "D1" ? "D1" : "D2";
  }
  const PairedArms compared = compare_arms(trials, kColumns, {});
  EXPECT_FALSE(gated(compared).difference_interval);
  EXPECT_FALSE(gated(compared).gain.interval);
  EXPECT_FALSE(gated(compared).non_inferior);
  EXPECT_NE(compared.withheld, "");
}

TEST(CompareArms, RefusesWhatCannotBePaired) {
  std::vector<TrialRow> twice = study_of(1, 1);
  twice.push_back(trial("M3", 0, true, 1.0));
  EXPECT_THROW(static_cast<void>(compare_arms(twice, kColumns, {})), std::invalid_argument);
  PairedOptions other;
  other.base = "M9";
  EXPECT_THROW(static_cast<void>(compare_arms(study_of(1, 1), kColumns, other)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(compare_arms(study_of(1, 1), {"peak_force_n"}, {})),
               std::invalid_argument);
}

}  // namespace
}  // namespace tcert::study
