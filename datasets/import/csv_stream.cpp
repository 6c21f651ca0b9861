#include "datasets/import/csv_stream.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <table/cell_reading.hpp>
#include <table/clock_column.hpp>
#include <table/date_cell.hpp>
#include <table/nearest_name.hpp>
#include <utility>

#include "datasets/import/stream_values.hpp"

namespace tcert::recording {
namespace {

using table::Severity;

constexpr std::size_t kRowsForUnit = 2000;

/// A column by its name, or by its position: "#3" is the third.
std::optional<std::size_t> position_of(const std::string& column, const table::CsvHeader& header) {
  if (const auto named = header.find(column)) {
    return named;
  }
  std::size_t number = 0;
  const char* const end = column.data() + column.size();
  if (!column.starts_with('#')) {
    return std::nullopt;
  }
  const auto [stop, error] = std::from_chars(column.data() + 1, end, number);
  const bool is_position =
      error == std::errc{} && stop == end && number >= 1 && number <= header.names.size();
  return is_position ? std::optional(number - 1) : std::nullopt;
}

/// Reads the rows of one file.
class CsvStreamReader {
 public:
  CsvStreamReader(const std::string& file,
                  const table::CsvHeader& header,
                  table::DiagnosticGroups& problems)
      : file_(file), header_(header), problems_(problems) {}

  [[nodiscard]] bool find_columns(const StreamSource& stream,
                                  const std::vector<ValueSource>& sources,
                                  const std::string& trial_column) {
    bool all = true;
    for (const ValueSource& source : sources) {
      for (const std::string& column : source.columns) {
        all = take(column, positions_.emplace_back()) && all;
      }
    }
    if (!trial_column.empty()) {
      all = take(trial_column, trial_.emplace()) && all;
    }
    return find_clock(stream) && all;
  }

  /// Settles the unit of a clock of which the map does not say it.
  void settle_unit(const StreamSource& stream) {
    dates_ = stream.time.dates;
    if (dates_ || clock_.nanoseconds) {
      return;
    }
    std::vector<double> times;
    std::size_t dates = 0;
    each_row(true, [&](const std::vector<std::string>& row, std::size_t /*line*/) {
      const auto reading = table::read_cell(row[clock_.column], header_.dialect.decimal_point);
      std::int64_t ignored = 0;
      if (reading.meaning == table::CellMeaning::number && std::isfinite(reading.value)) {
        times.push_back(reading.value);
      } else {
        dates += table::read_date(row[clock_.column], ignored) ? 1U : 0U;
      }
      return times.size() + dates < kRowsForUnit;
    });
    if (stream.time.unit) {
      unit_ = *stream.time.unit;
      return;
    }
    dates_ = dates > times.size();
    const table::TimeUnitGuess guess = table::guess_time_unit(clock_.named_unit, times);
    unit_ = guess.unit;
    if (dates_ || unit_ != table::TimeUnit::seconds) {
      add(Severity::note,
          header_.line,
          header_.names[clock_.column],
          dates_ ? "dates" : "times in " + std::string(table::name_of(unit_)),
          "'unit' of the clock in the map, where this is wrong" +
              (guess.reason.empty() ? "" : " (" + guess.reason + ")"));
    }
  }

  void show_rows(const std::vector<ValueSource>& sources, const CsvSampleSink& sink) {
    std::vector<double> values(sources.size());
    std::vector<double> cells;
    each_row(
        false,
        [&](const std::vector<std::string>& row, std::size_t line) {
          std::size_t next = 0;
          for (std::size_t i = 0; i < sources.size(); ++i) {
            cells.clear();
            for (std::size_t k = 0; k < sources[i].columns.size(); ++k) {
              cells.push_back(number_in(row, positions_[next++], line));
            }
            values[i] = cells.empty() ? std::numeric_limits<double>::quiet_NaN()
                                      : value_of(sources[i], cells);
          }
          sink({time_in(row), values, line, trial_ ? std::string_view(row[*trial_]) : ""});
          return true;
        },
        sink);
  }

 private:
  [[nodiscard]] bool take(const std::string& column, std::size_t& position) {
    const auto found = position_of(column, header_);
    if (!found) {
      const auto nearest = table::nearest_name(column, header_.names);
      add(Severity::error,
          header_.line,
          column,
          nearest.value_or(""),
          nearest ? "a column of this name, or of another in the map" : "a column of this name");
    }
    position = found.value_or(0);
    return found.has_value();
  }

  [[nodiscard]] bool find_clock(const StreamSource& stream) {
    const std::vector<std::string>& named = stream.time.columns;
    if (named.empty()) {
      const auto found = table::find_clock(header_.names);
      if (!found) {
        add(Severity::error,
            header_.line,
            "",
            "no column that is called as a clock",
            "'time' of the stream in the map, with its column");
        return false;
      }
      clock_ = *found;
      return true;
    }
    bool all = take(named[0], clock_.column);
    if (named.size() == 2) {
      all = take(named[1], clock_.nanoseconds.emplace()) && all;
    } else if (all) {
      clock_ = table::clock_named(header_.names, header_.names[clock_.column]).value_or(clock_);
      if (stream.time.unit) {
        clock_.nanoseconds.reset();
      }
    }
    return all;
  }

  /// `quiet` passes over rows of another length without a word.
  template <class Take>
  void each_row(bool quiet, const Take& take_row, const CsvSampleSink& unreadable = {}) {
    table::CsvCursor cursor = header_.data;
    std::vector<std::string> row;
    std::size_t last_width = 0;
    const char last = cursor.at == cursor.end ? '\n' : cursor.end[-1];
    const bool ends_open = last != '\n' && last != '\r';
    while (table::skip_to_record(cursor)) {
      const std::size_t line = cursor.line;
      const bool closed = table::scan_record(cursor, header_.dialect.separator, row);
      while (row.size() > header_.names.size() && row.back().empty()) {
        row.pop_back();
      }
      if (!closed || row.size() != header_.names.size()) {
        if (quiet) {
          continue;
        }
        add(Severity::warning,
            line,
            "",
            closed ? std::to_string(row.size()) + " fields" : "a quote that is never closed",
            std::to_string(header_.names.size()) + " fields; the row is not used");
        unreadable({std::nullopt, {}, line, ""});
        continue;
      }
      if (ends_open && cursor.at == cursor.end && row.back().size() < last_width) {
        if (!quiet) {
          add(Severity::note,
              line,
              header_.names.back(),
              table::shortened(row.back()),
              "a line end: the last row may be cut inside its number and is not used");
        }
        return;
      }
      last_width = row.back().size();
      if (!take_row(row, line)) {
        return;
      }
    }
  }

  /// NaN for a cell that is empty or, said so, no number.
  [[nodiscard]] double number_in(const std::vector<std::string>& row,
                                 std::size_t position,
                                 std::size_t line) {
    const auto reading = table::read_cell(row[position], header_.dialect.decimal_point);
    if (reading.meaning == table::CellMeaning::number ||
        reading.meaning == table::CellMeaning::truth) {
      return reading.value;
    }
    if (reading.meaning != table::CellMeaning::missing) {
      add(Severity::warning,
          line,
          header_.names[position],
          table::shortened(row[position]),
          table::read_cell(row[position], ',').meaning == table::CellMeaning::number
              ? "a number: --decimal-comma takes it for one; the cell is taken as empty"
              : "a number; the cell is taken as empty");
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  [[nodiscard]] std::optional<std::int64_t> time_in(const std::vector<std::string>& row) const {
    const char point = header_.dialect.decimal_point;
    std::int64_t time_ns = 0;
    const std::string& cell = row[clock_.column];
    if (dates_) {
      return table::read_date(cell, time_ns) ? std::optional(time_ns) : std::nullopt;
    }
    if (!table::read_time(cell, unit_, point, time_ns)) {
      return std::nullopt;
    }
    std::int64_t rest_ns = 0;
    if (clock_.nanoseconds &&
        !table::read_time(row[*clock_.nanoseconds], table::TimeUnit::nanoseconds, point, rest_ns)) {
      return std::nullopt;
    }
    constexpr std::int64_t kSecondNs = 1'000'000'000;
    return rest_ns >= 0 && rest_ns < kSecondNs ? std::optional(time_ns + rest_ns) : std::nullopt;
  }

  void add(Severity severity,
           std::size_t line,
           std::string column,
           std::string found,
           std::string expectation) {
    problems_.add(
        {severity, file_, line, std::move(column), std::move(found), std::move(expectation), 1});
  }

  const std::string& file_;
  const table::CsvHeader& header_;
  table::DiagnosticGroups& problems_;
  std::vector<std::size_t> positions_;  // of the columns of all sources
  std::optional<std::size_t> trial_;
  table::ClockColumn clock_;
  table::TimeUnit unit_ = table::TimeUnit::seconds;
  bool dates_ = false;
};

}  // namespace

bool read_csv_stream(const std::string& file,
                     const table::CsvHeader& header,
                     const StreamSource& stream,
                     const std::vector<ValueSource>& sources,
                     const std::string& trial_column,
                     const CsvSampleSink& sink,
                     table::DiagnosticGroups& problems) {
  CsvStreamReader reader(file, header, problems);
  if (!reader.find_columns(stream, sources, trial_column)) {
    return false;
  }
  reader.settle_unit(stream);
  reader.show_rows(sources, sink);
  return true;
}

}  // namespace tcert::recording
