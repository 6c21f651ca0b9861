#pragma once
/// \file
/// Lines of numbers as a table: the first line apart, since it may be a header.

#include <cstddef>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::terrain_reading {

/// Cells before they are taken for a rectangle, points or a header.
struct CellTable {
  std::string comment;                  ///< The first line that begins with #, whole; or empty.
  std::vector<std::string_view> first;  ///< Cells of the first line that is no comment, in `text`.
  std::string_view first_text;          ///< That line.
  std::size_t first_line = 0;           ///< 1-based.
  std::size_t rows = 0;                 ///< Lines after it.
  std::size_t columns = 0;              ///< Of those lines; of the first if there are none.
  std::vector<double> values;           ///< Of those lines, row by row; a gap is NaN.
  std::size_t words = 0;                ///< Cells among them that are empty or a word for a gap.
  std::vector<table::Diagnostic> problems;
};

/// Columns that problems name: the first few that have one by number, the others together.
class NamedColumns {
 public:
  /// `column` as text, or nothing. \pre column > 0
  [[nodiscard]] std::string of(std::size_t column);

 private:
  std::vector<std::size_t> named_;
};

/// Comma, semicolon, tab or blanks between the cells, whichever the first line with a number uses;
/// # begins a comment line. A separator at the end of every line is none, nor are double
/// quotes round a cell part of it. Problems: lines of
/// different lengths, cells that are neither a number nor a gap, more than 2^26 cells. O(size).
/// \pre `text` is of Bytes, and outlives the table.
[[nodiscard]] CellTable read_cells(std::string_view text, const std::string& file);

/// A number as the whole of a cell. \pre the cell lies in a buffer that scan_number may look ahead
/// in
[[nodiscard]] bool to_number(std::string_view cell, double& value);

/// Empty, nan, na, null, none, inf, -, ...: nothing is known there.
[[nodiscard]] bool is_gap_word(std::string_view cell);

/// The next line of `text`, which loses it; without the line end.
[[nodiscard]] std::string_view take_line(std::string_view& text);

}  // namespace tcert::terrain_reading
