#pragma once
/// \file
/// Text from files, fit for a terminal.

#include <string>
#include <string_view>

namespace tcert::table {

/// `text` fit to print on one line of a terminal, whatever it holds: control characters (those of
/// Unicode that turn the line round too) and bytes that are not UTF-8 as \n, \r, \t or \xNN.
[[nodiscard]] std::string printable(std::string_view text);

/// printable(), line by line: line feeds and tabs stay.
[[nodiscard]] std::string printable_lines(std::string_view text);

}  // namespace tcert::table
