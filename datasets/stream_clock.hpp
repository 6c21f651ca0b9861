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

#include "datasets/clock_faults.hpp"

namespace tcert {

/// What two rows of the same time may be.
enum class EqualTimes {
  in_file_order,  ///< After repair both stay: the later one is the newest sample of its time.
  forbidden,      ///< Times must increase strictly, repaired or not.
};

/// How the rows of one file are put in order.
struct OrderOptions {
  std::string file;
  std::string time_column = "time_s";
  bool repair = false;
  EqualTimes equal_times = EqualTimes::in_file_order;
};

/// Puts the rows in order of time, if they are to be repaired; else says what is wrong and whether
/// --repair would help.
///
/// - A row that is late by less than the gap is sorted in.
/// - What lies after a step of `faults` is set ahead by `shifts`, one a step, in file order: a
///   stretch is never mixed into the one before. Without shifts the file is rejected.
/// - Rows that are equal in every value are merged; others of one time stay in file order. Rejected
///   are stamps of whole seconds of which more than a tenth of the rows share another's.
///
/// Returns the times at which the path breaks since the clock was set back; a counter that began
/// anew breaks nothing. O(rows log rows). \pre `faults` are those of `table.time_ns`.
std::vector<std::int64_t> put_in_order(table::NumberTable& table,
                                       const ClockFaults& faults,
                                       const std::optional<std::vector<std::int64_t>>& shifts,
                                       const OrderOptions& options,
                                       table::DiagnosticGroups& problems);

/// The same of a stream that has its clock to itself.
std::vector<std::int64_t> put_in_order(table::NumberTable& table,
                                       double max_gap_s,
                                       const OrderOptions& options,
                                       table::DiagnosticGroups& problems);

/// What a gap in the clock of a stream means for the path.
enum class PathBreaks {
  here,  ///< It breaks.
  none,  ///< Nothing: the last value is held.
};

struct ClockLimits {
  double max_gap_s = 1.0;
  std::optional<double> trial_limit_s;
  PathBreaks path = PathBreaks::here;
};

/// Times of the rows before which the clock jumps by more than max_gap_s, and of the first row more
/// than ten trial limits after the first; each a warning. Where most steps are longer, one warning
/// names the unit that the times may have. \pre `table` is in order of time.
[[nodiscard]] std::vector<std::int64_t> find_breaks(const table::NumberTable& table,
                                                    const std::string& file,
                                                    const std::string& time_column,
                                                    const ClockLimits& limits,
                                                    table::DiagnosticGroups& problems);

/// Seconds as nanoseconds, rounded to nearest. \pre |seconds| is below 9e9.
[[nodiscard]] std::int64_t to_nanoseconds(double seconds) noexcept;

/// The longest step that breaks nothing; at most the longest time there is.
[[nodiscard]] std::int64_t gap_in_nanoseconds(double max_gap_s) noexcept;

}  // namespace tcert
