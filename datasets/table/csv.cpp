#include <table/csv.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <table/cell_reading.hpp>
#include <table/row_reporter.hpp>
#include <table/text_file.hpp>
#include <utility>

namespace tcert::table {

namespace {

bool holds_nothing(double value) { return std::isnan(value); }

/// True if nothing is wrong with the row but that cells are missing, and all wanted ones are.
bool is_empty_row(const RowPlan& plan, const RowProblems& wrong, const std::vector<double>& row) {
  if (wrong.fields != 0 || wrong.open_quote) {
    return false;
  }
  const auto states_a_value = [&row](const CellPlan& cell) {
    return cell.kind != CellKind::ignored && cell.kind != CellKind::seconds &&
           cell.kind != CellKind::optional_seconds && !holds_nothing(row[cell.slot]);
  };
  return std::ranges::none_of(plan.cells, states_a_value) &&
         std::ranges::all_of(wrong.cells,
                             [](const CellProblem& cell) { return is_missing_cell(cell.value); });
}

/// Rows to make room for, judged by the first of them.
std::size_t estimated_rows(const CsvCursor& data) {
  const std::string_view text(data.at, static_cast<std::size_t>(data.end - data.at));
  const std::size_t first = std::min(text.find('\n'), text.size());
  return text.size() / std::max<std::size_t>(first, 8) + 16;
}

NumberTable table_for(const CsvHeader& header, const NumberOptions& options) {
  NumberTable table;
  table.columns = options.columns.size();
  for (const NumberColumn& column : options.columns) {
    table.present.push_back(header.find(column.name) ? 1 : 0);
  }
  const std::size_t rows = estimated_rows(header.data);
  table.values.reserve(rows * table.columns);
  table.lines.reserve(rows);
  if (!options.time_column.empty()) {
    table.time_ns.reserve(rows);
  }
  return table;
}

/// The columns of times in the row that was added last.
void fill_times(const NumberOptions& options,
                const std::vector<std::int64_t>& times_ns,
                NumberTable& table) {
  std::size_t slot = 0;
  for (std::size_t i = 0; i < table.columns; ++i) {
    if (!options.columns[i].is_time || table.present[i] == 0) {
      continue;
    }
    if (const std::int64_t time = times_ns[++slot]; time != kNoTime) {
      double& value = table.values[table.values.size() - table.columns + i];
      value = static_cast<double>(time - times_ns.front());
    }
  }
}

}  // namespace

std::vector<std::string> required_names(const NumberOptions& options) {
  std::vector<std::string> names;
  if (!options.time_column.empty()) {
    names.push_back(options.time_column);
  }
  for (const NumberColumn& column : options.columns) {
    if (column.required) {
      names.push_back(column.name);
    }
  }
  return names;
}

RowPlan plan_row(const CsvHeader& header, const NumberOptions& options) {
  RowPlan plan{header.dialect, std::vector<CellPlan>(header.names.size())};
  if (const auto time = header.find(options.time_column); time && !options.time_column.empty()) {
    plan.cells[*time].kind = CellKind::seconds;
  }
  std::size_t times = 0;  // after that of the row
  for (std::size_t i = 0; i < options.columns.size(); ++i) {
    const NumberColumn& column = options.columns[i];
    if (const auto position = header.find(column.name)) {
      if (column.is_time) {
        plan.cells[*position] = {CellKind::optional_seconds, ++times};
        continue;
      }
      plan.cells[*position] = {column.is_flag           ? CellKind::optional_flag
                               : column.may_be_infinite ? CellKind::optional_range
                               : column.may_be_empty    ? CellKind::optional_number
                                                        : CellKind::number,
                               i};
    }
  }
  return plan;
}

std::optional<NumberTable> read_numbers(const Bytes& bytes,
                                        const CsvOptions& csv,
                                        const NumberOptions& options,
                                        DiagnosticGroups& problems) {
  const std::string_view text = bytes.view();
  const auto header = find_header(text, csv, required_names(options), problems);
  if (!header) {
    return std::nullopt;
  }
  const RowPlan plan = plan_row(*header, options);
  NumberTable table = table_for(*header, options);
  RowReporter reporter(
      csv, *header, options.repair ? BadRow::is_dropped : BadRow::rejects, text, problems);
  const bool has_time = !options.time_column.empty();
  const bool has_other_times = std::ranges::any_of(options.columns, &NumberColumn::is_time);
  std::vector<double> row(table.columns, std::numeric_limits<double>::quiet_NaN());
  std::vector<std::int64_t> times_ns(1 + table.columns, kNoTime);
  CsvCursor cursor = header->data;
  while (skip_to_record(cursor)) {
    const std::size_t line = cursor.line;
    RowProblems wrong;
    const bool good = scan_row(plan, cursor, times_ns.data(), row.data(), wrong);
    if (options.skip_empty_rows &&
        (good ? std::ranges::all_of(row, holds_nothing) : is_empty_row(plan, wrong, row))) {
      ++table.empty_rows;
      continue;
    }
    if (!good) {
      reporter.report(plan, wrong, line, cursor);
      continue;
    }
    table.values.insert(table.values.end(), row.begin(), row.end());
    if (has_other_times) {
      fill_times(options, times_ns, table);
    }
    table.lines.push_back(static_cast<std::uint32_t>(line));
    if (has_time) {
      table.time_ns.push_back(times_ns.front());
    }
  }
  reporter.finish(table.rows() > 0);
  if (table.rows() == 0 && !problems.has_error()) {
    reporter.report_no_rows(table.empty_rows);
  }
  if (problems.has_error()) {
    return std::nullopt;
  }
  reporter.report_missing_line_end();
  return table;
}

std::optional<std::size_t> TextTable::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(columns, name);
  if (found == columns.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - columns.begin());
}

TextTable read_text_rows(const Bytes& bytes,
                         const CsvHeader& header,
                         const CsvOptions& csv,
                         DiagnosticGroups& problems) {
  TextTable table;
  table.dialect = header.dialect;
  table.columns = header.names;
  RowReporter reporter(csv, header, BadRow::is_left_out, bytes.view(), problems);
  const RowPlan plan{header.dialect, {}};
  CsvCursor cursor = header.data;
  std::vector<std::string> record;
  while (skip_to_record(cursor)) {
    const std::size_t line = cursor.line;
    const bool closed = scan_record(cursor, header.dialect.separator, record);
    while (record.size() > table.columns.size() && record.back().empty()) {
      record.pop_back();
    }
    if (!closed || record.size() != table.columns.size()) {
      RowProblems wrong;
      wrong.fields = record.size();
      wrong.open_quote = !closed;
      reporter.report(plan, wrong, line, cursor);
      continue;
    }
    table.cells.insert(table.cells.end(), record.begin(), record.end());
    table.lines.push_back(line);
  }
  reporter.finish(table.rows() > 0);
  reporter.report_missing_line_end();
  return table;
}

std::optional<TextTable> read_text_table(const Bytes& bytes,
                                         const CsvOptions& csv,
                                         const std::vector<std::string>& required,
                                         DiagnosticGroups& problems) {
  const auto header = find_header(bytes.view(), csv, required, problems);
  if (!header) {
    return std::nullopt;
  }
  return read_text_rows(bytes, *header, csv, problems);
}

TextTableResult read_text_table(const std::filesystem::path& path,
                                const std::vector<std::string>& required,
                                CsvOptions csv) {
  if (csv.file.empty()) {
    csv.file = path.string();
  }
  BytesResult file = read_text_file(path);
  if (!file.bytes) {
    return {std::nullopt, {{Severity::error, csv.file, 0, "", file.problem, "a readable file", 1}}};
  }
  DiagnosticGroups problems;
  std::optional<TextTable> table = read_text_table(*file.bytes, csv, required, problems);
  if (problems.has_error()) {
    table.reset();
  }
  return {std::move(table), problems.take()};
}

}  // namespace tcert::table
