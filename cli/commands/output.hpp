#pragma once
/// \file
/// Data on stdout, words on stderr.

#include <string_view>

namespace tcert::cli {

/// Writes to stdout and flushes; to a terminal printable_lines(). \throws BrokenPipe if nobody
/// reads it any more, WriteError.
void print(std::string_view text);

/// A line on stderr, or several with line feeds between: printable_lines().
void say(std::string_view lines);

}  // namespace tcert::cli
