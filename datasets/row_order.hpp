#pragma once
/// \file
/// The rows of a stream sorted within the stretches of its clock.

#include <cstddef>
#include <cstdint>
#include <span>
#include <table/csv.hpp>

#include "datasets/clock_faults.hpp"

namespace tcert {

struct OrderedRows {
  table::NumberTable table;           ///< In order of time.
  std::size_t merged = 0;             ///< Rows that equalled another in every value, left out.
  std::size_t first_merged_line = 0;  ///< Of the first of them.
  std::size_t shared = 0;             ///< Rows that have the time of the row before them.
  std::size_t first_shared = 0;       ///< The first of them, in `table`.
  bool shares_whole_seconds = false;  ///< More than a tenth of the rows, and all times are whole.
};

/// Sorts the rows of each stretch by time, those of one time in file order, merges the equal ones,
/// and sets the stretch after step k ahead by `shifts[k]`. O(rows log rows) unless many rows share
/// one time. \pre as many shifts as steps, none of which leads out of the range of times.
[[nodiscard]] OrderedRows ordered_rows(const table::NumberTable& table,
                                       std::span<const ClockStep> steps,
                                       std::span<const std::int64_t> shifts);

}  // namespace tcert
