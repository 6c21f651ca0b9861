#pragma once
/// \file
/// What is to be said of the clock of one file. Internal to the readers of a trial's streams.

#include <cstddef>
#include <string>
#include <table/csv.hpp>
#include <table/csv_write.hpp>
#include <table/diagnostic.hpp>
#include <utility>

namespace tcert {

[[nodiscard]] inline std::string seconds_text(std::int64_t time_ns) {
  std::string text;
  table::append_seconds(text, time_ns);
  return text;
}

/// Reports problems at rows of a table, in the column of its clock. Keeps references.
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
           const std::string& expectation,
           std::size_t count = 1) {
    problems_.add(
        {severity, file_, table_.lines[row], time_column_, std::move(value), expectation, count});
  }

  /// "0.5 after 0.9".
  [[nodiscard]] std::string after(std::size_t row) const {
    return seconds_text(table_.time_ns[row]) + " after " + seconds_text(table_.time_ns[row - 1]);
  }

 private:
  const table::NumberTable& table_;
  const std::string& file_;
  const std::string& time_column_;
  table::DiagnosticGroups& problems_;
};

}  // namespace tcert
