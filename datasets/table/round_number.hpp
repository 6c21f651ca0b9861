#pragma once
/// \file
/// Round numbers for steps and widths.

namespace tcert::table {

/// The least of 1, 2 and 5 times a power of ten that is not below `least`, but for rounding.
/// \pre `least` is finite and above 0.
[[nodiscard]] double round_number_from(double least);

}  // namespace tcert::table
