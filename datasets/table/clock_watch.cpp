#include <table/clock_watch.hpp>

#include <algorithm>
#include <cmath>
#include <table/cell_reading.hpp>
#include <table/csv_write.hpp>
#include <table/date_cell.hpp>
#include <utility>

namespace tcert::table {
namespace {

/// In a file of unknown columns: the share of steps that may go back before its times are no clock.
constexpr double kMostStepsBack = 0.1;

/// Of all steps, those that do not move: more of them are stamps that were cut to whole seconds.
constexpr double kMostEqualSteps = 0.1;

double share_of_sorted(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

ClockWatch::ClockWatch(std::string file,
                       std::string column,
                       const ClockColumn& clock,
                       double max_gap_s)
    : file_(std::move(file)), column_(std::move(column)), clock_(clock), max_gap_s_(max_gap_s) {}

void ClockWatch::take(const std::vector<std::string>& fields,
                      char decimal_point,
                      std::size_t line) {
  const CellReading reading = read_cell(fields[clock_.column], decimal_point);
  double time = reading.value;
  if (reading.meaning == CellMeaning::text) {
    std::int64_t date_ns = 0;
    if (!read_date(fields[clock_.column], date_ns)) {
      return;
    }
    ++dates_;
    time = 1e-9 * static_cast<double>(date_ns);
  } else if (reading.meaning != CellMeaning::number || !std::isfinite(time)) {
    return;
  }
  if (clock_.nanoseconds) {
    const CellReading rest = read_cell(fields[*clock_.nanoseconds], decimal_point);
    if (rest.meaning != CellMeaning::number) {
      return;
    }
    time += 1e-9 * rest.value;
  }
  times_.push_back(time);
  lines_.push_back(line);
}

bool ClockWatch::goes_forward() const noexcept {
  std::size_t back = 0;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    back += times_[i] < times_[i - 1] ? 1U : 0U;
  }
  return dates_ > 0 ||
         static_cast<double>(back) <= kMostStepsBack * static_cast<double>(times_.size());
}

void ClockWatch::report_steps(double scale, DiagnosticGroups& problems) const {
  std::size_t equal = 0;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    const double step_s = scale * (times_[i] - times_[i - 1]);
    const auto add = [&](Severity severity, std::string found, std::string expectation) {
      problems.add(
          {severity, file_, lines_[i], column_, std::move(found), std::move(expectation), 1});
    };
    equal += step_s == 0.0 ? 1U : 0U;
    if (!(step_s > 0.0)) {
      add(Severity::error,
          number_text(times_[i]) + " after " + number_text(times_[i - 1]),
          "times that increase");
    } else if (step_s > max_gap_s_) {
      add(Severity::warning,
          "a gap of " + number_text(step_s) + " s",
          "steps of at most " + number_text(max_gap_s_) + " s");
    }
  }
  if (static_cast<double>(equal) > kMostEqualSteps * static_cast<double>(times_.size())) {
    problems.add({Severity::warning,
                  file_,
                  0,
                  column_,
                  std::to_string(equal) + " rows that share the time of the row before",
                  "a time of its own for each row; is there a column of nanoseconds?",
                  1});
  }
}

std::string ClockWatch::unit_in_words(const TimeUnitGuess& guess) const {
  if (dates_ > 0) {
    return "dates";
  }
  return clock_.nanoseconds ? "s and ns" : std::string(name_of(guess.unit));
}

std::optional<ClockCheck> ClockWatch::finish(DiagnosticGroups& problems) const {
  const bool has_own_unit = dates_ > 0 || clock_.nanoseconds.has_value();
  const TimeUnitGuess guess =
      has_own_unit ? TimeUnitGuess{} : guess_time_unit(clock_.named_unit, times_);
  const double scale = seconds_in(guess.unit);
  report_steps(scale, problems);
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < times_.size(); ++i) {
    const double step_s = scale * (times_[i] - times_[i - 1]);
    if (step_s > 0.0) {
      steps_s.push_back(step_s);
    }
  }
  if (steps_s.empty()) {
    return std::nullopt;
  }
  std::ranges::sort(steps_s);
  if (guess.unit != TimeUnit::seconds || dates_ > 0) {
    problems.add({Severity::note,
                  file_,
                  0,
                  column_,
                  dates_ > 0 ? "dates"
                             : "times in " + std::string(name_of(guess.unit)) +
                                   (guess.reason.empty() ? "" : ": " + guess.reason),
                  "seconds in a bundle; 'import log' converts them: see 'help map'",
                  1});
  }
  return ClockCheck{column_,
                    unit_in_words(guess),
                    scale * times_.front(),
                    scale * times_.back(),
                    1.0 / share_of_sorted(steps_s, 0.95),
                    1.0 / share_of_sorted(steps_s, 0.50),
                    1.0 / share_of_sorted(steps_s, 0.05),
                    steps_s.back()};
}

}  // namespace tcert::table
