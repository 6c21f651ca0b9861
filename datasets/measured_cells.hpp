#pragma once
/// \file
/// Cells of a table of measurements, with what is wrong with them said. Internal to its readers.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>

namespace tcert {

/// Whether a table was made by a program, by the column synthetic_seed, and its first seed.
struct SyntheticTable {
  bool synthetic = false;
  std::optional<std::uint64_t> seed;
};

[[nodiscard]] SyntheticTable synthetic_table(const table::TextTable& rows);

/// Keeps references.
class MeasuredCells {
 public:
  MeasuredCells(const table::TextTable& rows,
                const std::string& file,
                table::DiagnosticGroups& problems)
      : rows_(rows), file_(file), problems_(problems) {}

  /// Empty if it is missing, or not a finite number, which is an error.
  [[nodiscard]] std::optional<double> number(std::size_t row, std::size_t column);

  /// A problem of the cell of that row and column; line 0 is the whole file.
  void report(table::Severity severity,
              std::size_t line,
              std::string column,
              std::string value,
              std::string expectation);

 private:
  const table::TextTable& rows_;
  const std::string& file_;
  table::DiagnosticGroups& problems_;
};

}  // namespace tcert
