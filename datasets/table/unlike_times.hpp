#pragma once
/// \file
/// Times of two kinds in one column: stamps since 1970 among durations, milliseconds among seconds.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace tcert::table {

/// Times that are far from the others.
struct UnlikeTimes {
  std::size_t first = 0;  ///< Index of the first of them.
  double time = 0.0;      ///< The farthest of them.
  double median = 0.0;    ///< Of all times.
  std::size_t count = 0;
};

/// Times above 1,000 times the median; if there are none and the median is that of stamps (1e8 and
/// more: three years of seconds), those below a thousandth of it. Empty if there are none, or the
/// median is not above 0. O(n).
[[nodiscard]] std::optional<UnlikeTimes> unlike_times(std::span<const double> times);

/// Whether all of two and more times are stamps (1e8 and more: three years of seconds), of which no
/// one tells how long a trial took.
[[nodiscard]] bool are_stamps(std::span<const double> times) noexcept;

/// "1.36e+08 times the median of 13".
[[nodiscard]] std::string distance_in_words(const UnlikeTimes& unlike);

}  // namespace tcert::table
