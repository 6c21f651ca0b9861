#pragma once
/// \file
/// AUC and C of one predictor in each group of rows, by itself. What clusters that groups share
/// make of their differences is jackknife_by_group's.

#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/concordance/concordance.hpp>
#include <statistics/roc/roc.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

struct GroupScore {
  std::optional<double> value;
  std::optional<double> standard_error;
  std::optional<Interval> interval;  ///< Wald, clipped to [0, 1].
  Conditions conditions;             ///< Without few_clusters.
};

/// The AUC of each level, its variance Obuchowski's (1997). \throws std::invalid_argument as
/// `joint_auc`, or if a code is missing.
[[nodiscard]] std::vector<GroupScore> auc_by_group(const Score& score,
                                                   std::span<const std::uint8_t> success,
                                                   const table::Factor& group,
                                                   std::span<const std::uint32_t> cluster,
                                                   double level = 0.95);

/// Harrell's C of each level: only trials of the same group are compared. \throws
/// std::invalid_argument as `concordance`.
[[nodiscard]] std::vector<GroupScore> concordance_by_group(const SurvivalOutcome& outcome,
                                                           const Predictor& predictor,
                                                           const table::Factor& group,
                                                           const table::Factor& cluster,
                                                           double level = 0.95);

/// Rows of each level.
[[nodiscard]] std::vector<std::vector<std::size_t>> rows_of_levels(const table::Factor& factor);

}  // namespace tcert::statistics
