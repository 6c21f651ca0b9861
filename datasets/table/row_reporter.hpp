#pragma once
/// \file
/// What is wrong with the rows of a CSV file, in words. Internal to csv.cpp.

#include <cstddef>
#include <string>
#include <string_view>
#include <table/csv.hpp>
#include <table/csv_header.hpp>
#include <table/csv_row.hpp>
#include <table/diagnostic.hpp>
#include <utility>

namespace tcert::table {

/// What becomes of a bad row.
enum class BadRow {
  rejects,      ///< The file is rejected, and would not be with repair if it has good rows too.
  is_dropped,   ///< By repair.
  is_left_out,  ///< And is an error all the same.
};

/// Turns what is wrong with rows into diagnostics.
class RowReporter {
 public:
  RowReporter(const CsvOptions& csv,
              const CsvHeader& header,
              BadRow bad_row,
              std::string_view text,
              DiagnosticGroups& problems)
      : csv_(csv),
        header_(header),
        bad_row_(bad_row),
        ends_with_line_end_(text.ends_with('\n')),
        problems_(problems) {}

  /// `after` is the cursor behind the row, to tell a last line that is cut short.
  void report(const RowPlan& plan,
              const RowProblems& row,
              std::size_t line,
              const CsvCursor& after) {
    if (after.at == after.end && !ends_with_line_end_ && (!row.open_quote || after.line == line)) {
      cut_short_ = true;
      add(Severity::warning,
          line,
          "",
          "a line cut short",
          "a whole last line with its line end; the row is not used");
      return;
    }
    if (row.open_quote) {
      can_be_repaired_ = false;
      add(Severity::error, line, "", "a quote that is never closed", "a closing quote");
    } else if (row.fields != 0) {
      add_bad_row(line,
                  "",
                  std::to_string(row.fields) + " fields",
                  std::to_string(header_.names.size()) + " fields");
    }
    for (const CellProblem& cell : row.cells) {
      add_bad_row(line,
                  header_.names[cell.cell],
                  shortened(cell.value),
                  expectation(plan.cells[cell.cell].kind));
    }
  }

  /// Reports the bad rows, with the way out: repair helps a file only if it has good rows too, and
  /// nothing worse than bad rows.
  void finish(bool has_good_rows) {
    const char* const way_out = bad_row_ == BadRow::is_dropped ? "; the row is dropped"
                                : bad_row_ == BadRow::rejects && has_good_rows && can_be_repaired_
                                    ? "; --repair drops such rows"
                                    : "";
    for (Diagnostic& bad : bad_rows_.take()) {
      bad.expectation += way_out;
      problems_.add(std::move(bad));
    }
  }

  void report_missing_line_end() {
    if (!ends_with_line_end_ && !cut_short_) {
      add(Severity::warning,
          0,
          "",
          "no line end after the last row",
          "one; the row looks whole and is used");
    }
  }

  void report_no_rows(std::size_t empty) {
    add(Severity::error,
        0,
        "",
        empty > 0 ? std::to_string(empty) + " rows, none with a value" : "no rows",
        empty > 0 ? "at least one row with a value" : "at least one row");
  }

 private:
  static std::string expectation(CellKind kind) {
    switch (kind) {
      case CellKind::seconds:
        return "a time in seconds";
      case CellKind::optional_seconds:
        return "a time in seconds (" + std::string(kHowMissingIsWritten) + ")";
      case CellKind::optional_flag:
        return "0 or 1, true or false";
      case CellKind::optional_number:
        return "a finite number (" + std::string(kHowMissingIsWritten) + ")";
      case CellKind::optional_range:
        return "a number or inf (" + std::string(kHowMissingIsWritten) + ")";
      case CellKind::number:
      case CellKind::ignored:
        break;
    }
    return "a finite number";
  }

  void add(Severity severity,
           std::size_t line,
           std::string column,
           std::string value,
           std::string expected) {
    problems_.add(
        {severity, csv_.file, line, std::move(column), std::move(value), std::move(expected), 1});
  }

  void add_bad_row(std::size_t line, std::string column, std::string value, std::string expected) {
    const Severity severity = bad_row_ == BadRow::is_dropped ? Severity::warning : Severity::error;
    bad_rows_.add(
        {severity, csv_.file, line, std::move(column), std::move(value), std::move(expected), 1});
  }

  const CsvOptions& csv_;
  const CsvHeader& header_;
  BadRow bad_row_;
  bool ends_with_line_end_;
  bool cut_short_ = false;
  bool can_be_repaired_ = true;
  DiagnosticGroups bad_rows_;
  DiagnosticGroups& problems_;
};

}  // namespace tcert::table
