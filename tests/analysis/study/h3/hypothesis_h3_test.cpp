#include "analysis/study/h3/hypothesis_h3.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>

#include "support/data_table.hpp"

namespace tcert::study {
namespace {

const std::string kHeader =
    "trial_id,algorithm,lighting,day,success,speed_law,beta_per_m,length_m,logged_time_s,"
    "gated_time_s,speed_cmd_mps,gated_speed_cmd_mps,loop_latency_ms,stalls,kept\n";

/// Pairs of days, each of four gated trials that succeed and one that fails, and of a baseline
/// trial a day, at two betas. At beta 20 the fourth trial stalls. `lighting(id)` names the light.
template <class Lighting>
std::string study(int pairs, const Lighting& lighting) {
  std::string csv = kHeader;
  const auto add = [&](const std::string& id,
                       const std::string& pair,
                       const std::string& algorithm,
                       const std::string& day,
                       int success,
                       double length,
                       double time,
                       double gated_5,
                       double gated_20,
                       int stalls_20) {
    for (const bool steep : {false, true}) {
      const int stalls = steep ? stalls_20 : 0;
      csv += id + pair + ',' + algorithm + ',' + lighting(id) + ',' + day + pair + ',' +
             std::to_string(success) + ",squash," + (steep ? "20," : "5,") +
             std::to_string(length) + ',' + std::to_string(time) + ',' +
             std::to_string(steep ? gated_20 : gated_5) + ",0.12,0.15,19.6," +
             std::to_string(stalls) + ',' + (success == 1 && stalls == 0 ? "1" : "0") + '\n';
    }
  };
  for (int i = 0; i < pairs; ++i) {
    const std::string pair = "_" + std::to_string(i);
    const double slow = lighting("c1") == lighting("c2") ? 30.0 : 60.0;
    add("t1", pair, "M3", "a", 1, 6.0, 60.0, 50.0, 40.0, 0);
    add("t2", pair, "M3", "a", 1, 6.0, 70.0, 50.0, 40.0, 0);
    add("t3", pair, "M3", "b", 1, 6.0, 60.0, 55.0, 45.0, 0);
    add("t4", pair, "M3", "b", 1, 6.0, 50.0, 45.0, 35.0, 2);
    add("t5", pair, "M3", "b", 0, 3.0, 90.0, 90.0, 90.0, 1);
    add("c1", pair, "CB-V", "a", 1, 6.0, slow, slow, slow, 0);
    add("c2", pair, "CB-V", "b", 1, 6.0, 30.0, 30.0, 30.0, 0);
    add("x1", pair, "M1", "b", 1, 6.0, 10.0, 10.0, 10.0, 0);
  }
  return csv;
}

/// Twelve days in one light.
std::string small_study(int pairs = 6) {
  return study(pairs, [](const std::string&) { return "Dark"; });
}

H3Table h3_of(const std::string& csv, std::size_t replicates = 200) {
  H3Options options;
  options.replicates = replicates;
  return hypothesis_h3(test_support::table_of(csv), options);
}

TEST(HypothesisH3, ASmallStudyByHand) {
  const H3Table found = h3_of(small_study());
  ASSERT_EQ(found.groups.size(), 1U) << "one lighting is all of them";
  const H3Group& all = found.groups[0];
  EXPECT_EQ(all.lighting, "all");
  EXPECT_EQ(all.trials, 30U);
  EXPECT_EQ(all.successes, 24U);
  EXPECT_EQ(all.baseline_successes, 12U);
  EXPECT_EQ(all.clusters, 12U);
  // 24 m in 240 s, 12 m in 60 s in every pair of days.
  EXPECT_NEAR(all.ungated.value.value(), 6.0, 1e-12);
  EXPECT_NEAR(all.baseline.value.value(), 12.0, 1e-12);
  EXPECT_NEAR(all.gap.value.value(), 6.0, 1e-12);
  EXPECT_NEAR(all.latency_ms.value(), 19.6, 1e-12);
  ASSERT_EQ(all.cases.size(), 2U);
  const H3Case& gentle = all.cases[0];
  EXPECT_EQ(gentle.law, "squash");
  EXPECT_EQ(gentle.beta_per_m, 5.0);
  // 24 m in 200 s.
  EXPECT_NEAR(gentle.gated.value.value(), 7.2, 1e-12);
  EXPECT_NEAR(gentle.gain.value.value(), 1.2, 1e-12);
  EXPECT_NEAR(gentle.gain_share.value.value(), 0.2, 1e-12);
  EXPECT_EQ(gentle.kept, 24U);
  EXPECT_EQ(gentle.lost, 0U);
  EXPECT_NEAR(gentle.lost_upper.value(), 1.0 - std::pow(0.05, 1.0 / 30.0), 1e-12);
  EXPECT_FALSE(gentle.non_inferior.value());
  const H3Case& steep = all.cases[1];
  // 24 m in 160 s; the trial that stalls stays in the pair.
  EXPECT_NEAR(steep.gated.value.value(), 9.0, 1e-12);
  EXPECT_EQ(steep.kept, 18U);
  EXPECT_EQ(steep.lost, 6U);
  EXPECT_NEAR(steep.lost_share.value(), 0.2, 1e-12);
  EXPECT_NEAR(steep.retained.value(), 0.75, 1e-12);
  EXPECT_EQ(steep.stalls, 18U);
  EXPECT_EQ(steep.stalled_trials, 12U);
  EXPECT_TRUE(gentle.on_front) << "nothing keeps more";
  EXPECT_TRUE(steep.on_front) << "nothing gains more";
}

TEST(HypothesisH3, ReplicatesAreRatiosOverDays) {
  const H3Table found = h3_of(small_study(), 500);
  const H3Group& all = found.groups[0];
  // Day a alone: 12 m in 130 s; day b alone: 12 m in 110 s. All resamples lie between.
  ASSERT_TRUE(all.ungated.interval);
  EXPECT_GE(all.ungated.interval->low, 12.0 / 130.0 * 60.0 - 1e-9);
  EXPECT_LE(all.ungated.interval->high, 12.0 / 110.0 * 60.0 + 1e-9);
  // The gap is the baseline's constant 12 less that: its interval excludes 0.
  ASSERT_TRUE(all.gap.interval);
  EXPECT_GT(all.gap.interval->low, 0.0);
  EXPECT_NEAR(all.cases[0].recovered.value.value(), 0.2, 1e-12);
  EXPECT_NEAR(all.cases[1].recovered.value.value(), 0.5, 1e-12);
}

TEST(HypothesisH3, TheGapIsThatOfOneMixOfLightings) {
  // The gated algorithm drives 6 m of 24 in the dark, the baseline 6 of 12, where it is half as
  // fast.
  const H3Table found = h3_of(
      study(6, [](const std::string& id) { return id == "t1" || id == "c1" ? "Dark" : "Indoor"; }));
  ASSERT_EQ(found.groups.size(), 3U);
  const H3Group& all = found.groups[0];
  EXPECT_NEAR(all.baseline.value.value(), 8.0, 1e-12) << "12 m in 90 s";
  // 24 m at 6 m/min for 6 of them and 12 m/min for 18.
  EXPECT_NEAR(all.baseline_standardised.value.value(), 24.0 / 2.5, 1e-12);
  EXPECT_NEAR(all.gap.value.value(), 3.6, 1e-12);
  EXPECT_NEAR(all.gap_as_run.value.value(), 2.0, 1e-12);
  EXPECT_NEAR(all.cases[0].recovered.value.value(), 1.2 / 3.6, 1e-12) << "0.6 of the gap as run";
  ASSERT_TRUE(all.gap.interval);
  EXPECT_GT(all.gap.interval->low, *all.gap_as_run.value);
  for (std::size_t g = 1; g < 3; ++g) {
    const H3Group& one = found.groups[g];
    EXPECT_NEAR(*one.gap.value, *one.gap_as_run.value, 1e-12) << "one light is its own mix";
  }
}

TEST(HypothesisH3, ALightWithoutTheBaselineLeavesNoGap) {
  const H3Table found =
      h3_of(study(6, [](const std::string& id) { return id == "t1" ? "Dark" : "Indoor"; }));
  EXPECT_FALSE(found.groups[0].gap.value);
  EXPECT_TRUE(found.groups[0].gap_as_run.value);
  EXPECT_FALSE(found.groups[0].cases[0].recovered.value);
}

TEST(HypothesisH3, WithholdsInferenceFromFewDays) {
  const H3Group few = h3_of(small_study(4)).groups[0];
  EXPECT_EQ(few.withheld, "8 clusters of 'day', fewer than 10");
  EXPECT_NEAR(few.gap.value.value(), 6.0, 1e-12);
  EXPECT_FALSE(few.gap.interval || few.ungated.interval || few.ungated.intervals.bca);
  const H3Case& one = few.cases[0];
  EXPECT_TRUE(one.gain.value && one.lost_share && one.retained);
  EXPECT_FALSE(one.gain.interval || one.recovered.value || one.lost_upper || one.non_inferior ||
               one.retained_interval);
  EXPECT_TRUE(statistics::has(few.conditions, statistics::ConditionKind::withheld));
  // Enough days, but few successes of the baseline: only its rates have no intervals.
  std::string csv = small_study(6);
  for (const char* const id : {"c1_0,", "c1_1,", "c1_2,"}) {
    const std::string from = std::string(id) + "CB-V,Dark,a_" + id[3] + ",1";
    for (std::size_t at = csv.find(from); at != std::string::npos; at = csv.find(from)) {
      csv[at + from.size() - 1] = '0';
    }
  }
  const H3Group scarce = h3_of(csv).groups[0];
  EXPECT_EQ(scarce.withheld, "");
  EXPECT_EQ(scarce.baseline_successes, 9U);
  EXPECT_FALSE(scarce.gap.interval || scarce.cases[0].recovered.value);
  EXPECT_TRUE(scarce.cases[0].gain.interval && scarce.cases[0].lost_upper);
}

/// The trials named `id` of these pairs of days fail at every beta.
void fail(std::string& csv, const std::string& id, int pairs) {
  for (int i = 0; i < pairs; ++i) {
    const std::string name = id + "_" + std::to_string(i) + ",";
    for (std::size_t at = csv.find(name); at != std::string::npos; at = csv.find(name, at + 1)) {
      std::size_t cell = at;
      for (int comma = 0; comma < 4; ++comma) {
        cell = csv.find(',', cell) + 1;
      }
      csv[cell] = '0';
    }
  }
}

std::string details(const H3Group& group, statistics::ConditionKind kind) {
  std::string all;
  for (const statistics::Condition& condition : group.conditions) {
    all += condition.kind == kind ? condition.detail + ";" : "";
  }
  return all;
}

TEST(HypothesisH3, NamesEveryAlgorithmThatIsFew) {
  std::string csv =
      study(6, [](const std::string& id) { return id == "t1" || id == "c1" ? "Dark" : "Indoor"; });
  for (const char* const id : {"t2", "t3", "t4"}) {
    fail(csv, id, 6);
  }
  const H3Group gated = h3_of(csv).groups[0];
  EXPECT_EQ(gated.successes, 6U);
  EXPECT_EQ(gated.clusters, 12U);
  EXPECT_EQ(details(gated, statistics::ConditionKind::withheld),
            "6 successes of 'M3', fewer than 10;");
  EXPECT_TRUE(gated.baseline.interval) << "its rate is its own";
  EXPECT_FALSE(gated.ungated.interval || gated.gap.interval || gated.cases[0].gain.interval);
  fail(csv, "c1", 3);
  const H3Group both = h3_of(csv).groups[0];
  EXPECT_EQ(details(both, statistics::ConditionKind::withheld),
            "6 successes of 'M3', fewer than 10;9 successes of 'CB-V', fewer than 10;");
  EXPECT_FALSE(both.baseline.interval);
  // A baseline that never succeeds has no rate, and it is said.
  std::string none = small_study(6);
  fail(none, "c1", 6);
  fail(none, "c2", 6);
  const H3Group without = h3_of(none).groups[0];
  EXPECT_EQ(details(without, statistics::ConditionKind::withheld),
            "0 successes of 'CB-V', fewer than 10;");
  EXPECT_TRUE(without.ungated.interval);
}

TEST(HypothesisH3, FewClustersAreSaidAsEverywhere) {
  EXPECT_EQ(details(h3_of(small_study(6)).groups[0], statistics::ConditionKind::few_clusters),
            "12 clusters, fewer than 30;");
}

TEST(HypothesisH3, OneDayHasNoInterval) {
  std::string csv = kHeader;
  for (int i = 0; i < 12; ++i) {
    csv += "t" + std::to_string(i) + ",M3,Dark,a,1,squash,5,6," + std::to_string(50 + i) +
           ",40,0.12,0.15,19.6,0,1\n";
  }
  const H3Group one = h3_of(csv).groups[0];
  EXPECT_EQ(one.clusters, 1U);
  EXPECT_TRUE(one.ungated.value);
  EXPECT_FALSE(one.ungated.interval);
}

TEST(HypothesisH3, AnIntervalIsExpandedForTheDaysOfItsOwnAlgorithm) {
  // The baseline runs on the 12 days of the others and on 30 more.
  std::string csv = small_study(6);
  for (int i = 0; i < 30; ++i) {
    for (const char* const beta : {"5", "20"}) {
      csv += "m" + std::to_string(i) + ",CB-V,Dark,m_" + std::to_string(i) + ",1,squash," + beta +
             ",6," + std::to_string(25 + i % 7) + ",30,0.12,0.15,19.6,0,1\n";
    }
  }
  const table::DataTable table = test_support::table_of(csv);
  H3Options options;
  options.replicates = 999;
  const H3Group found = hypothesis_h3(table, options).groups[0];
  EXPECT_EQ(found.clusters, 42U);
  // Expanded percentiles of G units are percentiles of a higher level, of the same resamples.
  const auto of_units = [&](std::size_t units) {
    H3Options other = options;
    other.level = 1.0 - 2.0 * statistics::expanded_tail(options.level, units);
    return hypothesis_h3(table, other).groups[0];
  };
  const H3Group gated = of_units(12);
  EXPECT_NEAR(found.ungated.intervals.expanded->low, gated.ungated.intervals.percentile->low, 1e-9);
  EXPECT_NEAR(found.cases[0].gain.intervals.expanded->high,
              gated.cases[0].gain.intervals.percentile->high,
              1e-9);
  EXPECT_NEAR(found.gap.intervals.expanded->low, gated.gap.intervals.percentile->low, 1e-9)
      << "the fewer of both";
  EXPECT_NEAR(found.baseline.intervals.expanded->low,
              of_units(42).baseline.intervals.percentile->low,
              1e-9);
}

TEST(HypothesisH3, WithoutABaselineThereIsNoGap) {
  std::string csv = small_study();
  for (std::size_t at = csv.find("CB-V"); at != std::string::npos; at = csv.find("CB-V")) {
    csv.replace(at, 4, "TVFH");
  }
  const H3Table found = h3_of(csv);
  EXPECT_FALSE(found.groups[0].gap.value);
  EXPECT_FALSE(found.groups[0].cases[0].recovered.value);
  EXPECT_TRUE(found.groups[0].cases[0].gain.value);
}

TEST(HypothesisH3, OrderOfRowsChangesNothing) {
  const std::string csv = small_study();
  std::string turned = kHeader;
  std::vector<std::string> lines;
  for (std::size_t from = kHeader.size(); from < csv.size();) {
    const std::size_t end = csv.find('\n', from) + 1;
    lines.push_back(csv.substr(from, end - from));
    from = end;
  }
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    turned += *line;
  }
  const H3Table one = h3_of(csv);
  const H3Table other = h3_of(turned);
  ASSERT_TRUE(one.groups[0].gap.interval && other.groups[0].gap.interval);
  EXPECT_EQ(one.groups[0].gap.interval->low, other.groups[0].gap.interval->low);
  EXPECT_EQ(one.groups[0].cases[1].gain.interval->high,
            other.groups[0].cases[1].gain.interval->high);
}

TEST(HypothesisH3, SaysWhatItCannotUse) {
  H3Options options;
  EXPECT_THROW((void)hypothesis_h3(test_support::table_of("a,b\n1,2\n"), options),
               std::invalid_argument);
  const std::string csv = small_study();
  const std::string cut = csv.substr(0, csv.rfind('\n', csv.size() - 2) + 1);
  EXPECT_NO_THROW((void)hypothesis_h3(test_support::table_of(cut), options)) << "of M1";
  const std::size_t c2 = csv.find("c2_0,");
  const std::size_t end = csv.find('\n', c2) + 1;
  EXPECT_THROW(
      (void)hypothesis_h3(test_support::table_of(csv.substr(0, c2) + csv.substr(end)), options),
      std::invalid_argument)
      << "a trial that lacks a beta";
  options.gated = "nobody";
  options.baseline = "no one";
  EXPECT_TRUE(statistics::has(hypothesis_h3(test_support::table_of(csv), options).conditions,
                              statistics::ConditionKind::no_rows));
}

TEST(HypothesisH3, TellsAWatchOfTheResamplesOfEachLighting) {
  std::vector<std::string> parts;
  std::atomic<std::size_t> steps = 0;
  const Watch watch{[&](const std::string& part, std::size_t) { parts.push_back(part); },
                    [&] { ++steps; }};
  H3Options options;
  options.replicates = 50;
  const std::string csv =
      study(6, [](const std::string& id) { return id == "c1" ? "Dark" : "Indoor"; });
  (void)hypothesis_h3(test_support::table_of(csv), options, watch);
  EXPECT_EQ(parts.front(), "lighting all, resamples");
  EXPECT_EQ(steps, 50 * parts.size());
}

}  // namespace
}  // namespace tcert::study
