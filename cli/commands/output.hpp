#pragma once
/// \file
/// Data on stdout, words on stderr, result folders.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>

namespace tcert::cli {

/// Writes to stdout and flushes; to a terminal printable_lines(). \throws BrokenPipe if nobody
/// reads it any more, WriteError.
void print(std::string_view text);

/// While one lives print() writes nothing: a command is run for what it leaves in a folder.
class SilentPrint {
 public:
  SilentPrint() noexcept;
  ~SilentPrint();
  SilentPrint(const SilentPrint&) = delete;
  SilentPrint& operator=(const SilentPrint&) = delete;
};

/// A line on stderr, or several with line feeds between: printable_lines().
void say(std::string_view lines);

/// One line each on stderr.
void say(std::span<const table::Diagnostic> diagnostics);

/// \throws UsageError if `output` is or holds `input`; WriteError, see require_output_place().
void require_apart(const std::filesystem::path& input, const std::filesystem::path& output);

}  // namespace tcert::cli
