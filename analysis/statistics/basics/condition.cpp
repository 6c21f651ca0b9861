#include <statistics/basics/condition.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace tcert::statistics {
namespace {

struct Entry {
  ConditionKind kind;
  std::string_view name;
  std::string_view words;
  std::string_view advice;
};

constexpr auto kEntries = std::to_array<Entry>({
    {ConditionKind::no_rows,
     "no_rows",
     "no complete row",
     "check the file and its columns for missing values"},
    {ConditionKind::too_few_rows,
     "too_few_rows",
     "too few rows",
     "collect more or use fewer terms"},
    {ConditionKind::missing_rows, "missing_rows", "rows with a missing value are left out", ""},
    {ConditionKind::infinite_value,
     "infinite_value",
     "an infinite value",
     "make the cell NA or correct it"},
    {ConditionKind::bad_probability,
     "bad_probability",
     "a probability that is not between 0 and 1",
     "give probabilities, not scores"},
    {ConditionKind::certain_probability,
     "certain_probability",
     "probabilities of exactly 0 or 1 have no logit",
     "there is no slope and no intercept; the Brier score and the bins stand"},
    {ConditionKind::not_binary,
     "not_binary",
     "neither 0 nor 1",
     "write 'column == value' for the value that counts as 1"},
    {ConditionKind::bad_counts,
     "bad_counts",
     "no counts of successes and failures",
     "counts are whole numbers, at least 0; in cbind(k, n - k) k is at most n"},
    {ConditionKind::time_not_positive,
     "time_not_positive",
     "a time that is not above 0",
     "correct the cell or leave the row out"},
    {ConditionKind::start_not_before_stop,
     "start_not_before_stop",
     "a start that is not before its stop",
     "correct the cells or leave the row out"},
    {ConditionKind::beyond_limit,
     "beyond_limit",
     "times above the trial limit are censored there",
     ""},
    {ConditionKind::limit_from_data,
     "limit_from_data",
     "no trial limit was given, and the longest time is taken for it",
     "give --limit"},
    {ConditionKind::near_times,
     "near_times",
     "distinct times that R's timefix would make equal are kept apart",
     "subtract the first time, and both agree"},
    {ConditionKind::merged_times,
     "merged_times",
     "times that differ by rounding were made equal",
     "--no-time-rounding keeps them apart"},
    {ConditionKind::unlike_times,
     "unlike_times",
     "a time far from the others",
     "correct the cell or make it NA, if a stamp stands among durations"},
    {ConditionKind::stamped_times,
     "stamped_times",
     "times are stamps, not durations",
     "subtract from each the start of its own trial"},
    {ConditionKind::singular_information,
     "singular_information",
     "what changes over time cannot be told from what does not",
     "more events are needed; or try another --transform"},
    {ConditionKind::no_robust_variance,
     "no_robust_variance",
     "the clusters leave no robust variance",
     "use more clusters or fewer columns"},
    {ConditionKind::text_outcome,
     "text_outcome",
     "texts are coded as 0 and 1",
     "write 'column == \"text\"' for the one that counts as 1, or --success 'column=text'"},
    {ConditionKind::bad_weight,
     "bad_weight",
     "a weight that cannot be used",
     "weights are above 0"},
    {ConditionKind::one_class,
     "one_class",
     "all outcomes are the same",
     "nothing can be told apart; use rows with both outcomes"},
    {ConditionKind::rare_class,
     "rare_class",
     "a class of a single row",
     "there is an estimate but no variance"},
    {ConditionKind::no_events, "no_events", "no event", "check the status column"},
    {ConditionKind::one_group, "one_group", "a single group", "nothing can be compared"},
    {ConditionKind::singleton_groups,
     "singleton_groups",
     "every group is a single row",
     "its variance is hardly determined; group by something that rows share"},
    {ConditionKind::no_random_effects,
     "no_random_effects",
     "no random effect",
     "write + (1 | group), or fit glm"},
    {ConditionKind::few_clusters,
     "few_clusters",
     "few clusters",
     "cluster-robust intervals tend to be too narrow"},
    {ConditionKind::one_cluster,
     "one_cluster",
     "a single cluster",
     "there is no variance between clusters; choose another --cluster"},
    {ConditionKind::constant_column,
     "constant_column",
     "a constant column",
     "leave the term out; its coefficient is NA"},
    {ConditionKind::collinear_column,
     "collinear_column",
     "a column that the ones before it determine",
     "leave the term out; its coefficient is NA"},
    {ConditionKind::complete_separation,
     "complete_separation",
     "complete separation",
     "no finite estimate; merge levels or leave the term out"},
    {ConditionKind::quasi_separation,
     "quasi_separation",
     "quasi-complete separation",
     "no finite estimate; merge levels or leave the term out"},
    {ConditionKind::near_separation,
     "near_separation",
     "near-separation: the estimate has run away",
     "it says nothing; merge levels, leave the term out or look at the few rows that overlap"},
    {ConditionKind::penalised_separation,
     "penalised_separation",
     "separation: the penalty alone keeps the estimate finite",
     "read the profile interval, not the Wald one"},
    {ConditionKind::monotone_likelihood,
     "monotone_likelihood",
     "the likelihood rises without end",
     "no finite estimate; merge levels or leave the term out"},
    {ConditionKind::infinite_hazard,
     "infinite_hazard",
     "the cumulative baseline hazard runs to infinity",
     "it is NA; --curves has rows of the data"},
    {ConditionKind::not_converged,
     "not_converged",
     "the fit did not converge",
     "rescale the columns or simplify the model; the numbers are not estimates"},
    {ConditionKind::no_profile,
     "no_profile",
     "profile intervals are left out, for they take long",
     "ask for them with --profile"},
    {ConditionKind::singular_fit,
     "singular_fit",
     "the fit is singular: the estimate lies on the boundary",
     "the data show no such variance; the term can be left out"},
    {ConditionKind::infinite_variance,
     "infinite_variance",
     "the variance between groups has no finite estimate",
     "groups with both outcomes are needed; fit glm with --cluster instead"},
    {ConditionKind::all_tied, "all_tied", "all values tied", "the predictor says nothing"},
    {ConditionKind::separated,
     "separated",
     "perfectly separated",
     "a variance of 0 is no certainty, and resamples show none either; more rows are needed"},
    {ConditionKind::same_ranking, "same_ranking", "both predictors rank alike", ""},
    {ConditionKind::no_weighted_test,
     "no_weighted_test",
     "no log-rank test with case weights",
     "leave out --weights, or fit cox"},
    {ConditionKind::no_such_event,
     "no_such_event",
     "a cause that only censored rows have",
     "it has no incidence; the status is 1 for every cause"},
    {ConditionKind::zero_variance, "zero_variance", "a difference without variance", "no test"},
    {ConditionKind::no_comparable_pairs,
     "no_comparable_pairs",
     "no pair of rows can be compared",
     "C needs events at different times"},
    {ConditionKind::not_proportional,
     "not_proportional",
     "hazards are not proportional",
     "stratify, or report the effect over time"},
    {ConditionKind::below_diagonal,
     "below_diagonal",
     "the curve lies below the diagonal",
     "check the predictor's direction; the corrected area is NA"},
    {ConditionKind::failed_replicates,
     "failed_replicates",
     "replicates without a value are left out",
     "the interval is conditional on the others"},
    {ConditionKind::constant_replicates,
     "constant_replicates",
     "all replicates are equal",
     "there is no interval"},
    {ConditionKind::endpoint_out_of_range,
     "endpoint_out_of_range",
     "an interval limit is the extreme replicate",
     "use more replicates"},
    {ConditionKind::infinite_bias,
     "infinite_bias",
     "all replicates lie on one side of the estimate",
     "there is no BCa interval; use more replicates, or read the percentile one with care"},
    {ConditionKind::no_acceleration,
     "no_acceleration",
     "the jackknife gives no acceleration",
     "there is no BCa interval; read the percentile one with care"},
    {ConditionKind::no_jackknife,
     "no_jackknife",
     "no fit where one cluster is left out",
     "there is no test by clusters; use fewer terms or more trials"},
    {ConditionKind::withheld,
     "withheld",
     "p-values and intervals are withheld",
     "with so few none that is here keeps its level; the estimates stand"},
    {ConditionKind::one_class_fold, "one_class_fold", "a fold with one class", "it is left out"},
    {ConditionKind::fold_without_fit,
     "fold_without_fit",
     "no fit without this fold's rows",
     "they are left out; use fewer terms, or more folds, which leave more rows to each fit"},
    {ConditionKind::no_prediction,
     "no_prediction",
     "no row has a prediction",
     "no fold has a fit, for the reasons that are named; use fewer terms, or more folds"},
    {ConditionKind::few_bins, "few_bins", "ties leave fewer bins", ""},
    {ConditionKind::singular_covariance,
     "singular_covariance",
     "the covariance of the groups is singular",
     "there is no joint test; use more clusters or fewer groups"},
});

const Entry& entry_of(ConditionKind kind) noexcept {
  const auto* const found = std::find_if(
      kEntries.begin(), kEntries.end(), [&](const Entry& e) { return e.kind == kind; });
  return found == kEntries.end() ? kEntries[0] : *found;
}

}  // namespace

Condition error_of(ConditionKind kind, std::string column, std::string detail, std::string advice) {
  return {kind, ConditionSeverity::error, std::move(column), std::move(detail), std::move(advice)};
}

std::string_view name_of(ConditionKind kind) noexcept { return entry_of(kind).name; }
std::string_view words(ConditionKind kind) noexcept { return entry_of(kind).words; }
std::string_view advice(ConditionKind kind) noexcept { return entry_of(kind).advice; }

std::string_view advice(const Condition& condition) noexcept {
  return condition.advice.empty() ? advice(condition.kind) : std::string_view(condition.advice);
}

std::string_view to_string(ConditionSeverity severity) noexcept {
  switch (severity) {
    case ConditionSeverity::note:
      return "note";
    case ConditionSeverity::warning:
      return "warning";
    case ConditionSeverity::error:
      return "error";
  }
  return "";
}

std::string to_string(const Condition& condition) {
  std::string line(to_string(condition.severity));
  line += ": ";
  if (!condition.column.empty()) {
    line += "column '" + condition.column + "': ";
  }
  line += words(condition.kind);
  if (!condition.detail.empty()) {
    line += ": " + condition.detail;
  }
  if (!advice(condition).empty()) {
    line += "; ";
    line += advice(condition);
  }
  return line;
}

bool has(std::span<const Condition> conditions, ConditionKind kind) noexcept {
  return std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    return condition.kind == kind;
  });
}

bool has_error(std::span<const Condition> conditions) noexcept {
  return std::any_of(conditions.begin(), conditions.end(), [](const Condition& condition) {
    return condition.severity == ConditionSeverity::error;
  });
}

}  // namespace tcert::statistics
