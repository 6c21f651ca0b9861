#pragma once
/// \file
/// H3: gating the speed by the margin recovers rate of advance without losing successes (paper 3.5,
/// 4.4), on a table of replays: one row a trial, speed law and beta.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/resampling/bootstrap.hpp>
#include <string>
#include <string_view>
#include <table/data_table.hpp>
#include <vector>

#include "analysis/study/watch.hpp"

namespace tcert::study {

/// How the beta of a law is chosen, of those that were replayed.
struct H3Beta {
  std::optional<double> per_m = 10.0;  ///< Beforehand; the middle one of a law that lacks it,
                                       ///< unless it was asked for. Empty: by folds of clusters.
  bool asked = false;
  std::size_t folds = 5;
};

struct H3Options {
  std::string gated = "M3";       ///< Algorithm that is gated.
  std::string baseline = "CB-V";  ///< Algorithm whose lead is to be recovered.
  std::string cluster = "day";    ///< Column of the unit of resampling; empty: trials.
  double level = 0.95;            ///< Of intervals and of the one-sided bound; in (0, 1).
  double loss_margin = 0.05;      ///< Loss of successes that would still do; in (0, 1).
  double true_loss = 0.01;        ///< Share lost at which the power is stated; below the margin.
  H3Beta beta;
  statistics::BootstrapMethod interval =
      statistics::BootstrapMethod::expanded;  ///< The one to be read; all are kept.
  std::size_t replicates = 2000;
  std::uint64_t seed = 1;
};

/// Columns of the table that are used.
[[nodiscard]] std::vector<std::string> columns_of(const H3Options& options);

struct H3Estimate {
  std::optional<double> value;
  std::optional<statistics::Interval> interval;  ///< Clusters of both algorithms resampled jointly.
  statistics::BootstrapIntervals intervals;      ///< By every method that is kept.
};

/// One speed law and beta under one lighting. Rates are total length over total time of the trials
/// that succeed ungated, in m/min; a stall counts in them at the retreat speed.
struct H3Case {
  std::string law;
  double beta_per_m = 0.0;
  H3Estimate gated;                     ///< Rate of advance.
  H3Estimate gain;                      ///< gated - ungated.
  H3Estimate gain_share;                ///< gated / ungated - 1.
  H3Estimate recovered;                 ///< gain / gap; NA unless the gap's interval excludes 0.
  std::optional<double> speed_cmd_mps;  ///< Median of the trials' gated medians.
  std::size_t kept = 0;                 ///< Successes that the replay keeps.
  std::size_t lost = 0;
  std::optional<double> lost_share;  ///< lost / trials.
  /// Clopper-Pearson, one-sided, of so many fewer trials as they are alike within clusters
  /// (`cluster_loss`).
  std::optional<double> lost_lower;
  std::optional<double> lost_upper;
  double design_effect = 1.0;
  std::optional<bool> non_inferior;                       ///< lost_upper < loss_margin.
  std::optional<double> retained;                         ///< kept / successes.
  std::optional<statistics::Interval> retained_interval;  ///< Wilson, likewise.
  std::size_t stalls = 0;                                 ///< Of all trials.
  std::size_t stalled_trials = 0;
  bool on_front = false;  ///< Of {gain_share, retained}, among the cases of the group.
};

/// One law at its chosen beta, under one lighting or all of them.
struct H3Chosen {
  std::string law;
  std::string lighting;
  std::vector<std::pair<double, std::size_t>> betas;  ///< Each with its folds, of one fold if
                                                      ///< chosen beforehand.
  H3Estimate gain;
  H3Estimate recovered;
  std::size_t lost = 0;
  std::size_t trials = 0;
  std::optional<double> lost_lower, lost_upper;  ///< As of H3Case.
  std::optional<double> gain_p;  ///< One-sided, of no gain: jackknife of whole clusters, t.
  std::optional<double> loss_p;  ///< One-sided, of a loss of the margin or more.
  std::optional<double> p;       ///< The larger: that not both hold.
  std::optional<double>
      holm;  ///< Of all laws and lightings; of all lightings together, of the laws.
  std::optional<bool> holds;               ///< holm is at most 1 - level.
  std::optional<double> trials_for_power;  ///< Of 80 %, that the loss is found below the margin.
};

/// One lighting, or all of them together.
struct H3Group {
  std::string lighting;
  std::size_t trials = 0;  ///< Of the gated algorithm, with a known outcome.
  std::size_t successes = 0;
  std::size_t baseline_trials = 0;
  std::size_t baseline_successes = 0;
  std::size_t clusters = 0;  ///< Among the successes of both.
  H3Estimate ungated;
  H3Estimate baseline;  ///< As it ran.
  /// The baseline's rate if its metres had been driven under the lightings of the gated
  /// algorithm's: sum_l L_l / sum_l (L_l / r_l), L_l the ungated successes' length under lighting l
  /// and r_l the baseline's rate there. NA if it has no success under one of them.
  H3Estimate baseline_standardised;
  H3Estimate gap;         ///< baseline_standardised - ungated.
  H3Estimate gap_as_run;  ///< baseline - ungated: holds what the mixes of lightings differ in.
  std::optional<double> speed_cmd_mps;
  std::optional<double> baseline_speed_cmd_mps;
  std::optional<double> latency_ms;  ///< Median of the gated algorithm's medians, as logged.
  std::vector<H3Case> cases;
  std::string withheld;  ///< Why intervals, bounds and verdicts are; empty if they are not.
  statistics::Conditions conditions;
};

struct H3Table {
  H3Options options;
  std::vector<H3Group> groups;   ///< All lightings together first, then each, by name.
  std::vector<H3Chosen> chosen;  ///< By law, then as the groups.
  std::size_t unknown = 0;       ///< Trials of the two algorithms without an outcome, left out.
  statistics::Conditions conditions;  ///< Of the table as a whole; an error leaves no groups.
};

/// With fewer than kTooFewUntried clusters among the successes no interval, bound or verdict is
/// given; with fewer than kTooFewOutcomes successes of an algorithm none of its rates. \throws
/// std::invalid_argument if a column is not there or an option is out of range. `watch` hears of
/// the resamples of each group.
[[nodiscard]] H3Table hypothesis_h3(const table::DataTable& replays,
                                    const H3Options& options,
                                    const Watch& watch = {});

}  // namespace tcert::study
