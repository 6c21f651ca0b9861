#pragma once
/// \file
/// Cells that hold a date and a time of day.

#include <cstdint>
#include <string_view>

namespace tcert::table {

/// Reads "2021-01-20T10:11:32.332Z", also with a space for the T, without Z, with an offset such as
/// +01:00, and "01/20/2021 10:11:32" (the month first, unless it is above 12), as nanoseconds since
/// 1970; without an offset as UTC. False if it is no such date. Years 1970 to 2096.
[[nodiscard]] bool read_date(std::string_view cell, std::int64_t& time_ns);

}  // namespace tcert::table
