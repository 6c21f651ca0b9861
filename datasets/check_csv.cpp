#include "datasets/check_csv.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "datasets/csv.hpp"
#include "datasets/csv_write.hpp"
#include "datasets/decimal.hpp"
#include "datasets/nearest_name.hpp"
#include "datasets/stream_clock.hpp"

namespace tcert {

namespace {

constexpr std::array<const char*, 5> kTimeNames{"time_s", "time", "timestamp", "stamp", "t"};

/// Reads cells of one dialect as numbers.
class CellNumbers {
 public:
  explicit CellNumbers(char decimal_point) : decimal_point_(decimal_point) {}

  [[nodiscard]] std::optional<double> number(const std::string& cell) {
    padded_.assign(cell);
    const char* const begin = padded_.view().data();
    double value = 0.0;
    if (scan_number(begin, decimal_point_, value) != begin + cell.size()) {
      return std::nullopt;
    }
    return value;
  }

  [[nodiscard]] std::optional<std::int64_t> time_ns(const std::string& cell) {
    padded_.assign(cell);
    const char* const begin = padded_.view().data();
    std::int64_t value = 0;
    if (scan_seconds(begin, decimal_point_, value) != begin + cell.size()) {
      return std::nullopt;
    }
    return value;
  }

 private:
  char decimal_point_;
  Bytes padded_;
};

/// Judges one table.
class TableCheck {
 public:
  TableCheck(const TextTable& table,
             const std::string& file,
             const CsvCheckOptions& options,
             CsvFileSummary& summary,
             DiagnosticGroups& problems)
      : table_(table),
        file_(file),
        options_(options),
        summary_(summary),
        problems_(problems),
        numbers_(table.dialect.decimal_point) {}

  void run() {
    summary_.rows = table_.rows();
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      summary_.columns.push_back(summarise_column(c));
    }
    const std::optional<std::size_t> time = find_time();
    if (time) {
      check_time(*time);
    }
    count_repeated_rows(time);
  }

 private:
  void add(Severity severity,
           std::size_t line,
           const std::string& column,
           std::string value,
           std::string expectation) {
    problems_.add({severity, file_, line, column, std::move(value), std::move(expectation), 1});
  }

  [[nodiscard]] ColumnSummary summarise_column(std::size_t column) {
    ColumnSummary out;
    out.name = table_.columns[column];
    out.constant = table_.rows() > 1;
    std::size_t finite = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const std::string& cell = table_.at(row, column);
      out.constant = out.constant && cell == table_.at(0, column);
      if (cell.empty()) {
        ++out.missing;
      } else if (const auto value = numbers_.number(cell)) {
        out.smallest = finite == 0 ? *value : std::min(*out.smallest, *value);
        out.largest = finite == 0 ? *value : std::max(*out.largest, *value);
        ++finite;
      } else {
        ++out.not_numbers;
      }
    }
    if (finite > 0 && finite >= out.not_numbers) {
      out.type = ColumnType::number;
      report_not_numbers(column, out);
    } else {
      out.type = out.not_numbers > 0 ? ColumnType::text : ColumnType::empty;
      out.not_numbers = 0;
      out.smallest.reset();
      out.largest.reset();
    }
    if (out.constant) {
      add(Severity::note,
          0,
          out.name,
          out.missing > 0 ? std::string("nothing") : shortened(table_.at(0, column)),
          "values that change; all rows are the same");
    }
    return out;
  }

  void report_not_numbers(std::size_t column, const ColumnSummary& summary) {
    for (std::size_t row = 0; row < table_.rows() && summary.not_numbers > 0; ++row) {
      const std::string& cell = table_.at(row, column);
      if (!cell.empty() && !numbers_.number(cell)) {
        add(Severity::error, table_.lines[row], summary.name, shortened(cell), "a finite number");
      }
    }
  }

  [[nodiscard]] std::optional<std::size_t> find_time() {
    if (!options_.time_column.empty()) {
      const auto found = table_.find(options_.time_column);
      if (!found) {
        add(Severity::error,
            summary_.header_line,
            options_.time_column,
            "",
            "a column of this name");
      }
      return found;
    }
    for (const char* name : kTimeNames) {
      for (std::size_t c = 0; c < table_.columns.size(); ++c) {
        if (case_folded(table_.columns[c]) == name &&
            summary_.columns[c].type == ColumnType::number) {
          return c;
        }
      }
    }
    return std::nullopt;
  }

  /// Cells that are no time are reported as no numbers already.
  void check_time(std::size_t column) {
    summary_.time_column = table_.columns[column];
    NumberTable clock;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (const auto time = numbers_.time_ns(table_.at(row, column))) {
        clock.time_ns.push_back(*time);
        clock.lines.push_back(static_cast<std::uint32_t>(table_.lines[row]));
      }
    }
    summary_.clock = clock_steps(clock.time_ns);
    put_in_order(clock, file_, summary_.time_column, false, EqualTimes::in_file_order, problems_);
    const ClockLimits limits{options_.max_gap_s, std::nullopt};
    summary_.gaps = find_breaks(clock, file_, summary_.time_column, limits, problems_).size();
  }

  [[nodiscard]] bool equals_row_before(std::size_t row, std::optional<std::size_t> except) const {
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      if (c != except && table_.at(row, c) != table_.at(row - 1, c)) {
        return false;
      }
    }
    return true;
  }

  void count_repeated_rows(std::optional<std::size_t> time) {
    for (std::size_t row = 1; row < table_.rows(); ++row) {
      if (equals_row_before(row, std::nullopt)) {
        ++summary_.repeated_rows;
        add(Severity::warning, table_.lines[row], "", "a copy of the row before", "each row once");
      } else if (time && table_.columns.size() > 1 && equals_row_before(row, time)) {
        ++summary_.frozen_rows;
        add(Severity::note,
            table_.lines[row],
            "",
            "the row before at another time",
            "values that change with time");
      }
    }
  }

  const TextTable& table_;
  const std::string& file_;
  const CsvCheckOptions& options_;
  CsvFileSummary& summary_;
  DiagnosticGroups& problems_;
  CellNumbers numbers_;
};

}  // namespace

CsvFileCheck check_csv_file(const std::filesystem::path& path, const CsvCheckOptions& options) {
  CsvFileCheck check;
  CsvOptions csv;
  csv.file = path.string();
  csv.decimal_comma = options.decimal_comma;
  const BytesResult file = read_file(path);
  if (!file.bytes) {
    check.diagnostics.push_back(
        {Severity::error, csv.file, 0, "", file.problem, "a readable file", 1});
    return check;
  }
  DiagnosticGroups problems;
  if (const auto header = guess_header(file.bytes->view(), csv, problems)) {
    const TextTable table = read_text_rows(*file.bytes, *header, csv, problems);
    CsvFileSummary summary;
    summary.dialect = header->dialect;
    summary.preamble_records = header->preamble_records;
    summary.header_line = header->line;
    TableCheck(table, csv.file, options, summary, problems).run();
    check.summary = std::move(summary);
  }
  check.diagnostics = problems.take();
  return check;
}

}  // namespace tcert
