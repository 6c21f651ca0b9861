#pragma once
/// \file
/// When clusters or outcomes are so few that no interval and no test keeps its level, none is
/// given: estimates stand alone.

#include <cstddef>
#include <string>

#include <statistics/basics/few_clusters.hpp>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// With fewer outcomes of a class neither the bootstrap nor a normal test keeps its level.
inline constexpr std::size_t kTooFewOutcomes = 10;

/// Below so many clusters inference is withheld where none was tried with fewer: of rates of
/// advance (H3), pairs of arms, and early warnings.
inline constexpr std::size_t kTooFewUntried = 10;

/// "7 clusters of 'day', fewer than 10", "4 failures, fewer than 10"; empty if there are enough.
/// `cluster` is empty where every trial is its own.
[[nodiscard]] std::string too_few(const std::string& cluster,
                                  std::size_t clusters,
                                  std::size_t successes,
                                  std::size_t failures,
                                  std::size_t least_clusters = statistics::kTooFewClusters);

/// The condition that says so. \pre `reason` is not empty.
[[nodiscard]] statistics::Condition withheld(const std::string& reason);

/// Erases what resamples say of an interval that is withheld.
void erase_resampling_conditions(statistics::Conditions& conditions);

/// Leaves the estimate.
void withhold(H1Score& score);
void withhold(H1HazardRatio& ratio);

/// Leaves the estimates of a panel if it has too few clusters or outcomes, and says so.
void withhold_if_few(const H1Options& options, H1Panel& panel);

}  // namespace tcert::study
