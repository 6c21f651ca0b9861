#pragma once
/// \file
/// How often trials succeed by their place in the order of TC_early.

#include <cstddef>
#include <statistics/basics/interval.hpp>
#include <vector>

#include "analysis/study/early/early_trials.hpp"

namespace tcert::study {

/// Trials between two quantiles of TC_early.
struct QuantileGroup {
  double low_m = 0.0;  ///< Least and largest value in it.
  double high_m = 0.0;
  std::size_t trials = 0;
  std::size_t successes = 0;
  double share = 0.0;
  statistics::Interval interval;  ///< Wilson's at 95 %, as if trials were independent.
};

/// 10 where each of them has 20 trials or more, else 5.
[[nodiscard]] std::size_t quantile_groups(std::size_t trials) noexcept;

/// Groups from the smallest TC_early, cut at its quantiles of type 7; equal values stay in one
/// group, so that there may be fewer than `groups`. \throws std::invalid_argument without groups.
[[nodiscard]] std::vector<QuantileGroup> success_by_quantile(const EarlyTrials& trials,
                                                             std::size_t groups);

}  // namespace tcert::study
