#include <table/check_csv.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <table/bytes.hpp>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/mixture_check.hpp>
#include <table/unlike_times.hpp>
#include <utility>

namespace tcert::table {

namespace {

constexpr std::array<std::string_view, 6> kClockNames = {
    "time", "time_s", "t", "t_s", "timestamp", "stamp"};

/// Columns that only a table of trials has: its times do not follow one another.
constexpr std::array<std::string_view, 8> kTrialNames = {
    "success", "status", "event", "outcome", "trial_id", "collided", "timeout", "end_reason"};

/// Parts of the names of a sensor's columns.
constexpr std::array<std::string_view, 7> kStreamParts = {
    "x_m", "y_m", "yaw", "bend", "force", "fsr", "range"};

/// Parts of the names of a table's columns of times, beside those of a clock.
constexpr std::array<std::string_view, 4> kTimeParts = {"time", "stamp", "duration", "elapsed"};

/// Times whose range is a smaller share of them are stamps: a day of seconds since 1970.

/// In a file of unknown columns: the share of steps that may go back before its times are no clock.
constexpr double kMostStepsBack = 0.1;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

bool is_clock_name(const std::string& lower) {
  return std::ranges::find(kClockNames, lower) != kClockNames.end();
}

bool is_time_name(const std::string& lower) {
  return is_clock_name(lower) || std::ranges::any_of(kTimeParts, [&](std::string_view part) {
           return lower.find(part) != std::string::npos;
         });
}

double share_of_sorted(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Goes through the rows once.
class CsvChecker {
 public:
  CsvChecker(std::string file, const CsvHeader& header, double max_gap_s)
      : file_(std::move(file)), dialect_(header.dialect), max_gap_s_(max_gap_s) {
    check_.dialect = header.dialect;
    check_.preamble_records = header.preamble_records;
    check_.header_line = header.line;
    for (const std::string& name : header.names) {
      check_.columns.push_back({name, 0, 0, 0, 0, {}, {}});
    }
    mixtures_.resize(header.names.size());
    const auto is_clock = [](const ColumnCheck& column) {
      return is_clock_name(lower_case(column.name));
    };
    for (std::size_t i = 0; i < check_.columns.size(); ++i) {
      const std::string name = lower_case(check_.columns[i].name);
      if (is_time_name(name)) {
        times_.push_back({i, {}, {}});
      }
      of_trials_ = of_trials_ || std::ranges::find(kTrialNames, name) != kTrialNames.end();
      of_stream_ = of_stream_ || std::ranges::any_of(kStreamParts, [&](std::string_view part) {
                     return name.find(part) != std::string::npos;
                   });
    }
    const auto clock = std::ranges::find_if(check_.columns, is_clock);
    clock_ = static_cast<std::size_t>(clock - check_.columns.begin());
  }

  void take(const std::vector<std::string>& fields, std::size_t line, DiagnosticGroups& problems) {
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
    if (clock_ < check_.columns.size() && is_stream()) {
      finish_clock();
      for (Diagnostic& problem : clock_problems_.take()) {
        problems.add(std::move(problem));
      }
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
        warn(shortened(cell), "a finite number");
      } else if (i == clock_) {
        take_time(column.name, value, line);
      }
    } else if (reading.meaning == CellMeaning::missing) {
      ++column.missing;
      warn(cell.empty() ? "an empty cell" : shortened(cell), "a value");
    }
  }

  /// Its problems count if the file turns out to be a stream.
  void take_time(const std::string& name, double time_s, std::size_t line) {
    if (last_time_s_) {
      const double step_s = time_s - *last_time_s_;
      ++steps_;
      steps_back_ += step_s < 0.0 ? 1U : 0U;
      if (!(step_s > 0.0)) {
        clock_problems_.add({Severity::error,
                             file_,
                             line,
                             name,
                             number_text(time_s) + " after " + number_text(*last_time_s_),
                             "times that increase",
                             1});
      } else {
        steps_s_.push_back(step_s);
      }
      if (step_s > max_gap_s_) {
        clock_problems_.add({Severity::warning,
                             file_,
                             line,
                             name,
                             "a gap of " + number_text(step_s) + " s",
                             "steps of at most " + number_text(max_gap_s_) + " s",
                             1});
      }
    } else {
      first_time_s_ = time_s;
    }
    last_time_s_ = time_s;
  }

  [[nodiscard]] bool is_stream() const {
    if (of_trials_ || of_stream_) {
      return of_stream_;
    }
    return static_cast<double>(steps_back_) <= kMostStepsBack * static_cast<double>(steps_);
  }

  void finish_clock() {
    if (steps_s_.empty()) {
      return;
    }
    std::ranges::sort(steps_s_);
    check_.clock = ClockCheck{check_.columns[clock_].name,
                              first_time_s_,
                              *last_time_s_,
                              1.0 / share_of_sorted(steps_s_, 0.95),
                              1.0 / share_of_sorted(steps_s_, 0.50),
                              1.0 / share_of_sorted(steps_s_, 0.05),
                              steps_s_.back()};
  }

  std::string file_;
  CsvDialect dialect_;
  double max_gap_s_;
  CsvCheck check_;
  std::vector<MixtureCheck> mixtures_;  ///< Of each column.
  std::size_t clock_ = 0;
  std::vector<std::string> last_;
  double first_time_s_ = 0.0;
  std::optional<double> last_time_s_;
  std::vector<double> steps_s_;
  std::size_t steps_ = 0;
  std::size_t steps_back_ = 0;
  bool of_trials_ = false;
  bool of_stream_ = false;
  DiagnosticGroups clock_problems_;
  std::vector<TimesOfColumn> times_;
};

/// Bytes that no text has: a file that was cut off or overwritten.
void find_control_bytes(std::string_view text,
                        const std::string& file,
                        DiagnosticGroups& problems) {
  std::size_t line = 1;
  std::size_t first_line = 0;
  std::size_t count = 0;
  unsigned first = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    line += c == '\n' ? 1U : 0U;
    if ((byte < 0x20U && c != '\n' && c != '\r' && c != '\t') || byte == 0x7FU) {
      first_line = count == 0 ? line : first_line;
      first = count == 0 ? byte : first;
      ++count;
    }
  }
  if (count > 0) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::string code{kDigits[first / 16U], kDigits[first % 16U]};
    problems.add({Severity::error,
                  file,
                  first_line,
                  "",
                  count == 1 ? "a control byte 0x" + code
                             : std::to_string(count) + " control bytes, the first 0x" + code,
                  "text alone",
                  1});
  }
}

}  // namespace

CsvCheckResult check_csv_file(const std::filesystem::path& path, double max_gap_s, CsvOptions csv) {
  if (csv.file.empty()) {
    csv.file = path.string();
  }
  CsvCheckResult result;
  const BytesResult file = read_file(path);
  if (!file.bytes) {
    result.diagnostics.push_back(
        {Severity::error, csv.file, 0, "", file.problem, "a readable file", 1});
    return result;
  }
  DiagnosticGroups problems;
  find_control_bytes(file.bytes->view(), csv.file, problems);
  if (const auto header = guess_header(file.bytes->view(), csv, problems)) {
    CsvChecker checker(csv.file, *header, max_gap_s);
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
