#pragma once
/// \file
/// Which column of a foreign log is its clock, by the names.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <table/time_unit.hpp>
#include <vector>

namespace tcert::table {

struct ClockColumn {
  std::size_t column = 0;
  std::optional<std::size_t> nanoseconds;  ///< Of whole seconds: the column of the rest.
  std::optional<TimeUnit> named_unit;      ///< That the name has: "Time (s)", "TimeUS".
};

/// Whether a column of this name is a clock: time, stamp, timestamp, t, also with a unit ("Time
/// (s)", time_ns, TimeUS) and as the tools of robots write it (%time, __time, header.stamp,
/// rosbagTimestamp, field.header.stamp, millis).
[[nodiscard]] bool is_clock_name(std::string_view name);

/// The first column that is called as a clock, seconds with nanoseconds in a column beside them as
/// one; empty if there is none.
[[nodiscard]] std::optional<ClockColumn> find_clock(const std::vector<std::string>& names);

/// The clock that `name` asks for, with the same rule for its unit and nanoseconds; empty if there
/// is no such column.
[[nodiscard]] std::optional<ClockColumn> clock_named(const std::vector<std::string>& names,
                                                     std::string_view name);

}  // namespace tcert::table
