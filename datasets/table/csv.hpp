#pragma once
/// \file
/// CSV files: columns of numbers for logs, tables of text for everything else.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <table/csv_header.hpp>
#include <table/csv_row.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

struct NumberColumn {
  std::string name;
  bool required = true;          ///< The file must have the column.
  bool may_be_empty = false;     ///< A missing cell (empty, NA, nan) is NaN, not an error.
  bool is_flag = false;          ///< A truth value (True, F, ...) is 1 or 0, not an error.
  bool may_be_infinite = false;  ///< And missing.
  /// An instant of the clock of the time column, or missing: its value is by how many nanoseconds
  /// it is after the row's time, exact up to 2^53 of them. A row that states nothing else is empty.
  bool is_time = false;
};

struct NumberOptions {
  std::string time_column = "time_s";  ///< Required; read as exact nanoseconds. Empty: none.
  std::vector<NumberColumn> columns;
  bool repair = false;           ///< Drop a bad row, counted, instead of reporting an error.
  bool skip_empty_rows = false;  ///< A row in which every wanted cell is missing is none.
};

/// Rows of numbers in file order; `values` is row-major, rows x wanted columns, NaN where missing.
struct NumberTable {
  std::size_t columns = 0;
  std::vector<std::int64_t> time_ns;  ///< Empty without a time column.
  std::vector<double> values;
  std::vector<std::uint32_t> lines;   ///< 1-based line of each row.
  std::vector<std::uint8_t> present;  ///< Per wanted column: the file has it.
  std::size_t empty_rows = 0;         ///< Rows that were skipped as empty.

  [[nodiscard]] std::size_t rows() const noexcept { return lines.size(); }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const noexcept {
    return values[row * columns + column];
  }
};

/// The columns that a file must have.
[[nodiscard]] std::vector<std::string> required_names(const NumberOptions& options);

/// The plan of a row of `header` that fills the wanted columns in their order.
[[nodiscard]] RowPlan plan_row(const CsvHeader& header, const NumberOptions& options);

/// Reads the wanted columns; others are skipped. Empty iff the file is rejected; every problem is
/// added to `problems`. A last line that is cut short (bad, and without a line end) is a warning
/// and is not used. O(size), one pass.
[[nodiscard]] std::optional<NumberTable> read_numbers(const Bytes& bytes,
                                                      const CsvOptions& csv,
                                                      const NumberOptions& options,
                                                      DiagnosticGroups& problems);

/// Cells of a CSV file as text, row-major, rows x columns of the header.
struct TextTable {
  CsvDialect dialect;
  std::vector<std::string> columns;
  std::vector<std::string> cells;
  std::vector<std::size_t> lines;  ///< 1-based line of each row.

  [[nodiscard]] std::size_t rows() const noexcept { return lines.size(); }
  [[nodiscard]] const std::string& at(std::size_t row, std::size_t column) const noexcept {
    return cells[row * columns.size() + column];
  }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;
};

/// Reads all columns of a file that must have the `required` ones. Empty iff the header cannot be
/// used. A row with another number of cells than the header is an error and is left out.
[[nodiscard]] std::optional<TextTable> read_text_table(const Bytes& bytes,
                                                       const CsvOptions& csv,
                                                       const std::vector<std::string>& required,
                                                       DiagnosticGroups& problems);

/// The rows below a header that was found before.
[[nodiscard]] TextTable read_text_rows(const Bytes& bytes,
                                       const CsvHeader& header,
                                       const CsvOptions& csv,
                                       DiagnosticGroups& problems);

struct TextTableResult {
  std::optional<TextTable> table;
  std::vector<Diagnostic> diagnostics;
};

/// The same from a file, expanded if it ends in .gz or .zst. `csv.file` defaults to the path. There
/// is no table if there is any error.
[[nodiscard]] TextTableResult read_text_table(const std::filesystem::path& path,
                                              const std::vector<std::string>& required = {},
                                              CsvOptions csv = {});

}  // namespace tcert::table
