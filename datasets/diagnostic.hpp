#pragma once
/// \file
/// What is wrong with an input file, where, and what was expected instead.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tcert {

enum class Severity {
  note,     ///< Worth knowing; the data are used as they are.
  warning,  ///< The data are used; the condition is stated.
  error,    ///< The file (and so the trial) is rejected.
};

/// One problem, or `count` problems of the same kind in the same column of the same file.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  std::size_t line = 0;     ///< 1-based, of the first occurrence; 0 if it concerns the whole file.
  std::string column;       ///< Name, or empty.
  std::string value;        ///< As found, shortened; or empty.
  std::string expectation;  ///< What was expected, and the way out where there is one.
  std::size_t count = 1;
};

/// "file:line: error: column 'x_m': found 'abc', expected a number (and 3 more)". No newline.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

[[nodiscard]] bool has_error(std::span<const Diagnostic> diagnostics) noexcept;

}  // namespace tcert
