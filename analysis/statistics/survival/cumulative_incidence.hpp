#pragma once
/// \file
/// Cumulative incidence of competing end points, by group: the Aalen-Johansen estimate. Checked
/// against `survival::survfit` with a factor as the event.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/basics/condition.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// Times to the first of several end points. A row is at risk on (start, stop].
struct CompetingOutcome {
  std::vector<double> start;         ///< Empty: at risk from the beginning.
  std::vector<double> stop;          ///< Finite.
  std::vector<std::uint32_t> cause;  ///< 0 if censored, else 1 + index into `causes`.
  std::vector<std::string> causes;   ///< For instance "egress", "failure".
};

struct IncidenceOptions {
  std::span<const double> weights;         ///< Case weights >= 0, finite; empty for 1 each.
  const table::Factor* groups = nullptr;   ///< An estimate each; null for a single one.
  const table::Factor* cluster = nullptr;  ///< Rows of a cluster are dependent; null: rows are not.
};

/// A probability at each time of an IncidenceCurves.
struct IncidenceCurve {
  std::string cause;                ///< "(event-free)" for the probability of none so far.
  std::vector<double> events;       ///< Weight of the events at the time.
  std::vector<double> probability;  ///< Of the event by the time, the others competing.
  std::vector<double> std_error;    ///< Infinitesimal jackknife, of the probability itself.
};

/// Probabilities of a group; those of all causes and of none sum to 1.
struct IncidenceCurves {
  std::string group;  ///< Level of the group; empty if there are none.
  std::size_t rows = 0;
  std::vector<double> time;            ///< Distinct stops, ascending.
  std::vector<double> at_risk;         ///< Weight at risk just before the time.
  std::vector<double> censored;        ///< Weight of the rows censored at the time.
  std::vector<IncidenceCurve> causes;  ///< In the order of the outcome's causes.
  IncidenceCurve event_free;
  Conditions conditions;

  /// The time of the data that `t` is but for rounding (`step_time`), else `t`.
  [[nodiscard]] double time_near(double t) const noexcept;

  /// Index of the last time that is not later than `t`, or time.size() before the first, where
  /// every incidence is 0. The same time but for rounding is not later.
  [[nodiscard]] std::size_t index_at(double t) const noexcept;
};

/// `outcome` has rounded times. Intervals: `survival_interval(probability, std_error /
/// probability)`; numbers at risk at given times: `numbers_at_risk`. Standard errors are NaN in a
/// group of one cluster. Conditions: no_rows (an error), no_events, one_cluster (warnings),
/// few_clusters (a note). O(n log n) for any number of clusters. \throws std::invalid_argument if
/// lengths differ, a factor has missing codes, or a weight, time or cause is out of range.
[[nodiscard]] std::vector<IncidenceCurves> cumulative_incidence(
    CompetingOutcome outcome, const IncidenceOptions& options = {});

}  // namespace tcert::statistics
