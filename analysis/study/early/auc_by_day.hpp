#pragma once
/// \file
/// How well TC_early tells outcomes apart within each day, and over all days.

#include <cstddef>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/roc/roc.hpp>
#include <string>
#include <vector>

#include "analysis/study/early/early_trials.hpp"

namespace tcert::study {

/// Days with fewer trials of an outcome have an AUC that says next to nothing.
inline constexpr std::size_t kFewOutcomes = 3;

struct DayAuc {
  std::string day;
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::optional<double> auc;                     ///< Empty with one outcome alone.
  std::optional<statistics::Interval> interval;  ///< score_auc_interval().

  [[nodiscard]] bool is_few() const noexcept {
    return successes < kFewOutcomes || failures < kFewOutcomes;
  }
};

struct AucByDay {
  std::vector<DayAuc> days;  ///< In the order of their names.
  /// Of all pairs of trials. Its interval is made of whole days, and withheld of too_few() of them.
  statistics::AucEstimate pooled;
  /// Of pairs of trials of one day alone: the mean of the days' AUCs, each with the weight of its
  /// pairs; normal interval from the spread over days, withheld likewise.
  std::optional<double> within;
  std::optional<statistics::Interval> within_interval;
};

/// \pre trials.has_days.
[[nodiscard]] AucByDay auc_by_day(const EarlyTrials& trials);

/// Newcombe's (2006) interval of an AUC from independent trials, method 5: the AUCs that the
/// observed one is not further from than z standard errors, these by Hanley and McNeil's formula
/// with the sample sizes exchanged for their mean. Unlike Wald's it has a width where the classes
/// are separated. \throws std::invalid_argument without a success or a failure, or unless 0 <= auc
/// <= 1.
[[nodiscard]] statistics::Interval score_auc_interval(double auc,
                                                      std::size_t successes,
                                                      std::size_t failures,
                                                      double level = 0.95);

}  // namespace tcert::study
