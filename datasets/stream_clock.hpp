#pragma once
/// \file
/// The clock of a raw stream: rows in order of time, and where its path breaks.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert {

/// What two rows of the same time may be.
enum class EqualTimes {
  in_file_order,  ///< After repair both stay: the later one is the newest sample of its time.
  forbidden,      ///< Times must increase strictly, repaired or not.
};

/// Times that do not increase are an error. With `repair` the rows are sorted by time, rows of one
/// time in file order, rows that are equal in every value merged; what was done is a counted
/// warning.
void put_in_order(table::NumberTable& table,
                  const std::string& file,
                  const std::string& time_column,
                  bool repair,
                  EqualTimes equal_times,
                  table::DiagnosticGroups& problems);

struct ClockLimits {
  double max_gap_s = 1.0;
  std::optional<double> trial_limit_s;
};

/// Times of the rows before which the clock jumps by more than max_gap_s, and of the first row more
/// than ten trial limits after the first; each a warning. \pre `table` is in order of time.
[[nodiscard]] std::vector<std::int64_t> find_breaks(const table::NumberTable& table,
                                                    const std::string& file,
                                                    const std::string& time_column,
                                                    const ClockLimits& limits,
                                                    table::DiagnosticGroups& problems);

/// Seconds as nanoseconds, rounded to nearest. \pre |seconds| is below 9e9.
[[nodiscard]] std::int64_t to_nanoseconds(double seconds) noexcept;

}  // namespace tcert
