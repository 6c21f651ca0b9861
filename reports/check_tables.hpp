#pragma once
/// \file
/// What a bundle or a CSV file holds, as tables.

#include <span>

#include "datasets/check.hpp"
#include "datasets/check_csv.hpp"
#include "reports/table.hpp"

namespace tcert {

/// One row a trial: duration, distance, ticks, breaks, and the rate of every stream.
[[nodiscard]] Table trials_table(std::span<const TrialSummary> trials);

/// One row a column: its type, what is missing, its range.
[[nodiscard]] Table columns_table(const CsvFileSummary& file);

}  // namespace tcert
