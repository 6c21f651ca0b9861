#pragma once
/// \file
/// What a CSV file of unknown origin holds, and what is odd about it.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/clock_steps.hpp"
#include "datasets/csv_dialect.hpp"
#include "datasets/diagnostic.hpp"

namespace tcert {

enum class ColumnType {
  empty,   ///< No cell holds anything.
  number,  ///< At least half of the cells that hold something are finite numbers.
  text,
};

struct ColumnSummary {
  std::string name;
  ColumnType type = ColumnType::empty;
  std::size_t missing = 0;         ///< Empty cells.
  std::size_t not_numbers = 0;     ///< Of a number column: cells that are neither empty nor finite.
  std::optional<double> smallest;  ///< Of a number column.
  std::optional<double> largest;
  bool constant = false;  ///< Two rows or more, all with the same text.
};

struct CsvFileSummary {
  CsvDialect dialect;
  std::size_t preamble_records = 0;
  std::size_t header_line = 0;  ///< 0: there is no header.
  std::size_t rows = 0;         ///< Rows with the right number of cells.
  std::vector<ColumnSummary> columns;
  std::string time_column;          ///< Empty: none was found.
  std::optional<ClockSteps> clock;  ///< Of the time column.
  std::size_t gaps = 0;             ///< Steps longer than max_gap_s.
  std::size_t repeated_rows = 0;    ///< Equal in every cell to the row before.
  std::size_t frozen_rows = 0;      ///< Equal to the row before but for the time.
};

struct CsvCheckOptions {
  std::string time_column;  ///< Empty: the first column called time, time_s, timestamp, stamp or t.
  double max_gap_s = 1.0;
  bool decimal_comma = false;
};

struct CsvFileCheck {
  std::optional<CsvFileSummary> summary;  ///< Empty iff there is no table at all.
  std::vector<Diagnostic> diagnostics;
};

/// Reads a CSV file, plain or packed, and judges it without knowing what it should hold.
[[nodiscard]] CsvFileCheck check_csv_file(const std::filesystem::path& path,
                                          const CsvCheckOptions& options = {});

}  // namespace tcert
