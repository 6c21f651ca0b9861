#pragma once
/// \file
/// The prospective H3: arms that drove the same worlds, compared in pairs. What a replay cannot
/// see, the failures that speed causes, is counted here.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <string>
#include <vector>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "datasets/bundle.hpp"

namespace tcert::study {

struct PairedOptions {
  std::string base = "M3";     ///< The arm that the others are compared with.
  std::string lead = "CB-V";   ///< Whose lead in speed is to be recovered.
  std::string pair = "world";  ///< Column of what two trials of a pair have in common.
  double level = 0.95;
  double loss_margin = 0.05;  ///< Stated beforehand.
  double power = 0.8;         ///< For the number of pairs that would be needed.
  std::size_t replicates = 2000;
  std::uint64_t seed = 1;
};

/// Sums of one arm over its trials.
struct ArmTotals {
  std::size_t successes = 0;
  std::size_t collisions = 0;
  std::size_t wedged = 0;
  std::size_t timeouts = 0;
  std::optional<double> peak_force_n;  ///< Median over trials.
  std::optional<double> time_above_s;  ///< Mean over trials, above the watched force.
  std::optional<double> stalls;        ///< Mean over trials.
};

/// One arm beside the base.
struct ArmComparison {
  std::string arm;
  std::size_t pairs = 0;
  std::size_t clusters = 0;  ///< Days of the pairs.
  ArmTotals base;
  ArmTotals own;
  std::size_t lost = 0;     ///< Worlds in which only the base arrives.
  std::size_t won = 0;      ///< In which only this arm does.
  double difference = 0.0;  ///< (won - lost) / pairs.
  std::optional<statistics::Interval> difference_interval;  ///< By days.
  /// One-sided bounds of what is lost on the whole. The upper one is the larger of the clustered
  /// one and of Clopper and Pearson's of the lost worlds alone: where few pairs differ days say too
  /// little, and a loss more never lowers it. The lower one is the lesser of the clustered one and
  /// of the exact ones, lost less won.
  std::optional<double> loss_upper;
  std::optional<double> loss_lower;
  std::optional<bool> non_inferior;         ///< loss_upper < loss_margin.
  std::optional<double> mcnemar_p;          ///< Exact; takes pairs as independent.
  std::optional<std::size_t> pairs_needed;  ///< For the power, if nothing is lost.
  std::size_t both = 0;                     ///< Pairs in which both arrive: those of the rates.
  H3Estimate base_rate;                     ///< Metres over minutes of those pairs, m/min.
  H3Estimate gain;                          ///< Rate of this arm less the base's.
  H3Estimate recovered;  ///< gain / (lead - base), where that gap's interval excludes 0.
};

struct PairedArms {
  PairedOptions options;
  ArmTotals base;  ///< Of all trials of the base.
  std::size_t base_trials = 0;
  std::size_t unknown = 0;          ///< Trials without an outcome, left out.
  std::vector<ArmComparison> arms;  ///< In the order of the trials.
  H3Estimate gap;        ///< Rate of the lead less the base's, of pairs where both arrive.
  std::string withheld;  ///< Why there are no intervals; empty if there are.
  statistics::Conditions conditions;
};

/// `trials` of one driven bundle; a trial is known by its algorithm and the pair's column.
/// \throws std::invalid_argument if that column is not there, the base has no trial, or an arm has
/// two of one pair.
[[nodiscard]] PairedArms compare_arms(const std::vector<TrialRow>& trials,
                                      const std::vector<std::string>& extra_columns,
                                      const PairedOptions& options);

}  // namespace tcert::study
