#pragma once
/// \file
/// Restricted mean times of groups at a stated limit, and their differences.

#include <cstddef>
#include <statistics/basics/student_t.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

struct RestrictedMeanRow {
  std::string first;   ///< A group.
  std::string second;  ///< Of a difference, what is taken from it; empty for a mean.
  double value = 0.0;
  ClusterT spread;
};

/// The mean of each group, then the difference of every pair: areas under Kaplan-Meier curves up to
/// `limit`. Without clusters variances are Greenwood's, groups independent, and intervals normal
/// (Uno et al. 2014); with them the jackknife of whole clusters and t. `groups` may be null.
/// \throws std::invalid_argument as `survival_curves`.
[[nodiscard]] std::vector<RestrictedMeanRow> restricted_means(const SurvivalOutcome& outcome,
                                                              const table::Factor* groups,
                                                              const table::Factor* cluster,
                                                              double limit,
                                                              double level);

}  // namespace tcert::statistics
