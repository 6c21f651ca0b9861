#include "datasets/stream_clock.hpp"

#include <algorithm>
#include <cmath>
#include <table/decimal.hpp>
#include <utility>

#include "datasets/clock_steps.hpp"
#include "datasets/order_report.hpp"
#include "datasets/row_order.hpp"

namespace tcert {

namespace {

bool is_hopeless(const OrderedRows& ordered, EqualTimes equal_times) noexcept {
  return ordered.shares_whole_seconds ||
         (ordered.shared > 0 && equal_times == EqualTimes::forbidden);
}

}  // namespace

std::int64_t to_nanoseconds(double seconds) noexcept { return std::llround(seconds * 1e9); }

std::int64_t gap_in_nanoseconds(double max_gap_s) noexcept {
  return to_nanoseconds(std::min(max_gap_s, static_cast<double>(table::kLongestTimeS)));
}

std::vector<std::int64_t> put_in_order(table::NumberTable& table,
                                       const ClockFaults& faults,
                                       const std::optional<std::vector<std::int64_t>>& shifts,
                                       const OrderOptions& options,
                                       table::DiagnosticGroups& problems) {
  if (!faults.any) {
    return {};
  }
  ClockReporter reporter(table, options.file, options.time_column, problems);
  if (faults.is_without_order) {
    report_no_order(faults, reporter);
    return {};
  }
  if (!shifts) {
    report_unplaced_steps(faults, reporter);
    report_late_rows(faults, Outlook::hopeless, reporter);
    return {};
  }
  OrderedRows ordered = ordered_rows(table, faults.steps, *shifts);
  const Outlook outlook = is_hopeless(ordered, options.equal_times) ? Outlook::hopeless
                          : options.repair                          ? Outlook::repaired
                                                                    : Outlook::repairable;
  report_steps(faults, *shifts, outlook, reporter);
  report_late_rows(faults, outlook, reporter);
  report_equal_times(ordered, outlook, options, problems);
  if (outlook != Outlook::repaired) {
    return {};
  }
  std::vector<std::int64_t> breaks;
  for (std::size_t k = 0; k < faults.steps.size(); ++k) {
    if (faults.steps[k].wrap_ns == 0) {
      breaks.push_back(faults.steps[k].first_ns + (*shifts)[k]);
    }
  }
  table = std::move(ordered.table);
  return breaks;
}

std::vector<std::int64_t> put_in_order(table::NumberTable& table,
                                       double max_gap_s,
                                       const OrderOptions& options,
                                       table::DiagnosticGroups& problems) {
  const std::int64_t gap_ns = gap_in_nanoseconds(max_gap_s);
  const ClockFaults faults = find_clock_faults(table.time_ns, gap_ns);
  if (!faults.any) {
    return {};
  }
  const StreamSteps alone{&faults, median_step_ns(table.time_ns)};
  return put_in_order(
      table, faults, shifts_after_steps(std::span(&alone, 1), gap_ns), options, problems);
}

}  // namespace tcert
