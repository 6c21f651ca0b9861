#pragma once
/// \file
/// Text of CSV cells: numbers that read back to the same bits, times to the same nanosecond.

#include <cstdint>
#include <string>
#include <string_view>

namespace tcert::table {

/// Shortest decimal that reads back as `value`; nothing for NaN, which is an empty cell.
void append_number(std::string& out, double value);
[[nodiscard]] std::string number_text(double value);

/// A comma, and the number.
void append_cell(std::string& out, double value);

/// Seconds as an exact decimal without trailing zeros: 1'500'000'000 is "1.5".
void append_seconds(std::string& out, std::int64_t time_ns);

/// `text` as one cell, quoted if it holds a comma, a quote, a line end or outer spaces.
void append_text(std::string& out, std::string_view text);

/// `text` between quotes, whatever it holds; quotes within are doubled.
void append_quoted(std::string& out, std::string_view text);

}  // namespace tcert::table
