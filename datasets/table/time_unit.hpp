#pragma once
/// \file
/// Times of foreign logs and their unit.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tcert::table {

enum class TimeUnit : std::uint8_t { seconds, milliseconds, microseconds, nanoseconds };

/// "s", "ms", "us", "ns".
[[nodiscard]] std::string_view name_of(TimeUnit unit) noexcept;

/// Of a word: "s", "sec", "seconds", "ms", "us", "nanosec", ...; in any case.
[[nodiscard]] std::optional<TimeUnit> time_unit_of_word(std::string_view word) noexcept;

[[nodiscard]] double seconds_in(TimeUnit unit) noexcept;

/// What a clock's unit may be, and how that is known.
struct TimeUnitGuess {
  TimeUnit unit = TimeUnit::seconds;
  /// Empty if nothing speaks for another unit than the name's, or than seconds.
  std::string reason;
};

/// `named`, the unit that the column's name has, if the times are possible in it; else by the size
/// of the times (since 1970) or, of whole numbers, by their median step: steps of more than a
/// second are no log of a robot. O(n).
[[nodiscard]] TimeUnitGuess guess_time_unit(std::optional<TimeUnit> named,
                                            std::span<const double> times);

/// Reads a number of any unit exactly as nanoseconds. False if it is none, or beyond 4e9 s.
[[nodiscard]] bool read_time(std::string_view cell,
                             TimeUnit unit,
                             char decimal_point,
                             std::int64_t& time_ns);

}  // namespace tcert::table
