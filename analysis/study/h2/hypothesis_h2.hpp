#pragma once
/// \file
/// H2: the early certificate margin predicts as well in every lighting (or other group), on any
/// table that H1 takes. Absence of a difference is tested, not read off a test of difference.

#include <cstddef>
#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/equivalence/equivalence.hpp>
#include <statistics/equivalence/range_permutation.hpp>
#include <string>
#include <table/data_table.hpp>
#include <utility>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

struct H2Options {
  H1Options trials;  ///< Which trials and columns; the first predictor is under test, `group` holds
                     ///< the groups ("lighting" unless named).
  double margin = 0.05;  ///< Of AUC and of C.
  std::size_t permutations = 2000;
};

/// One group.
struct H2Level {
  std::string name;
  std::size_t trials = 0;
  std::size_t successes = 0;  ///< Also the events of C and Cox.
  std::size_t clusters = 0;
  H1Score auc;  ///< Closed form: clustered DeLong within the group.
  H1Score c;    ///< Closed form: clustered jackknife within the group.
  /// Over pairs of trials of one stratum alone (H1Options::within). Closed form: clustered
  /// jackknife.
  H1Score auc_within;
  H1Score c_within;
  /// Per standard deviation of the whole panel towards the better side, cluster-robust.
  H1HazardRatio odds;        ///< Of success; logistic.
  H1HazardRatio censored;    ///< Of egress; failures leave the risk set when they fail.
  H1HazardRatio at_limit;    ///< Failures stay at risk to the trial limit.
  H1HazardRatio stratified;  ///< As `censored`, with a baseline for each level of the strata.
  std::string withheld;      ///< Why p-values and intervals are; empty if they are not.
  statistics::Conditions conditions;
};

/// AUC or C of all groups.
struct H2Equality {
  statistics::GroupEstimates groups;  ///< With their joint covariance.
  statistics::Equivalence tests;
  statistics::RangeUnderEquality range;
};

/// Does the effect of the predictor differ between groups? Cluster-robust Wald of group x
/// predictor.
struct H2Interaction {
  std::string model;
  std::optional<statistics::ChiSquareTest> test;
  statistics::Conditions conditions;
};

struct H2Panel {
  H1Panel trials;  ///< Who is in it, as H1 counts; its rows are empty.
  std::string predictor;
  statistics::HigherMeans higher = statistics::HigherMeans::success;
  std::size_t missing = 0;   ///< Trials of the panel without the predictor.
  std::optional<double> sd;  ///< Of the predictor in the whole panel.
  std::vector<H2Level> levels;
  std::optional<H2Equality> auc;  ///< Empty if a group has no AUC or no variance.
  std::optional<H2Equality> c;
  std::vector<H2Interaction> interactions;  ///< Logistic; Cox; Cox stratified.
  /// Likelihood ratio of the interaction in a mixed model with a random intercept by cluster.
  std::optional<H2Interaction> mixed_interaction;
  statistics::Conditions conditions;  ///< Beside those of `trials`.
};

struct H2Table {
  std::size_t trials = 0;           ///< Rows of the table.
  std::size_t outcome_missing = 0;  ///< Of those, left out everywhere.
  H2Options options;
  std::vector<H2Panel> panels;  ///< Paper, and landmark where the table has its column.
};

/// Panels are made as H1's, of trials whose group is known. Every resample draws whole clusters for
/// all groups jointly, so their intervals share draws. Where a group has too few clusters or
/// outcomes (`too_few`) its p-values and intervals are withheld, with the tests of its pairs and of
/// all groups; in a panel that has, all are. \throws FormulaError if a column is not
/// there or holds the wrong kind; std::invalid_argument if an option is out of range.
/// O((replicates + permutations groups) trials log trials). `watch` hears of the resamples and the
/// permutations of each panel.
[[nodiscard]] H2Table hypothesis_h2(const table::DataTable& table,
                                    const H2Options& options,
                                    const Watch& watch = {});

/// Names of the columns that it looks for.
[[nodiscard]] std::vector<std::string> columns_of(const H2Options& options);

}  // namespace tcert::study
