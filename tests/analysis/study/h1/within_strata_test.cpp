#include "analysis/study/h1/within_strata.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::study {
namespace {

struct Trial {
  std::string algorithm, lighting, day;
  bool success = false;
  double time = 0.0;
  double tc = 0.0;
  double speed = 0.0;
};

/// Algorithms differ in speed and in success, and `speed` knows nothing else; `tc` knows a little
/// within them. Values are coarse, so that there are ties. A few trials have no lighting.
std::vector<Trial> trials_of(int count) {
  table::RandomStream random(9, 1, 0);
  std::vector<Trial> trials;
  for (int i = 0; i < count; ++i) {
    Trial one;
    const int algorithm = i % 3;
    one.algorithm = std::string(1, static_cast<char>('A' + algorithm));
    one.lighting = i % 17 == 0 ? "" : (i % 2 == 0 ? "Dark" : "Indoor");
    one.day = "d" + std::to_string(i % 12);
    one.tc = std::round(4.0 * random.normal()) / 4.0;
    one.speed = algorithm + std::round(random.normal()) / 10.0;
    one.success = random.uniform() < 1.0 / (1.0 + std::exp(-0.4 * one.tc - 0.9 * algorithm));
    one.time = std::round(60.0 - 12.0 * algorithm - 2.0 * one.tc + 6.0 * random.normal());
    trials.push_back(one);
  }
  return trials;
}

std::string csv_of(const std::vector<Trial>& trials) {
  std::string csv = "algorithm,lighting,day,success,time_s,tc_early,speed\n";
  for (const Trial& one : trials) {
    csv += one.algorithm + "," + one.lighting + "," + one.day + (one.success ? ",1," : ",0,") +
           std::to_string(one.time) + "," + std::to_string(one.tc) + "," +
           std::to_string(one.speed) + "\n";
  }
  return csv;
}

H1Options options_of(std::vector<std::string> within) {
  H1Options options;
  options.predictors = {{"tc_early", statistics::HigherMeans::success, ""},
                        {"speed", statistics::HigherMeans::failure, ""}};
  options.replicates = 400;
  options.models = false;
  options.within = std::move(within);
  return options;
}

/// Every pair by itself: of one stratum, both strata known.
struct Count {
  double wins = 0.0;
  double pairs = 0.0;
  void add(double better, double worse) {
    wins += better > worse ? 1.0 : (better == worse ? 0.5 : 0.0);
    pairs += 1.0;
  }
};

Count auc_by_pairs(const std::vector<Trial>& trials, bool by_tc) {
  Count count;
  for (const Trial& a : trials) {
    for (const Trial& b : trials) {
      if (a.success && !b.success && a.algorithm == b.algorithm && a.lighting == b.lighting &&
          !a.lighting.empty()) {
        by_tc ? count.add(a.tc, b.tc) : count.add(-a.speed, -b.speed);
      }
    }
  }
  return count;
}

Count c_by_pairs(const std::vector<Trial>& trials, bool by_tc) {
  Count count;
  for (const Trial& a : trials) {
    for (const Trial& b : trials) {
      const bool sooner = a.time < b.time || (a.time == b.time && !b.success);
      if (&a != &b && a.success && sooner && a.algorithm == b.algorithm &&
          a.lighting == b.lighting && !a.lighting.empty()) {
        by_tc ? count.add(a.tc, b.tc) : count.add(-a.speed, -b.speed);
      }
    }
  }
  return count;
}

TEST(WithinStrata, CountsPairsOfOneStratum) {
  const std::vector<Trial> trials = trials_of(300);
  const H1Panel panel =
      hypothesis_h1(test_support::table_of(csv_of(trials)), options_of({"algorithm", "lighting"}))
          .panels[0];
  EXPECT_EQ(panel.within.columns, (std::vector<std::string>{"algorithm", "lighting"}));
  EXPECT_EQ(panel.within.levels, 6U);
  EXPECT_EQ(panel.within.missing, 18U);
  for (const bool by_tc : {true, false}) {
    const H1WithinScores& within = panel.rows[by_tc ? 0 : 1].within;
    const Count auc = auc_by_pairs(trials, by_tc);
    const Count c = c_by_pairs(trials, by_tc);
    EXPECT_NEAR(within.auc.value.value(), auc.wins / auc.pairs, 1e-12);
    EXPECT_NEAR(within.c.value.value(), c.wins / c.pairs, 1e-12);
    EXPECT_EQ(static_cast<double>(panel.within.auc_pairs), auc.pairs);
    EXPECT_EQ(static_cast<double>(panel.within.c_pairs), c.pairs);
    EXPECT_LT(within.auc.interval.value().low, *within.auc.value);
    EXPECT_GT(within.auc.interval->high, *within.auc.value);
    EXPECT_LT(within.c.closed_form.value().low, *within.c.value);
  }
  EXPECT_LT(panel.within.auc_pairs, panel.within.all_auc_pairs / 3);
  const H1WithinScores& rival = panel.rows[1].within;
  EXPECT_NEAR(*rival.auc_gain.value, *panel.rows[0].within.auc.value - *rival.auc.value, 1e-12);
}

TEST(WithinStrata, AGainBetweenGroupsVanishesWithinThem) {
  // `speed`, turned to the wrong side, loses to tc by what algorithms differ in.
  H1Options options = options_of({"algorithm"});
  options.predictors[1].higher = statistics::HigherMeans::success;
  const H1Panel panel =
      hypothesis_h1(test_support::table_of(csv_of(trials_of(600))), options).panels[0];
  const H1Row& speed = panel.rows[1];
  EXPECT_GT(speed.auc.value.value(), 0.65) << "between algorithms";
  EXPECT_NEAR(speed.within.auc.value.value(), 0.5, 0.08);
  EXPECT_LT(speed.auc_gain.value.value(), 0.0);
  EXPECT_GT(speed.within.auc_gain.value.value(), 0.0);
}

TEST(WithinStrata, OneStratumIsThePooledNumber) {
  std::vector<Trial> trials = trials_of(300);
  for (Trial& one : trials) {
    one.lighting = "Dark";
  }
  const H1Panel panel =
      hypothesis_h1(test_support::table_of(csv_of(trials)), options_of({"lighting"})).panels[0];
  for (const H1Row& row : panel.rows) {
    EXPECT_NEAR(row.within.auc.value.value(), row.auc.value.value(), 1e-12);
    EXPECT_NEAR(row.within.c.value.value(), row.c.value.value(), 1e-12);
    EXPECT_NEAR(row.within.c.std_error.value(), row.c.std_error.value(), 1e-12);
    EXPECT_NEAR(row.within.c.interval->low, row.c.interval->low, 1e-12);
  }
  EXPECT_EQ(panel.within.auc_pairs, panel.within.all_auc_pairs);
  EXPECT_EQ(panel.within.c_pairs, panel.within.all_c_pairs);
}

TEST(WithinStrata, WithoutColumnsThereAreNone) {
  const table::DataTable table = test_support::table_of(csv_of(trials_of(120)));
  const H1Panel panel = hypothesis_h1(table, options_of({"planner"})).panels[0];
  EXPECT_TRUE(panel.within.columns.empty());
  EXPECT_FALSE(panel.rows[0].within.auc.value);
  const H1Panel some = hypothesis_h1(table, options_of({"planner", "lighting"})).panels[0];
  EXPECT_EQ(some.within.columns, std::vector<std::string>{"lighting"});
}

}  // namespace
}  // namespace tcert::study
