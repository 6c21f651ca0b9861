#pragma once
/// \file
/// Where TC_early lies in the successes and in the failures.

#include <cstddef>
#include <vector>

#include "analysis/study/early/early_trials.hpp"

namespace tcert::study {

/// Trials of both outcomes with a TC_early from `low_m` to below `high_m`.
struct HistogramBin {
  double low_m = 0.0;
  double high_m = 0.0;
  std::size_t successes = 0;
  std::size_t failures = 0;
};

/// Bins of one width, 1, 2 or 5 times a power of ten of a metre, that begin at a multiple of it and
/// cover every value; at most about 30. Empty without trials.
[[nodiscard]] std::vector<HistogramBin> early_histogram(const EarlyTrials& trials);

}  // namespace tcert::study
