#include "datasets/stream_clock.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert {

namespace {

std::string seconds_text(std::int64_t time_ns) {
  std::string text;
  table::append_seconds(text, time_ns);
  return text;
}

/// The same bits, so that two missing values are equal.
bool equal_rows(const table::NumberTable& table, std::size_t a, std::size_t b) {
  if (table.time_ns[a] != table.time_ns[b]) {
    return false;
  }
  for (std::size_t c = 0; c < table.columns; ++c) {
    if (std::bit_cast<std::uint64_t>(table.at(a, c)) !=
        std::bit_cast<std::uint64_t>(table.at(b, c))) {
      return false;
    }
  }
  return true;
}

/// The rows `order` of `table`, in that order.
table::NumberTable selected(const table::NumberTable& table,
                            const std::vector<std::size_t>& order) {
  table::NumberTable out;
  out.columns = table.columns;
  out.present = table.present;
  for (const std::size_t row : order) {
    out.time_ns.push_back(table.time_ns[row]);
    out.lines.push_back(table.lines[row]);
    const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(row * table.columns);
    out.values.insert(out.values.end(), first, first + static_cast<std::ptrdiff_t>(table.columns));
  }
  return out;
}

/// Drops each row that equals an earlier one of the same time. `order` is sorted by time.
std::vector<std::size_t> without_duplicates(const table::NumberTable& table,
                                            const std::vector<std::size_t>& order) {
  std::vector<std::size_t> kept;
  std::size_t same_time = 0;  // where in `kept` the rows of this time begin
  for (const std::size_t row : order) {
    if (!kept.empty() && table.time_ns[kept.back()] != table.time_ns[row]) {
      same_time = kept.size();
    }
    const auto begin = kept.begin() + static_cast<std::ptrdiff_t>(same_time);
    const bool is_new = std::none_of(
        begin, kept.end(), [&](std::size_t earlier) { return equal_rows(table, earlier, row); });
    if (is_new) {
      kept.push_back(row);
    }
  }
  return kept;
}

/// Reports about the clock of one file.
class ClockReporter {
 public:
  ClockReporter(const table::NumberTable& table,
                const std::string& file,
                const std::string& time_column,
                table::DiagnosticGroups& problems)
      : table_(table), file_(file), time_column_(time_column), problems_(problems) {}

  void add(table::Severity severity,
           std::size_t row,
           std::string value,
           const std::string& expectation) {
    problems_.add(
        {severity, file_, table_.lines[row], time_column_, std::move(value), expectation, 1});
  }

  /// Each row whose time is not after that of the row before it.
  void add_not_increasing(table::Severity severity, const std::string& expectation) {
    for (std::size_t row = 1; row < table_.rows(); ++row) {
      if (table_.time_ns[row] <= table_.time_ns[row - 1]) {
        add(severity,
            row,
            seconds_text(table_.time_ns[row]) + " after " + seconds_text(table_.time_ns[row - 1]),
            expectation);
      }
    }
  }

 private:
  const table::NumberTable& table_;
  const std::string& file_;
  const std::string& time_column_;
  table::DiagnosticGroups& problems_;
};

}  // namespace

std::int64_t to_nanoseconds(double seconds) noexcept { return std::llround(seconds * 1e9); }

void put_in_order(table::NumberTable& table,
                  const std::string& file,
                  const std::string& time_column,
                  bool repair,
                  EqualTimes equal_times,
                  table::DiagnosticGroups& problems) {
  const bool increasing =
      std::ranges::adjacent_find(table.time_ns, std::greater_equal<>{}) == table.time_ns.end();
  if (increasing) {
    return;
  }
  ClockReporter found(table, file, time_column, problems);
  if (!repair) {
    found.add_not_increasing(table::Severity::error,
                             "a time after that of the row before; --repair sorts the rows");
    return;
  }
  found.add_not_increasing(table::Severity::warning,
                           "a time after that of the row before; the rows are sorted");
  std::vector<std::size_t> order(table.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t row) { return table.time_ns[row]; });
  const std::vector<std::size_t> kept = without_duplicates(table, order);
  if (kept.size() < order.size()) {
    problems.add({table::Severity::warning,
                  file,
                  0,
                  time_column,
                  std::to_string(order.size() - kept.size()) + " rows equal to another",
                  "each row once; exact duplicates are merged",
                  1});
  }
  table = selected(table, kept);
  ClockReporter left(table, file, time_column, problems);
  if (equal_times == EqualTimes::forbidden) {
    left.add_not_increasing(table::Severity::error,
                            "one row for each time; these differ in their values");
  } else {
    left.add_not_increasing(
        table::Severity::warning,
        "one row for each time; these differ in their values and stay in file order");
  }
}

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
  bool too_long = false;
  for (std::size_t row = 1; row < table.rows(); ++row) {
    const std::int64_t step = table.time_ns[row] - table.time_ns[row - 1];
    const std::int64_t elapsed = table.time_ns[row] - table.time_ns[0];
    if (static_cast<double>(step) > longest_gap_ns) {
      reporter.add(table::Severity::warning,
                   row,
                   "a step of " + seconds_text(step) + " s",
                   "steps of at most " + gap_text + " s; the path is broken here");
      breaks.push_back(table.time_ns[row]);
    }
    if (!too_long && static_cast<double>(elapsed) > longest_trial_ns) {
      too_long = true;
      reporter.add(table::Severity::warning,
                   row,
                   seconds_text(elapsed) + " s after the first row",
                   "at most ten times the trial limit; the path is broken here");
      breaks.push_back(table.time_ns[row]);
    }
  }
  return breaks;
}

}  // namespace tcert
