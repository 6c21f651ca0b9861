#pragma once
/// \file
/// What is wrong with an input file, where, and what was expected instead.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace tcert::table {

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
  std::string expectation;  ///< Completes "expected ...", and the way out where there is one.
  std::size_t count = 1;
};

/// "file:line: error: column 'x_m': found 'abc', expected a number (and 3 more)". No newline; a
/// part that the diagnostic leaves empty is left out.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

[[nodiscard]] bool has_error(std::span<const Diagnostic> diagnostics) noexcept;

/// printable(), of at most 40 bytes of the text, cut between characters and then ended by "...".
[[nodiscard]] std::string shortened(std::string_view text);

/// Collects problems; those of the same severity, file, column and expectation become one, with a
/// count. O(log kinds) each.
class DiagnosticGroups {
 public:
  void add(Diagnostic diagnostic);

  /// In the order of first occurrence; leaves the collection empty.
  [[nodiscard]] std::vector<Diagnostic> take();

  [[nodiscard]] bool has_error() const noexcept { return table::has_error(groups_); }

 private:
  using Kind = std::tuple<Severity, std::string, std::string, std::string>;
  std::vector<Diagnostic> groups_;
  std::map<Kind, std::size_t> index_;
};

}  // namespace tcert::table
