#include <table/check_csv.hpp>

#include <algorithm>
#include <cmath>
#include <table/cell_reading.hpp>
#include <table/clock_watch.hpp>
#include <table/column_roles.hpp>
#include <table/control_bytes.hpp>
#include <table/csv_write.hpp>
#include <table/file_kind.hpp>
#include <table/mixture_check.hpp>
#include <table/text_file.hpp>
#include <table/unlike_times.hpp>
#include <utility>

namespace tcert::table {

namespace {

/// Goes through the rows once.
class CsvChecker {
 public:
  CsvChecker(std::string file, const CsvHeader& header, double max_gap_s, const std::string& clock)
      : file_(std::move(file)),
        dialect_(header.dialect),
        roles_(column_roles(header.names, clock)) {
    check_.dialect = header.dialect;
    check_.preamble_records = header.preamble_records;
    check_.header_line = header.line;
    for (const std::string& name : header.names) {
      check_.columns.push_back({name, 0, 0, 0, 0, {}, {}});
    }
    mixtures_.resize(header.names.size());
    for (const std::size_t column : roles_.times) {
      times_.push_back({column, {}, {}});
    }
    commas_.resize(header.names.size());
    if (roles_.clock) {
      clock_.emplace(file_, header.names[roles_.clock->column], *roles_.clock, max_gap_s);
    }
  }

  /// Empty fields beyond the header are none, as for every other reader.
  void take(std::vector<std::string>& fields, std::size_t line, DiagnosticGroups& problems) {
    while (fields.size() > check_.columns.size() && fields.back().empty()) {
      fields.pop_back();
    }
    if (fields.size() != check_.columns.size()) {
      problems.add({Severity::error,
                    file_,
                    line,
                    "",
                    std::to_string(fields.size()) + " fields",
                    std::to_string(check_.columns.size()) + " fields, as the header has",
                    1});
      return;
    }
    ++check_.rows;
    if (clock_) {
      clock_->take(fields, dialect_.decimal_point, line);
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      take_cell(i, fields[i], line, problems);
    }
    if (fields == last_) {
      problems.add({Severity::warning, file_, line, "", "the row before again", "new values", 1});
    }
    for (TimesOfColumn& times : times_) {
      const CellReading reading = read_cell(fields[times.column], dialect_.decimal_point);
      if (reading.meaning == CellMeaning::number && std::isfinite(reading.value)) {
        times.values.push_back(reading.value);
        times.lines.push_back(line);
      }
    }
    last_ = fields;
  }

  CsvCheck finish(DiagnosticGroups& problems) {
    for (std::size_t i = 0; i < check_.columns.size(); ++i) {
      ColumnCheck& column = check_.columns[i];
      mixtures_[i].finish(file_, column, problems);
      if (column.is_constant() && check_.rows > 1) {
        problems.add({Severity::note,
                      file_,
                      0,
                      column.name,
                      "always " + number_text(*column.least),
                      "a column that varies",
                      1});
      }
    }
    check_decimal_commas(problems);
    check_shape(problems);
    if (clock_ && is_stream()) {
      check_.clock = clock_->finish(problems);
    } else {
      for (const TimesOfColumn& times : times_) {
        check_times_of_trials(times, problems);
      }
    }
    return std::move(check_);
  }

 private:
  /// The numbers of a column of times, each with its line.
  struct TimesOfColumn {
    std::size_t column;
    std::vector<double> values;
    std::vector<std::size_t> lines;
  };

  /// Of a table of trials: stamps among durations, or stamps alone.
  void check_times_of_trials(const TimesOfColumn& times, DiagnosticGroups& problems) const {
    const ColumnCheck& column = check_.columns[times.column];
    if (const auto unlike = unlike_times(times.values)) {
      std::string found = number_text(unlike->time) + ", " + distance_in_words(*unlike);
      if (unlike->count > 1) {
        found += " (" + std::to_string(unlike->count) + " such times)";
      }
      problems.add({Severity::warning,
                    file_,
                    times.lines[unlike->first],
                    column.name,
                    std::move(found),
                    "times of one kind",
                    1});
    } else if (are_stamps(times.values)) {
      problems.add(
          {Severity::note,
           file_,
           0,
           column.name,
           "stamps, from " + number_text(*column.least) + " to " + number_text(*column.largest),
           "durations: subtract from each the start of its own trial",
           1});
    }
  }

  void take_cell(std::size_t i,
                 const std::string& cell,
                 std::size_t line,
                 DiagnosticGroups& problems) {
    ColumnCheck& column = check_.columns[i];
    const CellReading reading = read_cell(cell, dialect_.decimal_point);
    mixtures_[i].take(reading, cell, line);
    commas_[i] +=
        reading.meaning == CellMeaning::text && read_cell(cell, ',').meaning == CellMeaning::number
            ? 1U
            : 0U;
    const auto warn = [&](std::string found, std::string expectation) {
      problems.add({Severity::warning,
                    file_,
                    line,
                    column.name,
                    std::move(found),
                    std::move(expectation),
                    1});
    };
    if (reading.meaning == CellMeaning::number) {
      const double value = reading.value;
      column.least = column.least ? std::min(*column.least, value) : value;
      column.largest = column.largest ? std::max(*column.largest, value) : value;
      if (std::isinf(value)) {
        warn(shortened(cell), "a finite number, but where a range sees nothing");
      }
    } else if (reading.meaning == CellMeaning::missing) {
      ++column.missing;
      warn(cell.empty() ? "an empty cell" : shortened(cell), "a value");
    }
  }

  [[nodiscard]] bool is_stream() const {
    if (roles_.of_trials || roles_.of_stream) {
      return roles_.of_stream;
    }
    return roles_.may_be_stream || clock_->goes_forward();
  }

  /// Columns whose every text would be a number with a decimal comma.
  void check_decimal_commas(DiagnosticGroups& problems) const {
    for (std::size_t i = 0; i < check_.columns.size(); ++i) {
      const ColumnCheck& column = check_.columns[i];
      if (commas_[i] > 0 && commas_[i] == column.texts) {
        problems.add({Severity::error,
                      file_,
                      0,
                      column.name,
                      std::to_string(commas_[i]) + " numbers with a decimal comma",
                      "a decimal point, or --decimal-comma",
                      1});
      }
    }
  }

  void check_shape(DiagnosticGroups& problems) const {
    if (check_.rows == 0) {
      problems.add({Severity::error, file_, 0, "", "no rows", "a header line and rows", 1});
    } else if (check_.columns.size() == 1) {
      problems.add({Severity::note,
                    file_,
                    0,
                    "",
                    "one column",
                    "columns apart by comma, semicolon, tab, vertical bar or spaces",
                    1});
    }
    if (check_.rows > 0 && !roles_.clock && !roles_.of_trials) {
      problems.add({Severity::note,
                    file_,
                    0,
                    "",
                    "no column that is called as a clock",
                    "one, if this is the log of a sensor: --clock NAME says which",
                    1});
    }
  }

  std::string file_;
  CsvDialect dialect_;
  ColumnRoles roles_;
  CsvCheck check_;
  std::vector<MixtureCheck> mixtures_;  ///< Of each column.
  std::vector<std::size_t> commas_;     ///< Of each column, cells like 1,5.
  std::optional<ClockWatch> clock_;
  std::vector<std::string> last_;
  std::vector<TimesOfColumn> times_;
};

/// True if the first line is long enough to tell, and holds no NUL.
bool begins_as_text(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  return line.size() < text.size() && line.find('\0') == std::string_view::npos;
}

}  // namespace

CsvCheckResult check_csv_file(const std::filesystem::path& path,
                              double max_gap_s,
                              CsvOptions csv,
                              const std::string& clock) {
  if (csv.file.empty()) {
    csv.file = path.string();
  }
  CsvCheckResult result;
  const BytesResult file = read_text_file(path);
  if (!file.bytes) {
    result.diagnostics.push_back(
        {Severity::error, csv.file, 0, "", file.problem, "a readable file", 1});
    return result;
  }
  const std::string_view text = file.bytes->view();
  const auto kind = kind_of_binary(text, path.filename().string());
  // Text that was cut off or has colours of a terminal in it is text all the same.
  if (kind && (kind->name != kBinaryFile || !begins_as_text(text))) {
    result.diagnostics.push_back(
        {Severity::error, csv.file, 0, "", kind->name, "text; " + kind->way_out, 1});
    return result;
  }
  DiagnosticGroups problems;
  find_control_bytes(file.bytes->view(), csv.file, problems);
  if (const auto header = guess_header(file.bytes->view(), csv, problems)) {
    if (!clock.empty() && !header->find(clock)) {
      problems.add({Severity::error,
                    csv.file,
                    header->line,
                    shortened(clock),
                    "",
                    "a column of this name",
                    1});
    }
    CsvChecker checker(csv.file, *header, max_gap_s, clock);
    std::vector<std::string> fields;
    CsvCursor cursor = header->data;
    while (skip_to_record(cursor)) {
      const std::size_t line = cursor.line;
      if (!scan_record(cursor, header->dialect.separator, fields)) {
        problems.add({Severity::error,
                      csv.file,
                      line,
                      "",
                      "a quote that is never closed",
                      "a closing quote",
                      1});
        break;
      }
      checker.take(fields, line, problems);
    }
    result.check = checker.finish(problems);
  }
  result.diagnostics = problems.take();
  return result;
}

}  // namespace tcert::table
