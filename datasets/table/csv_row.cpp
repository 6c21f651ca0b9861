#include <table/csv_row.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <table/bytes.hpp>
#include <table/cell_reading.hpp>
#include <table/decimal.hpp>

namespace tcert::table {

namespace {

/// Takes a cell that the fast path could not: spaces, quotes, a missing value, or an error.
class CellReader {
 public:
  CellReader(const RowPlan& plan, std::int64_t* times_ns, double* values) noexcept
      : plan_(plan), times_ns_(times_ns), values_(values) {}

  [[nodiscard]] bool read(const CellPlan& cell, std::string_view text) {
    if (cell.kind == CellKind::ignored) {
      return true;
    }
    const char point = plan_.dialect.decimal_point;
    if (cell.kind == CellKind::optional_seconds && is_missing_cell(text)) {
      times_ns_[cell.slot] = kNoTime;
      return true;
    }
    if (cell.kind == CellKind::seconds || cell.kind == CellKind::optional_seconds) {
      padded_.assign(text);
      const char* const begin = padded_.view().data();
      return !text.empty() &&
             scan_seconds(begin, point, times_ns_[cell.slot]) == begin + text.size();
    }
    const CellReading reading = read_cell(text, point);
    values_[cell.slot] = reading.value;
    switch (reading.meaning) {
      case CellMeaning::number:
        return std::isfinite(reading.value) || cell.kind == CellKind::optional_range;
      case CellMeaning::missing:
        return cell.kind != CellKind::number;
      case CellMeaning::truth:
        return cell.kind == CellKind::optional_flag;
      case CellMeaning::missing_word:
      case CellMeaning::text:
        break;
    }
    return false;
  }

 private:
  const RowPlan& plan_;
  std::int64_t* times_ns_;
  double* values_;
  Bytes padded_;
};

/// Reads the rest of a record, from the field at `position` on, with every check. Kept out of the
/// way of the fast path, which then needs fewer registers.
[[gnu::noinline]] bool scan_carefully(const RowPlan& plan,
                                      CsvCursor& cursor,
                                      std::size_t position,
                                      std::int64_t* times_ns,
                                      double* values,
                                      RowProblems& problems) {
  CellReader reader(plan, times_ns, values);
  std::string unquoted;
  CsvField field;
  bool surplus = false;
  do {
    field = scan_field(cursor, plan.dialect.separator, unquoted);
    if (position >= plan.cells.size()) {
      surplus = surplus || !field.text.empty();
    } else if (!reader.read(plan.cells[position], field.text)) {
      problems.cells.push_back({position, std::string(field.text)});
    }
    ++position;
  } while (!field.ends_record);
  problems.open_quote = field.open_quote;
  if (surplus || position < plan.cells.size()) {
    problems.fields = position;
  }
  return problems.empty();
}

/// Where an unquoted field that is not wanted ends.
const char* skip_plain(const char* p, char separator) noexcept {
  while (*p != separator && *p != '\n' && *p != '"' && (*p != '\t' || separator != ' ')) {
    ++p;
  }
  return p;
}

const char* skip_run_of_spaces(const char* p) noexcept {
  while (*p == ' ' || *p == '\t') {
    ++p;
  }
  return p;
}

bool ends_cell(char c, char separator) noexcept { return c == separator || c == '\n' || c == '\r'; }

/// Reads one plain cell; null if it needs care.
inline const char* scan_plain(const CellPlan& cell,
                              CsvDialect dialect,
                              const char* p,
                              std::int64_t* times_ns,
                              double* values) noexcept {
  if (cell.kind == CellKind::ignored) {
    return skip_plain(p, dialect.separator);
  }
  if (cell.kind >= CellKind::number) [[likely]] {
    const char* const next = scan_number(p, dialect.decimal_point, values[cell.slot]);
    if (next != nullptr || cell.kind == CellKind::number || !ends_cell(*p, dialect.separator)) {
      return next;
    }
    values[cell.slot] = std::numeric_limits<double>::quiet_NaN();
    return p;
  }
  if (cell.kind == CellKind::seconds || !ends_cell(*p, dialect.separator)) {
    return scan_seconds(p, dialect.decimal_point, times_ns[cell.slot]);
  }
  times_ns[cell.slot] = kNoTime;
  return p;
}

}  // namespace

// A row whose cells are all plain numbers is read in one pass without looking for its end first.
// The first cell that is not hands the rest of the row to the careful reader.
bool scan_row(const RowPlan& plan,
              CsvCursor& cursor,
              std::int64_t* times_ns,
              double* values,
              RowProblems& problems) {
  const CsvDialect dialect = plan.dialect;
  const std::span<const CellPlan> cells = plan.cells;
  const char* p = cursor.at;
  std::size_t position = 0;
  for (; position < cells.size(); ++position) {
    if (dialect.separator == ' ') {
      p = skip_run_of_spaces(p);
    }
    const char* next = scan_plain(cells[position], dialect, p, times_ns, values);
    if (next == nullptr) {
      break;
    }
    if (position + 1 < cells.size()) {
      if (*next != dialect.separator) {
        break;
      }
      p = next + 1;
      continue;
    }
    next += *next == '\r' ? 1 : 0;
    if (*next != '\n' || next > cursor.end) {
      break;
    }
    // The line feed that pads the text ends a last line without one.
    const bool ends_text = next == cursor.end;
    cursor.at = ends_text ? next : next + 1;
    cursor.line += ends_text ? 0 : 1;
    return true;
  }
  cursor.at = p;
  return scan_carefully(plan, cursor, position, times_ns, values, problems);
}

}  // namespace tcert::table
