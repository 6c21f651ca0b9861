#pragma once
/// \file
/// The one table model: every format prints the same cells, rounded only where people read them.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tcert {

enum class ColumnKind {
  text,
  integer,
  number,
  estimate,  ///< A value with an interval: three columns in data formats (x, x_low, x_high).
  p_value,
};

/// "text", "integer", "number", "estimate", "p_value".
[[nodiscard]] std::string_view to_string(ColumnKind kind) noexcept;

struct Column {
  std::string name;     ///< snake_case, with the unit; the header of data formats.
  std::string heading;  ///< For people.
  std::string unit;     ///< Printed behind the heading; empty if there is none.
  ColumnKind kind = ColumnKind::text;
  int decimals = 3;        ///< In print, for cells that do not say otherwise.
  int significant = 0;     ///< If above 0: digits in print, whatever the size of the number.
  bool is_answer = false;  ///< What the table is for: printed however narrow the terminal is.
};

/// Decimals as the column says.
inline constexpr int kColumnDecimals = -1;

struct Number {
  double value = std::numeric_limits<double>::quiet_NaN();
  int decimals = kColumnDecimals;
};

struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  int decimals = kColumnDecimals;
};

struct PValue {
  double value = std::numeric_limits<double>::quiet_NaN();
};

/// Missing is std::monostate; so is every number that is not finite: NA in print, an empty cell in
/// CSV, null in JSON. Never 0.
using TableCell = std::variant<std::monostate, std::string, std::int64_t, Number, Estimate, PValue>;

/// Says that data were made, not measured: the first line of everything printed from them.
struct SyntheticLabel {
  std::optional<std::uint64_t> seed;
};

/// "SYNTHETIC data, seed 1: made by a program, not measured on a robot."
[[nodiscard]] std::string to_string(const SyntheticLabel& label);

struct Table {
  std::string name;  ///< snake_case: the file name without its ending.
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<TableCell>> rows;
  std::vector<std::string> footnotes;
  std::optional<SyntheticLabel> synthetic;
  std::optional<std::int64_t> n;  ///< Trials behind the table.

  /// \throws std::invalid_argument if the cells do not match the columns in number or kind.
  void add_row(std::vector<TableCell> cells);
};

enum class TableFormat { text, markdown, csv, json, jsonl, latex };

/// Words of --format, in the order of TableFormat: text, md, csv, json, jsonl, tex.
[[nodiscard]] std::string_view to_string(TableFormat format) noexcept;
[[nodiscard]] std::optional<TableFormat> table_format_from(std::string_view word) noexcept;

/// The whole table, ended by a newline. CSV is RFC 4180 with \n line ends and no title; a synthetic
/// table has a last column `synthetic_seed`, so that the label survives merging and cutting. Text
/// is laid out for a terminal of `width` characters if that is above 0: headings are broken, notes
/// too, and columns from the right are named instead of shown.
[[nodiscard]] std::string render(const Table& table, TableFormat format, std::size_t width = 0);

/// The table that render(table, TableFormat::json) was made of: every format of it is the same
/// again. \throws std::invalid_argument if the text is nothing of the kind.
[[nodiscard]] Table table_from_json(std::string_view text);

/// The parts of the CSV form, for tables that are too long to hold: header and one row.
void append_csv_header(std::string& out, const Table& table);
void append_csv_row(std::string& out, const Table& table, const std::vector<TableCell>& cells);

/// One cell as people read it: rounded, "0.781 [0.742, 0.820]", "<0.001", NA.
[[nodiscard]] std::string printed(const TableCell& cell, const Column& column);

/// `value` with a fixed number of decimals, without a sign on zero; NA if it is not finite.
[[nodiscard]] std::string fixed(double value, int decimals);

/// `value` with so many significant digits: "0.0001234", "1.234e+09"; NA if it is not finite.
[[nodiscard]] std::string significant(double value, int digits);

}  // namespace tcert
