#pragma once
/// \file
/// Paired differences of bootstrapped values.

#include <cstddef>
#include <statistics/resampling/bootstrap.hpp>
#include <vector>

namespace tcert::statistics {

/// The sum of the values `added` less those `taken`, resample by resample, as a result of its own.
/// \throws std::invalid_argument if there is no such value.
[[nodiscard]] BootstrapResult paired_difference(const BootstrapResult& result,
                                                const ResamplingPlan& plan,
                                                const std::vector<std::size_t>& added,
                                                const std::vector<std::size_t>& taken);

}  // namespace tcert::statistics
