#pragma once
/// \file
/// Paired differences of bootstrapped values.

#include <cstddef>
#include <statistics/resampling/bootstrap.hpp>

namespace tcert::statistics {

/// Value `first` minus value `second`, resample by resample, as a result of its own.
/// \throws std::invalid_argument if there is no such value.
[[nodiscard]] BootstrapResult paired_difference(const BootstrapResult& result,
                                                const ResamplingPlan& plan,
                                                std::size_t first,
                                                std::size_t second);

}  // namespace tcert::statistics
