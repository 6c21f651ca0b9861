#pragma once
/// \file
/// What is said of a stream whose rows are not in order of time. Internal to stream_clock.cpp.

#include <cstdint>
#include <span>
#include <table/diagnostic.hpp>

#include "datasets/clock_faults.hpp"
#include "datasets/clock_reporter.hpp"
#include "datasets/row_order.hpp"
#include "datasets/stream_clock.hpp"

namespace tcert {

/// What becomes of a file whose rows are not in order.
enum class Outlook {
  repaired,
  repairable,  ///< By --repair, which was not asked for.
  hopeless,    ///< With or without: then nothing is advised.
};

/// Times in which there is no order at all.
void report_no_order(const ClockFaults& faults, ClockReporter& reporter);

/// Steps that the streams of a trial do not share.
void report_unplaced_steps(const ClockFaults& faults, ClockReporter& reporter);

/// Steps after which the rows are, or would be, set ahead by `shifts`.
void report_steps(const ClockFaults& faults,
                  std::span<const std::int64_t> shifts,
                  Outlook outlook,
                  ClockReporter& reporter);

void report_late_rows(const ClockFaults& faults, Outlook outlook, ClockReporter& reporter);

/// Rows that are equal, and rows of one time that are not.
void report_equal_times(const OrderedRows& ordered,
                        Outlook outlook,
                        const OrderOptions& options,
                        table::DiagnosticGroups& problems);

}  // namespace tcert
