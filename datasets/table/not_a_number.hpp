#pragma once
/// \file
/// What a computation gives where there is no number.

#include <limits>

namespace tcert::table {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace tcert::table
