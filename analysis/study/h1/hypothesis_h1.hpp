#pragma once
/// \file
/// H1: the early certificate margin predicts success and time better than contact heuristics do, on
/// any table with an outcome, a time and predictors.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/calibration/calibration.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <statistics/roc/placements.hpp>
#include <statistics/roc/roc_curve.hpp>
#include <statistics/survival/cumulative_incidence.hpp>
#include <string>
#include <string_view>
#include <table/data_table.hpp>
#include <utility>
#include <vector>

#include "analysis/study/watch.hpp"

namespace tcert::study {

/// A column with its a-priori direction. `landmark_column` is the same feature of the time window
/// alone; empty if there is none.
struct H1Predictor {
  std::string column;
  statistics::HigherMeans higher = statistics::HigherMeans::success;
  std::string landmark_column;
};

/// The certificate's feature first, then contacts, dwell, bend variance.
[[nodiscard]] std::vector<H1Predictor> paper_predictors();

struct H1Options {
  std::vector<H1Predictor> predictors = paper_predictors();  ///< The one under test, then rivals.
  std::string success = "success";
  std::string time = "time_s";  ///< Column of the time to egress or to the end; may be absent.
  std::string cluster = "day";  ///< Empty, or not in the table: every trial is its own cluster.
  std::string strata = "algorithm";  ///< Of the stratified Cox model; may be absent.
  /// Columns that are crossed to strata, for AUC and C of pairs within a stratum; those that the
  /// table does not have are left out.
  std::vector<std::string> within = {"algorithm", "lighting"};
  std::string group;              ///< Column of the groups that H2 compares; empty for none.
  double landmark_s = 15.0;       ///< When the time window closes.
  bool always_landmark = false;   ///< A landmark panel without landmark columns too.
  std::optional<double> limit_s;  ///< Trial limit, where longer ones are censored; empty: the
                                  ///< longest time of the panel.
  bool round_times = true;        ///< Times that differ by rounding are one.
  double level = 0.95;
  statistics::BootstrapMethod interval =
      statistics::BootstrapMethod::expanded;  ///< The one to be read; all are kept.
  std::size_t replicates = 2000;
  std::size_t folds = 5;
  bool models = true;  ///< The rows of models, what is out of fold, mixed models, and curves.
  std::uint64_t seed = 1;
  std::vector<std::string> required;  ///< Columns that may not be absent, though they could be.
};

/// The early window may contain the outcome, so the test is made twice.
enum class H1PanelKind : std::uint8_t {
  paper,     ///< Features as configured, all trials.
  landmark,  ///< Features of the time window; only trials that are still running when it closes,
             ///< and times start there.
};

[[nodiscard]] std::string_view to_string(H1PanelKind kind) noexcept;
constexpr H1PanelKind row_last(H1PanelKind /*any*/) noexcept { return H1PanelKind::landmark; }

/// What a watch is told of the resampling of a panel.
[[nodiscard]] std::string resamples_of(H1PanelKind kind);

/// A hazard ratio of egress per standard deviation towards the better side, cluster-robust.
struct H1HazardRatio {
  std::optional<double> ratio;
  std::optional<statistics::Interval> interval;
  std::optional<double> p_value;
};

struct H1OddsRatio {
  std::optional<double> ratio;
  std::optional<statistics::Interval> interval;  ///< Wald, on the log scale.
};

/// Logistic mixed model of success with a random intercept by cluster (paper 3.2), fitted by
/// adaptive quadrature; empty where clusters are single trials.
struct H1MixedModel {
  H1OddsRatio per_sd;                ///< Per standard deviation towards the better side.
  H1OddsRatio per_cm;                ///< Of a predictor in metres.
  std::optional<double> p_value;     ///< Wald, of the predictor.
  std::optional<double> lr_p_value;  ///< Row `added`: likelihood ratio against the rivals alone.
  std::optional<double> sd_cluster;  ///< Of the random intercept, in log odds.
  std::optional<double> icc;
  std::optional<double> r2_marginal;
  std::optional<double> r2_conditional;
  std::optional<double> log_likelihood;
};

/// Linear mixed model of log time of the successes with a random intercept by cluster, REML; empty
/// where clusters are single trials.
struct H1LogTime {
  std::optional<double> r2_marginal;     ///< Nakagawa's: of the row's predictors alone.
  std::optional<double> r2_conditional;  ///< With the clusters.
  std::optional<double> r2_gain;         ///< Of the marginal one, as gains of AUC are.
  std::optional<statistics::Interval> r2_gain_interval;  ///< Jackknife of clusters, t.
  std::optional<double> r2_gain_p;
  std::optional<double> ratio;  ///< Of times, per standard deviation towards the better side.
  std::optional<statistics::Interval> interval;  ///< Satterthwaite's t, on the log scale.
  std::optional<double> p_value;
  std::optional<double> sd_cluster;  ///< Of log times.
};

enum class H1RowKind : std::uint8_t {
  predictor,  ///< The one under test.
  rival,
  together,  ///< A model of all rivals.
  added,     ///< The same with the predictor under test.
};

/// One number by the panel's clusters: its bootstrap intervals, and the closed form beside them.
struct H1Score {
  std::optional<double> value;
  std::optional<statistics::Interval> interval;     ///< By H1Options::interval.
  statistics::BootstrapIntervals intervals;         ///< All of them, of the same resamples.
  std::optional<statistics::Interval> closed_form;  ///< Clustered DeLong; clustered jackknife of C.
  std::optional<double> std_error;                  ///< Of the closed form.
  std::optional<double> p_value;  ///< Of 0, by the jackknife of whole clusters and t.
};

/// AUC and C over pairs of trials of one stratum alone, and the gain over a rival. What differs
/// between strata (an algorithm, a lighting) cannot help them.
struct H1WithinScores {
  H1Score auc;  ///< Closed form: clustered jackknife, as of C.
  H1Score auc_gain;
  H1Score auc_gain_between;  ///< The pooled gain less that within: what strata add to it.
  std::optional<double> auc_gain_p;
  H1Score c;
  H1Score c_gain;
  H1Score c_gain_between;
  std::optional<double> c_gain_p;
};

/// The strata of a panel.
struct H1Strata {
  std::vector<std::string> columns;  ///< Crossed; empty if there are none.
  std::size_t levels = 0;            ///< Combinations that a complete trial has.
  std::size_t missing = 0;           ///< Complete trials without one: in no pair.
  std::size_t auc_pairs = 0;         ///< Of a success and a failure, in one stratum.
  std::size_t c_pairs = 0;           ///< That C compares, in one stratum.
  std::size_t all_auc_pairs = 0;     ///< The same whatever their strata.
  std::size_t all_c_pairs = 0;
};

/// One row of the table. A gain is that of the predictor under test over a rival or over the rivals
/// together; in the row `added`, of the larger model over the smaller.
struct H1Row {
  std::string name;
  H1RowKind kind = H1RowKind::rival;
  statistics::HigherMeans higher = statistics::HigherMeans::success;
  std::size_t missing = 0;  ///< Trials of the panel without this predictor.

  H1Score auc;
  H1Score auc_gain;
  std::optional<double> auc_p;     ///< Of the gain over a rival; for `added` see `nested_test`.
  std::optional<double> auc_lr_p;  ///< Row `added`: likelihood ratio, trials independent.
  std::optional<double> auc_holm;  ///< Of the family of gains over the rivals.
  std::optional<double> auc_within_folds;

  H1Score c;
  H1Score c_gain;
  std::optional<double> c_p;
  std::optional<double> c_lr_p;
  std::optional<double> c_holm;
  std::optional<double> c_within_folds;
  H1Score c_at_limit;  ///< Failures at risk to the limit; interval by the jackknife of clusters and
                       ///< t. Of predictors alone.

  H1WithinScores within;  ///< Empty for rows of models, and where there are no strata.

  std::optional<double> sd;  ///< One standard deviation of the predictor.
  H1HazardRatio censored;    ///< Failures leave the risk set when they fail.
  H1HazardRatio at_limit;    ///< Failures stay at risk to the trial limit.
  H1HazardRatio stratified;  ///< As `censored`, with a baseline for each level of the strata.
  H1MixedModel mixed;
  H1LogTime log_time;
  statistics::Conditions conditions;

  /// A predictor by itself, not a model.
  [[nodiscard]] bool is_single() const noexcept {
    return kind == H1RowKind::predictor || kind == H1RowKind::rival;
  }
};

/// A single predictor by single trials, as if they were independent: a sensitivity, not the result.
struct H1CaseRow {
  std::string name;
  H1Score auc;  ///< Plain DeLong as the closed form; no bootstrap.
  std::optional<double> auc_gain_p;
  H1Score c;
  std::optional<double> c_gain_p;
};

/// Where the predictor under test lies, for one outcome.
struct TcDistribution {
  bool success = false;
  std::size_t trials = 0;
  std::size_t missing = 0;
  std::size_t negative = 0;  ///< Below 0, of those that are not missing.
  std::optional<double> p10, p50, p90;
};

struct H1Roc {
  std::string name;  ///< Of its row.
  statistics::RocCurve curve;
};

struct H1Calibration {
  std::string name;                          ///< Of the model: a predictor alone, or a row.
  statistics::ModelCalibration calibration;  ///< Out of fold.
};

/// AUC and C of a row without one cluster, and its gains; NaN where there is none.
struct H1LeftOut {
  std::string cluster;
  std::string row;
  double auc = 0.0;
  double auc_gain = 0.0;
  double c = 0.0;
  double c_gain = 0.0;
};

struct H1Panel {
  H1PanelKind kind = H1PanelKind::paper;
  std::size_t trials = 0;     ///< With a known outcome, after the exclusions below.
  std::size_t complete = 0;   ///< Of those, with everything known: the rows' n.
  std::size_t successes = 0;  ///< Of the complete ones: also the events of C and Cox.
  std::size_t failures = 0;
  std::size_t clusters = 0;
  bool has_time = false;
  bool has_clusters = false;  ///< Else every trial is its own.
  bool has_strata = false;
  H1Strata within;                                           ///< What `H1Row::within` is within.
  double limit_s = 0.0;                                      ///< The trial limit that was used.
  std::vector<std::pair<std::string, std::size_t>> missing;  ///< Per column that is no predictor.

  // Landmark panel: what was excluded, in this order.
  std::size_t ended_by_landmark = 0;
  std::size_t still_at_landmark = 0;
  bool ends_known = false;                 ///< Else no one could be excluded for having ended.
  std::vector<std::string> not_of_window;  ///< Predictors as they are in the other panel.

  // Paper panel: trials that are over before their window is; empty if the table does not say.
  std::optional<std::size_t> ended_in_window;
  std::optional<std::size_t> failures_ended_in_window;

  /// Why p-values and intervals are withheld; empty if they are not.
  std::string withheld;

  std::vector<H1Row> rows;  ///< The predictor, its rivals, together, added.
  std::vector<H1CaseRow> case_level;
  std::vector<H1LeftOut> left_out;  ///< By cluster, then by row; empty where trials are clusters.
  std::vector<TcDistribution> distribution;            ///< Successes, failures.
  std::vector<statistics::IncidenceCurves> incidence;  ///< By quartile of the predictor under test.
  std::vector<H1Roc> roc;                              ///< One a row that has scores.
  std::vector<H1Calibration> calibration;
  std::vector<std::pair<std::string, std::size_t>> folds;  ///< Cluster and its fold, from 1.
  statistics::Conditions conditions;
};

/// How often a certificate was issued, for one outcome.
struct IssuedCount {
  bool success = false;
  std::size_t trials = 0;
  std::size_t issued = 0;
};

struct H1Table {
  std::size_t trials = 0;           ///< Rows of the table.
  std::size_t outcome_missing = 0;  ///< Of those, left out everywhere.
  H1Options options;
  std::vector<IssuedCount> issued;  ///< Successes, failures; empty if the table does not say.
  std::vector<H1Panel> panels;      ///< Paper, and landmark where the table has its columns.
};

/// The trials of `table` by its columns. A trial ends at its time, or with its log (`end_s`) where
/// that is not given. Every resample draws whole clusters, for all numbers of a panel jointly;
/// model rows are re-fitted in each (logistic for AUC, Cox for C) and in each fold; a fold whose
/// fit has no estimate is left out and named. A column without a single value is not there. With
/// too few clusters or outcomes p-values and intervals are withheld (`withhold`). \throws
/// FormulaError if a column is not there, holds the wrong kind or is infinite, or if a landmark is
/// asked for and no time is known; std::invalid_argument if an option is out of range. O(replicates
/// trials log trials). `watch` hears of the resamples of each panel.
[[nodiscard]] H1Table hypothesis_h1(const table::DataTable& table,
                                    const H1Options& options = {},
                                    const Watch& watch = {});

/// Names of the columns that it looks for.
[[nodiscard]] std::vector<std::string> columns_of(const H1Options& options);

}  // namespace tcert::study
