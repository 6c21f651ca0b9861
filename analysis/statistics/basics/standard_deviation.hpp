#pragma once
/// \file
/// The sample standard deviation.

#include <span>

namespace tcert::statistics {

/// With n - 1 in the denominator; exactly 0 for equal values, whatever their mean rounds to, and
/// for fewer than two.
[[nodiscard]] double standard_deviation(std::span<const double> values);

}  // namespace tcert::statistics
