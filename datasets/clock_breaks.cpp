#include <fmt/format.h>

#include <cstddef>

#include "datasets/clock_reporter.hpp"
#include "datasets/stream_clock.hpp"

namespace tcert {
namespace {

/// What is likely where most steps are longer than the gap.
const char* likely_reason(double median_step_s, double max_gap_s) noexcept {
  constexpr double kLeastFactor = 4.0;
  if (median_step_s < kLeastFactor * max_gap_s) {
    return "raise max_gap_s if the stream is so slow";
  }
  return median_step_s <= 1e3 * max_gap_s
             ? "milliseconds? If the stream is so slow, raise max_gap_s"
         : median_step_s <= 1e6 * max_gap_s
             ? "microseconds? If the stream is so slow, raise max_gap_s"
             : "nanoseconds? If the stream is so slow, raise max_gap_s";
}

}  // namespace

std::vector<std::int64_t> find_breaks(const table::NumberTable& table,
                                      const std::string& file,
                                      const std::string& time_column,
                                      const ClockLimits& limits,
                                      table::DiagnosticGroups& problems) {
  std::vector<std::int64_t> breaks;
  ClockReporter reporter(table, file, time_column, problems);
  const double longest_gap_ns = limits.max_gap_s * 1e9;
  const double longest_trial_ns =
      limits.trial_limit_s ? 1e10 * *limits.trial_limit_s : static_cast<double>(INT64_MAX);
  std::string gap_text;
  table::append_number(gap_text, limits.max_gap_s);
  const bool breaks_path = limits.path == PathBreaks::here;
  const std::string here =
      breaks_path ? "; the path is broken here" : "; the command before is held";
  std::vector<std::size_t> gaps;
  bool too_long = false;
  for (std::size_t row = 1; row < table.rows(); ++row) {
    const std::int64_t step = table.time_ns[row] - table.time_ns[row - 1];
    const std::int64_t elapsed = table.time_ns[row] - table.time_ns[0];
    if (static_cast<double>(step) > longest_gap_ns) {
      gaps.push_back(row);
      breaks.push_back(table.time_ns[row]);
    }
    if (!too_long && static_cast<double>(elapsed) > longest_trial_ns) {
      too_long = true;
      reporter.add(table::Severity::warning,
                   row,
                   seconds_text(elapsed) + " s after the first row",
                   "at most ten times the trial limit" + here);
      breaks.push_back(table.time_ns[row]);
    }
  }
  constexpr std::size_t kSeveral = 4;
  if (gaps.size() >= kSeveral && 2 * gaps.size() >= table.rows()) {
    const double median_s = 1e-9 * static_cast<double>(median_step_ns(table.time_ns));
    reporter.add(table::Severity::warning,
                 gaps.front(),
                 fmt::format("a median step of {:g} s", median_s),
                 fmt::format("seconds, in steps of at most {} s{}: {}",
                             gap_text,
                             breaks_path ? "; the path is broken at each" : "",
                             likely_reason(median_s, limits.max_gap_s)),
                 gaps.size());
    return breaks;
  }
  const std::string limit = fmt::format("steps of at most {} s{}", gap_text, here);
  for (const std::size_t row : gaps) {
    const std::int64_t step = table.time_ns[row] - table.time_ns[row - 1];
    reporter.add(
        table::Severity::warning, row, fmt::format("a step of {} s", seconds_text(step)), limit);
  }
  return breaks;
}

}  // namespace tcert
