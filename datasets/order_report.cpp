#include "datasets/order_report.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace tcert {
namespace {

table::Severity severity_of(Outlook outlook) noexcept {
  return outlook == Outlook::repaired ? table::Severity::warning : table::Severity::error;
}

/// "times that increase; " and what is done or would be; without it where nothing can be.
std::string expected(std::string wish, Outlook outlook, const std::string& done, const char* way) {
  switch (outlook) {
    case Outlook::repaired:
      return std::move(wish) + "; " + done;
    case Outlook::repairable:
      return std::move(wish) + "; --repair " + way;
    case Outlook::hopeless:
      break;
  }
  return wish;
}

std::string set_back_by(const ClockStep& step) {
  return "the clock set back by " + seconds_text(step.back_ns()) + " s";
}

}  // namespace

void report_no_order(const ClockFaults& faults, ClockReporter& reporter) {
  reporter.add(table::Severity::error,
               faults.steps.front().row,
               fmt::format("{} steps back", faults.steps.size() + faults.late_rows),
               "rows in order of time: sort the file by this column");
}

void report_unplaced_steps(const ClockFaults& faults, ClockReporter& reporter) {
  for (const ClockStep& step : faults.steps) {
    reporter.add(table::Severity::error,
                 step.row,
                 set_back_by(step),
                 "times that increase, or a step alike at the same instant in both pose.csv and "
                 "tactile.csv: what was logged after it cannot be placed");
  }
}

void report_steps(const ClockFaults& faults,
                  std::span<const std::int64_t> shifts,
                  Outlook outlook,
                  ClockReporter& reporter) {
  for (std::size_t k = 0; k < faults.steps.size(); ++k) {
    const ClockStep& step = faults.steps[k];
    const std::int64_t ahead = shifts[k] - (k > 0 ? shifts[k - 1] : 0);
    const std::string wish = step.wrap_ns == 0           ? "times that increase"
                             : step.wrap_ns == kWrapOfMs ? "times that increase: a 32-bit "
                                                           "counter of milliseconds began anew"
                                                         : "times that increase: a 32-bit "
                                                           "counter of microseconds began anew";
    const bool counts_on = step.wrap_ns > 0;
    std::string found = set_back_by(step);
    if (outlook == Outlook::repaired && !counts_on) {
      found += ", set ahead by " + seconds_text(ahead) + " s";
    }
    reporter.add(severity_of(outlook),
                 step.row,
                 std::move(found),
                 counts_on ? expected(wish, outlook, "it is counted on", "counts on")
                           : expected(wish,
                                      outlook,
                                      "the rows from here on are a new segment",
                                      "makes a new segment of the rows from here on"));
  }
}

void report_late_rows(const ClockFaults& faults, Outlook outlook, ClockReporter& reporter) {
  if (faults.late_rows == 0) {
    return;
  }
  const bool repaired = outlook == Outlook::repaired;
  reporter.add(severity_of(outlook),
               faults.first_late,
               repaired ? fmt::format("{} row{} late by up to {} s",
                                      faults.late_rows,
                                      faults.late_rows == 1 ? "" : "s",
                                      seconds_text(faults.latest_ns))
                        : reporter.after(faults.first_late),
               repaired
                   ? "rows in order of time; they are sorted"
                   : expected("a time after that of the row before", outlook, "", "sorts the rows"),
               repaired ? 1 : faults.late_rows);
}

void report_equal_times(const OrderedRows& ordered,
                        Outlook outlook,
                        const OrderOptions& options,
                        table::DiagnosticGroups& problems) {
  if (ordered.merged > 0) {
    problems.add(
        {severity_of(outlook),
         options.file,
         outlook == Outlook::repaired ? 0 : ordered.first_merged_line,
         options.time_column,
         fmt::format("{} row{} equal to another", ordered.merged, ordered.merged == 1 ? "" : "s"),
         expected("each row once", outlook, "exact duplicates are merged", "merges these"),
         1});
  }
  if (ordered.shared == 0) {
    return;
  }
  ClockReporter found(ordered.table, options.file, options.time_column, problems);
  if (ordered.shares_whole_seconds) {
    found.add(
        table::Severity::error,
        ordered.first_shared,
        fmt::format("{} of {} rows with the time of another", ordered.shared, ordered.table.rows()),
        "a time for each row; these are whole seconds: is there a column of nanoseconds, or "
        "of the seconds' fraction?");
    return;
  }
  found.add(severity_of(outlook),
            ordered.first_shared,
            found.after(ordered.first_shared),
            expected("one row for each time",
                     options.equal_times == EqualTimes::forbidden ? Outlook::hopeless : outlook,
                     "these differ in their values and stay in file order",
                     "keeps these, which differ in their values, in file order"),
            ordered.shared);
}

}  // namespace tcert
