#pragma once
/// \file
/// What stands in a CSV file of which nothing is known, and what is wrong with it.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <table/csv_header.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

/// One column: how many of its cells are what, and the range of its numbers.
struct ColumnCheck {
  std::string name;
  std::size_t numbers = 0;  ///< Infinite ones too.
  std::size_t truths = 0;   ///< TRUE, False, ..., in a column of nothing else but 0 and 1.
  std::size_t missing = 0;  ///< Empty cells, NA and nan.
  std::size_t texts = 0;    ///< All others.
  std::optional<double> least;
  std::optional<double> largest;

  [[nodiscard]] bool is_constant() const noexcept {
    return numbers > 1 && texts == 0 && least == largest;
  }
};

/// The clock of a file: its first column that is_clock_name(), or the one that was asked for.
struct ClockCheck {
  std::string column;
  std::string unit;  ///< Of the file: "s", "ms", "us", "ns", "s and ns", "dates".
  double first_s = 0.0;
  double last_s = 0.0;
  double least_rate_hz = 0.0;  ///< 5th percentile of 1 / step over the steps that increase.
  double median_rate_hz = 0.0;
  double largest_rate_hz = 0.0;  ///< 95th percentile.
  double longest_gap_s = 0.0;
};

struct CsvCheck {
  CsvDialect dialect;
  std::size_t preamble_records = 0;
  std::size_t header_line = 0;  ///< 0: the file has no header.
  std::size_t rows = 0;         ///< With as many cells as the header.
  std::vector<ColumnCheck> columns;
  std::optional<ClockCheck> clock;  ///< Empty without a clock, with fewer than two times, or for
                                    ///< a table that is no stream.
};

struct CsvCheckResult {
  std::optional<CsvCheck> check;  ///< Empty iff the file cannot be read as CSV at all.
  std::vector<Diagnostic> diagnostics;
};

/// Reads a CSV file of any dialect (gzip and zstd are expanded), its cells by read_cell(), as every
/// other command does, and names its faults: control bytes, rows of another length, no clock or no
/// rows, a decimal comma that was not asked for, text in a column of numbers
/// (MixedCells::is_spoiled(): `fit` refuses such a column), other mixtures of numbers and names,
/// words for missing cells, infinities, missing cells, rows that repeat the one before, constant
/// columns (a note); in a stream also times that do not increase and gaps of more than `max_gap_s`;
/// in a table that is no stream, times far from the others of their column (`unlike_times`), and a
/// column of stamps (a note). A stream has a sensor's columns, or neither those nor a table of
/// trials' (success, status, ...) and times of which a tenth at most go back. `clock` names its
/// clock where the name does not. Never throws on what it finds. O(size).
[[nodiscard]] CsvCheckResult check_csv_file(const std::filesystem::path& path,
                                            double max_gap_s = 1.0,
                                            CsvOptions csv = {},
                                            const std::string& clock = {});

}  // namespace tcert::table
