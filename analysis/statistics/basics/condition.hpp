#pragma once
/// \file
/// What is wrong or noteworthy about a fit or an estimate, by name, with the column it is in.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::statistics {

enum class ConditionKind : std::uint8_t {
  // The rows.
  no_rows,              ///< No complete row is left.
  too_few_rows,         ///< Fewer rows than the estimate needs.
  missing_rows,         ///< Rows left out because a used column is missing.
  infinite_value,       ///< An infinite cell where a finite one is needed.
  bad_probability,      ///< A probability that is not within [0, 1].
  certain_probability,  ///< A probability of exactly 0 or 1, which has no logit.
  not_binary,           ///< An outcome or status that is neither 0 nor 1.
  bad_counts,           ///< cbind(): negative, fractional, or more successes than trials.
  time_not_positive,    ///< A survival time that is not above 0.
  start_not_before_stop,
  text_outcome,  ///< An outcome of two texts, coded 0 and 1 by byte order.
  bad_weight,    ///< Negative, or fractional where a count is needed.
  // The outcome and the groups.
  one_class,   ///< All rows have the same outcome.
  rare_class,  ///< A class of a single row: an estimate, but no variance.
  no_events,
  one_group,          ///< A grouping column with a single level.
  singleton_groups,   ///< As many levels as rows: what varies between them is not told from noise.
  no_random_effects,  ///< A mixed model without (1 | group).
  few_clusters,       ///< See `few_clusters()`: cluster-robust numbers are too sure of themselves.
  one_cluster,        ///< A single cluster: no variance.
  // The columns of the model.
  constant_column,
  collinear_column,
  complete_separation,
  quasi_separation,
  near_separation,       ///< A finite estimate that has run away: it says nothing.
  penalised_separation,  ///< Separation under a penalty, which alone keeps the estimate finite.
  monotone_likelihood,   ///< Cox: a coefficient runs to infinity.
  infinite_hazard,       ///< Cox: the baseline hazard runs to infinity with a coefficient.
  // The estimate.
  not_converged,
  no_profile,           ///< Profile intervals left out for what they cost.
  singular_fit,         ///< Mixed model: a variance between groups is 0, or a correlation is 1.
  infinite_variance,    ///< Mixed model: a variance between groups runs to infinity.
  all_tied,             ///< The predictor is constant: 0.5, which says nothing.
  separated,            ///< AUC or C is 0 or 1: its variance 0 is misleading.
  same_ranking,         ///< Paired: both predictors rank every pair alike.
  no_weighted_test,     ///< Log-rank: there is none with case weights.
  no_such_event,        ///< Competing risks: a named cause that no event has.
  zero_variance,        ///< A difference that is not 0, without variance: no test.
  no_comparable_pairs,  ///< C: no pair of rows can be compared.
  not_proportional,     ///< Cox: the test of proportional hazards rejects.
  below_diagonal,       ///< A partial AUC less than chance: no corrected one.
  // The bootstrap and cross-validation.
  failed_replicates,      ///< Replicates without a value, left out.
  constant_replicates,    ///< All replicates are equal: no interval.
  endpoint_out_of_range,  ///< An endpoint's rank is below 1 or above the number of replicates.
  infinite_bias,          ///< All replicates lie on one side of the estimate: no BCa.
  no_acceleration,        ///< The jackknife has no spread or lacks a value: no BCa.
  no_jackknife,           ///< A fit without one cluster has no estimate: no test by clusters.
  withheld,               ///< Too few clusters or outcomes for p-values and intervals.
  one_class_fold,
  fold_without_fit,  ///< A fold whose training rows have no finite estimate.
  no_prediction,     ///< No fold has one.
  // Equivalence and calibration.
  few_bins,             ///< Ties leave fewer bins of probabilities than were asked for.
  singular_covariance,  ///< Too few clusters for a joint test of so many groups.
  // Times and trial limits.
  beyond_limit,          ///< Times above the limit: censored there.
  limit_from_data,       ///< No limit was given, and the longest time is far above the others.
  near_times,            ///< R's timefix would make distinct times equal that are kept apart here.
  merged_times,          ///< Distinct times made equal: they differ by rounding.
  unlike_times,          ///< A time far from the others: a stamp among durations.
  stamped_times,         ///< All times are stamps: not one is a duration.
  singular_information,  ///< Cox: what a test adds cannot be told from what is there.
  no_robust_variance,  ///< Robust: clusters too few for a joint test, or a column without variance.
};

/// How far the numbers stand.
enum class ConditionSeverity : std::uint8_t {
  note,     ///< The estimate stands; the condition is stated.
  warning,  ///< Some number is missing (NA) because of it, or is not to be trusted.
  error,    ///< There is no estimate.
};

/// One condition. `column` is the column of the data or of the model that it is in; empty if it is
/// in none.
struct Condition {
  ConditionKind kind = ConditionKind::no_rows;
  ConditionSeverity severity = ConditionSeverity::error;
  std::string column;
  std::string detail;    ///< What was found: "rows 5 and 9", "every row with f = c has y = 1".
  std::string advice{};  ///< What to do here; empty: what `advice(kind)` says.

  friend bool operator==(const Condition&, const Condition&) = default;
};

using Conditions = std::vector<Condition>;

/// A condition that leaves no estimate.
[[nodiscard]] Condition error_of(ConditionKind kind,
                                 std::string column = {},
                                 std::string detail = {},
                                 std::string advice = {});

/// The kind's name in data files: the enumerator as it is written above.
[[nodiscard]] std::string_view name_of(ConditionKind kind) noexcept;

/// The kind in words and what to do about it, each without a full stop; advice may be empty.
[[nodiscard]] std::string_view words(ConditionKind kind) noexcept;
[[nodiscard]] std::string_view advice(ConditionKind kind) noexcept;

/// Its own advice, or that of its kind.
[[nodiscard]] std::string_view advice(const Condition& condition) noexcept;

/// "note", "warning", "error".
[[nodiscard]] std::string_view to_string(ConditionSeverity severity) noexcept;

/// One line: "error: column 'status': neither 0 nor 1: found 2 in row 1; write status == 2 ...".
[[nodiscard]] std::string to_string(const Condition& condition);

/// True if the condition `kind` is among them.
[[nodiscard]] bool has(std::span<const Condition> conditions, ConditionKind kind) noexcept;

/// True if one of them leaves no estimate.
[[nodiscard]] bool has_error(std::span<const Condition> conditions) noexcept;

}  // namespace tcert::statistics
