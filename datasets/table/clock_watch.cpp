#include <table/clock_watch.hpp>

#include <algorithm>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert::table {
namespace {

/// In a file of unknown columns: the share of steps that may go back before its times are no clock.
constexpr double kMostStepsBack = 0.1;

double share_of_sorted(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

ClockWatch::ClockWatch(std::string file, std::string column, double max_gap_s)
    : file_(std::move(file)), column_(std::move(column)), max_gap_s_(max_gap_s) {}

void ClockWatch::take(double time_s, std::size_t line) {
  if (!last_time_s_) {
    first_time_s_ = time_s;
    last_time_s_ = time_s;
    return;
  }
  const double step_s = time_s - *last_time_s_;
  ++steps_;
  steps_back_ += step_s < 0.0 ? 1U : 0U;
  if (step_s > 0.0) {
    steps_s_.push_back(step_s);
  } else {
    add_problem(Severity::error,
                line,
                number_text(time_s) + " after " + number_text(*last_time_s_),
                "times that increase");
  }
  if (step_s > max_gap_s_) {
    add_problem(Severity::warning,
                line,
                "a gap of " + number_text(step_s) + " s",
                "steps of at most " + number_text(max_gap_s_) + " s");
  }
  last_time_s_ = time_s;
}

bool ClockWatch::goes_forward() const noexcept {
  return static_cast<double>(steps_back_) <= kMostStepsBack * static_cast<double>(steps_);
}

std::optional<ClockCheck> ClockWatch::finish(DiagnosticGroups& problems) {
  for (Diagnostic& problem : problems_.take()) {
    problems.add(std::move(problem));
  }
  if (steps_s_.empty()) {
    return std::nullopt;
  }
  std::ranges::sort(steps_s_);
  return ClockCheck{column_,
                    first_time_s_,
                    *last_time_s_,
                    1.0 / share_of_sorted(steps_s_, 0.95),
                    1.0 / share_of_sorted(steps_s_, 0.50),
                    1.0 / share_of_sorted(steps_s_, 0.05),
                    steps_s_.back()};
}

void ClockWatch::add_problem(Severity severity,
                             std::size_t line,
                             std::string found,
                             std::string expectation) {
  problems_.add({severity, file_, line, column_, std::move(found), std::move(expectation), 1});
}

}  // namespace tcert::table
