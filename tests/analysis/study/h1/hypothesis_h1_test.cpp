#include "analysis/study/h1/hypothesis_h1.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <statistics/basics/chi_square.hpp>
#include <statistics/glmm/glmm.hpp>
#include <statistics/model/expression.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>
#include <statistics/roc/roc.hpp>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::study {
namespace {

using test_support::table_of;

/// Trials on `days` days; a larger tc makes success likelier and sooner, noise does nothing.
std::string trials_csv(int days, int per_day, const std::string& header_tail = "") {
  table::RandomStream random(7, 1, 0);
  std::string csv =
      "day,algorithm,success,time_s,tc_early,noise,end_s,window_end_s,still_at_landmark,tc_"
      "landmark" +
      header_tail + "\n";
  for (int day = 0; day < days; ++day) {
    for (int k = 0; k < per_day; ++k) {
      const double tc = random.normal();
      const bool success = random.uniform() < 1.0 / (1.0 + std::exp(-1.0 - tc));
      const double time =
          success ? 30.0 + 20.0 * random.uniform() - 5.0 * tc : 10.0 + 80.0 * random.uniform();
      csv += "d" + std::to_string(day) + "," + (k % 2 == 0 ? "A" : "B") + "," +
             (success ? "1" : "0") + "," + std::to_string(time) + "," + std::to_string(tc) + "," +
             std::to_string(random.normal()) + "," + std::to_string(time) + ",12," +
             (k == 3 ? "1" : "0") + "," + std::to_string(tc) + "\n";
    }
  }
  return csv;
}

H1Options options_for(const std::string& rival = "noise") {
  H1Options options;
  options.predictors = {{"tc_early", statistics::HigherMeans::success, "tc_landmark"},
                        {rival, statistics::HigherMeans::failure, ""}};
  options.replicates = 200;
  return options;
}

TEST(HypothesisH1, HasTheMixedModelThatFitGives) {
  const table::DataTable table = table_of(trials_csv(12, 20));
  const H1Panel panel = hypothesis_h1(table, options_for()).panels.front();
  const auto fit = [&](const std::string& formula) {
    return statistics::fit_glmm(
        statistics::glmm_input(statistics::model_frame(statistics::parse_formula(formula), table)));
  };
  const statistics::GlmmFit alone = fit("success ~ tc_early + (1 | day)");
  const statistics::GlmmFit rival = fit("success ~ noise + (1 | day)");
  const statistics::GlmmFit both = fit("success ~ tc_early + noise + (1 | day)");
  const H1MixedModel& mixed = panel.rows[0].mixed;
  const double slope = alone.coefficients[1].estimate.value();
  EXPECT_NEAR(std::log(mixed.per_sd.ratio.value()), slope * panel.rows[0].sd.value(), 1e-7);
  EXPECT_NEAR(std::log(mixed.per_cm.ratio.value()), 0.01 * slope, 1e-9);
  EXPECT_NEAR(mixed.sd_cluster.value(), alone.random[0].sd[0], 1e-6);
  EXPECT_NEAR(mixed.log_likelihood.value(), alone.log_likelihood.value(), 1e-9);
  // Towards the better side: fewer is better.
  EXPECT_NEAR(std::log(panel.rows[1].mixed.per_sd.ratio.value()),
              -rival.coefficients[1].estimate.value() * panel.rows[1].sd.value(),
              1e-7);
  EXPECT_FALSE(panel.rows[1].mixed.per_cm.ratio) << "no metres";
  EXPECT_FALSE(panel.rows[2].mixed.per_sd.ratio) << "no single ratio";
  const double statistic = 2.0 * (*both.log_likelihood - *rival.log_likelihood);
  EXPECT_NEAR(panel.rows[3].mixed.lr_p_value.value(),
              statistics::chi_square_test(statistic, 1).p_value,
              1e-9);
}

TEST(HypothesisH1, HasNoMixedModelWhereTrialsAreTheirOwnClusters) {
  H1Options options = options_for();
  options.cluster = "";
  const H1Panel panel = hypothesis_h1(table_of(trials_csv(4, 20)), options).panels.front();
  EXPECT_FALSE(panel.rows[0].mixed.per_sd.ratio);
}

TEST(HypothesisH1, ScoresEveryRowByClusters) {
  const H1Table h1 = hypothesis_h1(table_of(trials_csv(12, 20)), options_for());
  ASSERT_EQ(h1.panels.size(), 1U);  // The rival has no landmark column.
  const H1Panel& panel = h1.panels.front();
  EXPECT_EQ(panel.complete, 240U);
  EXPECT_EQ(panel.clusters, 12U);
  ASSERT_EQ(panel.rows.size(), 4U);
  const H1Row& tc = panel.rows[0];
  EXPECT_GT(tc.auc.value.value(), 0.65);
  EXPECT_LT(tc.auc.interval.value().low, *tc.auc.value);
  EXPECT_GT(tc.auc.interval.value().high, *tc.auc.value);
  EXPECT_GT(tc.censored.ratio.value(), 1.0);
  EXPECT_GT(tc.at_limit.ratio.value(), 1.0);
  EXPECT_GT(tc.stratified.ratio.value(), 1.0);
  const H1Row& noise = panel.rows[1];
  EXPECT_NEAR(noise.auc_gain.value.value(), *tc.auc.value - *noise.auc.value, 1e-15);
  EXPECT_NEAR(noise.c_gain.value.value(), *tc.c.value - *noise.c.value, 1e-15);
  // Two tests in the family: the smaller p doubles.
  EXPECT_NEAR(
      std::min(*noise.auc_holm, *noise.c_holm), 2.0 * std::min(*noise.auc_p, *noise.c_p), 1e-15);
  EXPECT_EQ(panel.rows[2].kind, H1RowKind::together);
  EXPECT_FALSE(panel.rows[2].censored.ratio.has_value());
  EXPECT_EQ(panel.rows[3].kind, H1RowKind::added);
  // By t with 11 degrees of freedom.
  EXPECT_LT(panel.rows[3].auc_p.value(), 0.01);
  EXPECT_GT(panel.rows[3].auc_gain.value.value(), 0.0);
  EXPECT_EQ(panel.folds.size(), 12U);
}

TEST(HypothesisH1, TheLandmarkPanelExcludesAndCounts) {
  H1Options options = options_for();
  options.always_landmark = true;
  const H1Table h1 = hypothesis_h1(table_of(trials_csv(12, 20)), options);
  ASSERT_EQ(h1.panels.size(), 2U);
  const H1Panel& paper = h1.panels[0];
  const H1Panel& landmark = h1.panels[1];
  EXPECT_GT(paper.ended_in_window.value(), 0U);
  EXPECT_GT(landmark.ended_by_landmark, 0U);
  EXPECT_GT(landmark.still_at_landmark, 0U);
  EXPECT_EQ(landmark.trials + landmark.ended_by_landmark + landmark.still_at_landmark, 240U);
  EXPECT_EQ(landmark.rows[0].name, "tc_landmark");
  EXPECT_EQ(landmark.rows[1].name, "noise");
}

TEST(HypothesisH1, AMissingPredictorLeavesItsTrialOutOfEveryRow) {
  std::string csv = trials_csv(12, 20);
  csv += "d0,A,1,33,NA,0.5,33,12,0,NA\nd0,B,NA,33,0.1,0.5,33,12,0,0.1\n";
  const H1Table h1 = hypothesis_h1(table_of(csv), options_for());
  EXPECT_EQ(h1.outcome_missing, 1U);
  EXPECT_EQ(h1.panels[0].trials, 241U);
  EXPECT_EQ(h1.panels[0].complete, 240U);
  EXPECT_EQ(h1.panels[0].rows[0].missing, 1U);
  EXPECT_EQ(h1.panels[0].rows[1].missing, 0U);
}

TEST(HypothesisH1, WithoutTimesThereIsNoC) {
  H1Options options = options_for();
  options.time = "no_such";
  const H1Table h1 = hypothesis_h1(table_of(trials_csv(6, 20)), options);
  EXPECT_FALSE(h1.panels[0].has_time);
  EXPECT_FALSE(h1.panels[0].rows[0].c.value.has_value());
  EXPECT_FALSE(h1.panels[0].rows[0].censored.ratio.has_value());
  EXPECT_TRUE(h1.panels[0].rows[0].auc.value.has_value());
}

TEST(HypothesisH1, NamesWhatCannotBeScored) {
  const std::string header = "day,algorithm,success,time_s,tc_early,noise\n";
  const H1Table one_class =
      hypothesis_h1(table_of(header + "a,A,1,3,1,2\nb,A,1,4,2,1\n"), options_for());
  EXPECT_TRUE(
      statistics::has(one_class.panels[0].conditions, statistics::ConditionKind::one_class));
  const H1Table one_day =
      hypothesis_h1(table_of(header + "a,A,1,3,1,2\na,A,0,4,2,1\n"), options_for());
  EXPECT_TRUE(
      statistics::has(one_day.panels[0].conditions, statistics::ConditionKind::one_cluster));
  const H1Table none = hypothesis_h1(table_of(header + "a,A,1,3,NA,2\n"), options_for());
  EXPECT_TRUE(statistics::has(none.panels[0].conditions, statistics::ConditionKind::no_rows));
  EXPECT_THROW(static_cast<void>(hypothesis_h1(table_of(header + "a,A,2,3,1,2\n"), options_for())),
               statistics::FormulaError);
  EXPECT_THROW(
      static_cast<void>(hypothesis_h1(table_of(header + "a,A,1,3,1,2\n"), options_for("nois"))),
      statistics::FormulaError);
}

TEST(HypothesisH1, ARowOfItsOwnIsACluster) {
  H1Options options = options_for();
  options.cluster = "";
  const H1Table h1 = hypothesis_h1(table_of(trials_csv(4, 20)), options);
  EXPECT_EQ(h1.panels[0].clusters, 80U);
  const H1CaseRow& plain = h1.panels[0].case_level[0];
  EXPECT_NEAR(plain.auc.std_error.value(), h1.panels[0].rows[0].auc.std_error.value(), 1e-14);
}

/// Columns day, algorithm, success, time_s, tc_early, noise; `change(row, cells)` edits a row.
std::string changed_csv(
    const std::function<void(int row, std::map<std::string, std::string>& cells)>& change) {
  const std::vector<std::string> header{
      "day", "algorithm", "success", "time_s", "tc_early", "noise"};
  table::RandomStream random(11, 1, 0);
  std::string csv = "day,algorithm,success,time_s,tc_early,noise\n";
  for (int row = 0; row < 120; ++row) {
    std::map<std::string, std::string> cells{{"day", "d" + std::to_string(row % 12)},
                                             {"algorithm", row % 2 == 0 ? "A" : "B"},
                                             {"success", random.below(3) == 0 ? "0" : "1"},
                                             {"time_s", std::to_string(20 + random.below(60))},
                                             {"tc_early", std::to_string(random.normal())},
                                             {"noise", std::to_string(random.normal())}};
    change(row, cells);
    for (const std::string& name : header) {
      csv += (name == "day" ? "" : ",") + cells[name];
    }
    csv += "\n";
  }
  return csv;
}

TEST(HypothesisH1, AFitThatFailsCostsItsOwnNumbers) {
  // The rival is the outcome itself: no fold has a logistic fit.
  const std::string separated =
      changed_csv([](int, auto& cells) { cells["noise"] = cells["success"]; });
  const H1Panel panel = hypothesis_h1(table_of(separated), options_for()).panels[0];
  EXPECT_TRUE(
      statistics::has(panel.rows[2].conditions, statistics::ConditionKind::fold_without_fit));
  EXPECT_FALSE(panel.rows[2].auc_within_folds.has_value());
  EXPECT_TRUE(panel.rows[0].auc_within_folds.has_value());
  EXPECT_EQ(panel.rows[1].auc_within_folds, 0.0);  // in its a-priori direction
  for (const H1Row& row : panel.rows) {
    EXPECT_FALSE(statistics::has_error(row.conditions));
  }
  // The rival is the time itself, or all but: no fold has a Cox fit.
  const std::string monotone =
      changed_csv([](int, auto& cells) { cells["noise"] = cells["time_s"]; });
  const H1Panel timed = hypothesis_h1(table_of(monotone), options_for()).panels[0];
  EXPECT_TRUE(
      statistics::has(timed.rows[2].conditions, statistics::ConditionKind::fold_without_fit));
  EXPECT_FALSE(timed.rows[2].c_within_folds.has_value());
  EXPECT_TRUE(timed.rows[0].c_within_folds.has_value());
  EXPECT_FALSE(timed.rows[1].censored.ratio.has_value());
}

TEST(HypothesisH1, AConstantPredictorCostsItsOwnRow) {
  const std::string csv = changed_csv([](int, auto& cells) { cells["noise"] = "0.1"; });
  const H1Panel panel = hypothesis_h1(table_of(csv), options_for()).panels[0];
  EXPECT_FALSE(panel.rows[1].censored.ratio.has_value());
  EXPECT_TRUE(
      statistics::has(panel.rows[1].conditions, statistics::ConditionKind::constant_column));
  EXPECT_FALSE(
      statistics::has(panel.rows[1].conditions, statistics::ConditionKind::infinite_value));
  EXPECT_FALSE(statistics::has_error(panel.rows[1].conditions));
  EXPECT_TRUE(panel.rows[0].censored.ratio.has_value());
}

TEST(HypothesisH1, AnInfiniteCellIsNamedWithItsRow) {
  for (const std::string column : {"tc_early", "time_s"}) {
    const std::string csv = changed_csv([&](int row, auto& cells) {
      if (row == 6) {
        cells[column] = "-Inf";
      }
    });
    try {
      static_cast<void>(hypothesis_h1(table_of(csv), options_for()));
      FAIL();
    } catch (const statistics::FormulaError& error) {
      EXPECT_EQ(
          std::string(error.what()),
          "column '" + column + "' of test.csv, row 7: found -Inf; make the cell NA or correct it");
    }
  }
}

TEST(HypothesisH1, AColumnWithoutValuesIsNotThere) {
  const std::string csv = changed_csv([](int, auto& cells) {
    cells["day"] = "";
    cells["algorithm"] = "NA";
  });
  const H1Panel panel = hypothesis_h1(table_of(csv), options_for()).panels[0];
  EXPECT_EQ(panel.complete, 120U);
  EXPECT_FALSE(panel.has_clusters);
  EXPECT_FALSE(panel.has_strata);
  EXPECT_EQ(panel.clusters, 120U);
  EXPECT_TRUE(panel.rows[0].censored.ratio.has_value());
  EXPECT_FALSE(panel.rows[0].stratified.ratio.has_value());
}

TEST(HypothesisH1, OnlyTheStratifiedRatioNeedsTheStrata) {
  const std::string csv = changed_csv([](int row, auto& cells) {
    if (row < 10) {
      cells["algorithm"] = "";
    }
  });
  const std::string all = changed_csv([](int, auto&) {});
  const H1Panel some = hypothesis_h1(table_of(csv), options_for()).panels[0];
  const H1Panel full = hypothesis_h1(table_of(all), options_for()).panels[0];
  EXPECT_EQ(some.complete, 120U);
  EXPECT_EQ(some.rows[0].censored.ratio, full.rows[0].censored.ratio);
  EXPECT_TRUE(some.rows[0].stratified.ratio.has_value());
  EXPECT_NE(some.rows[0].stratified.ratio, full.rows[0].stratified.ratio);
  EXPECT_TRUE(statistics::has(some.rows[0].conditions, statistics::ConditionKind::missing_rows));
}

TEST(HypothesisH1, ALandmarkPanelNeedsNoLandmarkColumns) {
  H1Options options = options_for();
  options.always_landmark = true;
  const std::string csv = changed_csv([](int, auto&) {});
  const H1Table h1 = hypothesis_h1(table_of(csv), options);
  ASSERT_EQ(h1.panels.size(), 2U);
  EXPECT_EQ(h1.panels[1].rows[0].name, "tc_early");
  EXPECT_TRUE(h1.panels[1].rows[0].c.value.has_value());
}

TEST(HypothesisH1, ATimeOfTheLandmarkButForRoundingHasEndedByIt) {
  H1Options options = options_for();
  options.always_landmark = true;
  options.models = false;
  const table::DataTable table = table_of(changed_csv([](int row, auto& cells) {
    if (row == 0) {
      cells["time_s"] = "15.0000002";
    }
  }));
  const H1Panel rounded = hypothesis_h1(table, options).panels[1];
  EXPECT_EQ(rounded.ended_by_landmark, 1U);
  EXPECT_EQ(rounded.trials, 119U);
  EXPECT_TRUE(rounded.has_time);
  EXPECT_TRUE(rounded.rows[0].censored.ratio);
  // Times as they are: the trial ends after the landmark.
  options.round_times = false;
  const H1Panel as_they_are = hypothesis_h1(table, options).panels[1];
  EXPECT_EQ(as_they_are.ended_by_landmark, 0U);
  EXPECT_EQ(as_they_are.trials, 120U);
  EXPECT_TRUE(as_they_are.rows[0].censored.ratio);
}

TEST(HypothesisH1, ALimitAtTheLandmarkButForRoundingIsRefused) {
  H1Options options = options_for();
  options.always_landmark = true;
  options.models = false;
  options.limit_s = 15.0000002;
  // Some end before, so that the other panel has its events.
  const table::DataTable table = table_of(changed_csv([](int row, auto& cells) {
    if (row < 40) {
      cells["time_s"] = std::to_string(5.0 + 0.2 * row);
    }
  }));
  EXPECT_THROW(static_cast<void>(hypothesis_h1(table, options)), statistics::FormulaError);
}

TEST(HypothesisH1, ATimeBeyondTheLimitByAHairIsCutOnlyWhereTimesAreLeftAsTheyAre) {
  H1Options options = options_for();
  options.models = false;
  options.limit_s = 100.0;
  const table::DataTable table = table_of(changed_csv([](int row, auto& cells) {
    if (row == 0) {
      cells["success"] = "1";
      cells["time_s"] = "100.0000002";
    }
  }));
  EXPECT_FALSE(statistics::has(hypothesis_h1(table, options).panels[0].conditions,
                               statistics::ConditionKind::beyond_limit));
  options.round_times = false;
  EXPECT_TRUE(statistics::has(hypothesis_h1(table, options).panels[0].conditions,
                              statistics::ConditionKind::beyond_limit));
}

TEST(HypothesisH1, ALandmarkWithoutTimesIsRefused) {
  H1Options options = options_for();
  options.always_landmark = true;
  std::string csv = changed_csv([](int, auto& cells) { cells["time_s"] = ""; });
  try {
    static_cast<void>(hypothesis_h1(table_of(csv), options));
    FAIL();
  } catch (const statistics::FormulaError& error) {
    EXPECT_NE(std::string(error.what()).find("--landmark: test.csv has no times"),
              std::string::npos)
        << error.what();
  }
  options.always_landmark = false;
  EXPECT_EQ(hypothesis_h1(table_of(csv), options).panels.size(), 1U);
}

TEST(HypothesisH1, SaysWhichColumnsAreNotOfTheWindow) {
  H1Options options = options_for();
  options.always_landmark = true;
  const H1Panel landmark = hypothesis_h1(table_of(trials_csv(12, 20)), options).panels[1];
  EXPECT_EQ(landmark.not_of_window, std::vector<std::string>{"noise"});
  EXPECT_TRUE(landmark.ends_known);
}

TEST(HypothesisH1, KeepsEveryIntervalAndReadsTheOneAskedFor) {
  H1Options options = options_for();
  options.models = false;
  const table::DataTable table = table_of(trials_csv(12, 20));
  for (const statistics::BootstrapMethod method : {statistics::BootstrapMethod::expanded,
                                                   statistics::BootstrapMethod::percentile,
                                                   statistics::BootstrapMethod::bca}) {
    options.interval = method;
    const H1Score auc = hypothesis_h1(table, options).panels[0].rows[0].auc;
    EXPECT_EQ(auc.interval.value().low, auc.intervals.of(method)->low);
    EXPECT_LT(auc.intervals.expanded->low, auc.intervals.percentile->low);
    EXPECT_GT(auc.intervals.expanded->high, auc.intervals.percentile->high);
    EXPECT_NE(auc.intervals.bca->low, auc.intervals.percentile->low);
  }
}

TEST(HypothesisH1, WithholdsInferenceFromFewClustersOrOutcomes) {
  const auto panel_of = [](const std::string& csv) {
    return hypothesis_h1(table_of(csv), options_for()).panels[0];
  };
  const auto expect_withheld = [](const H1Panel& panel, const std::string& reason) {
    EXPECT_EQ(panel.withheld, reason);
    ASSERT_TRUE(statistics::has(panel.conditions, statistics::ConditionKind::withheld));
    for (const H1Row& row : panel.rows) {
      EXPECT_TRUE(row.auc.value.has_value());
      EXPECT_TRUE(row.c.value.has_value());
      for (const H1Score* score : {&row.auc, &row.auc_gain, &row.c, &row.c_gain, &row.c_at_limit}) {
        EXPECT_FALSE(score->interval || score->intervals.bca || score->closed_form ||
                     score->std_error || score->p_value);
      }
      EXPECT_FALSE(row.auc_p || row.auc_lr_p || row.auc_holm || row.c_p || row.c_lr_p ||
                   row.c_holm);
      EXPECT_FALSE(row.censored.p_value || row.censored.interval || row.stratified.interval);
      EXPECT_FALSE(row.mixed.p_value || row.mixed.lr_p_value || row.mixed.per_sd.interval);
    }
    EXPECT_TRUE(panel.rows[0].censored.ratio.has_value());
    EXPECT_FALSE(panel.case_level[1].auc_gain_p || panel.case_level[0].auc.closed_form);
  };
  expect_withheld(panel_of(trials_csv(5, 40)), "5 clusters of 'day', fewer than 6");
  EXPECT_EQ(panel_of(trials_csv(6, 40)).withheld, "");
  EXPECT_TRUE(panel_of(trials_csv(6, 40)).rows[1].auc_p.has_value());
  int failures = 0;
  const std::string rare = changed_csv([&](int, auto& cells) {
    failures += cells["success"] == "0" ? 1 : 0;
    cells["success"] = cells["success"] == "0" && failures <= 9 ? "0" : "1";
  });
  expect_withheld(panel_of(rare), "9 failures, fewer than 10");
}

TEST(HypothesisH1, BadTimesAreNamedWithTheirRow) {
  const std::string csv = changed_csv([](int row, auto& cells) {
    if (row == 7 || row == 9) {
      cells["time_s"] = row == 7 ? "0" : "-4";
    }
  });
  const H1Panel panel = hypothesis_h1(table_of(csv), options_for()).panels[0];
  ASSERT_TRUE(statistics::has(panel.conditions, statistics::ConditionKind::time_not_positive));
  const auto bad = std::find_if(panel.conditions.begin(), panel.conditions.end(), [](auto& one) {
    return one.kind == statistics::ConditionKind::time_not_positive;
  });
  EXPECT_EQ(bad->detail, "found 0 in row 8 (and 1 more); no times are used");
  EXPECT_FALSE(panel.rows[0].c.value.has_value());
  EXPECT_TRUE(panel.rows[0].auc.value.has_value());
}

TEST(HypothesisH1, WhatWasAskedForMustBeThere) {
  H1Options options = options_for();
  options.strata = "algoritm";
  EXPECT_NO_THROW(
      static_cast<void>(hypothesis_h1(table_of(changed_csv([](int, auto&) {})), options)));
  options.required = {"algoritm"};
  try {
    static_cast<void>(hypothesis_h1(table_of(changed_csv([](int, auto&) {})), options));
    FAIL();
  } catch (const statistics::FormulaError& error) {
    EXPECT_STREQ(error.what(), "no column 'algoritm' in test.csv; did you mean 'algorithm'?");
  }
}

TEST(HypothesisH1, TimesAboveTheLimitAreCensoredThere) {
  H1Options options = options_for();
  options.limit_s = 60.0;
  const std::string far = changed_csv([](int row, auto& cells) {
    if (std::stoi(cells["time_s"]) > 60) {
      cells["time_s"] = row % 2 == 0 ? "13489" : "61";
    }
  });
  const std::string near = changed_csv([](int, auto& cells) {
    if (std::stoi(cells["time_s"]) > 60) {
      cells["time_s"] = "100";
    }
  });
  const H1Panel panel = hypothesis_h1(table_of(far), options).panels[0];
  const H1Panel other = hypothesis_h1(table_of(near), options).panels[0];
  EXPECT_TRUE(statistics::has(panel.conditions, statistics::ConditionKind::beyond_limit));
  EXPECT_EQ(panel.rows[0].c.value, other.rows[0].c.value);
  EXPECT_EQ(panel.rows[0].at_limit.ratio, other.rows[0].at_limit.ratio);
  for (const statistics::IncidenceCurves& curves : panel.incidence) {
    EXPECT_LE(curves.time.back(), 60.0);
  }
}

}  // namespace
}  // namespace tcert::study
