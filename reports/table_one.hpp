#pragma once
/// \file
/// Table 1 in the paper's own shape, and the same cells one a row for other programs.

#include "analysis/study/trials/study_tables.hpp"
#include "reports/table.hpp"

namespace tcert {

/// `table1`: a row an algorithm, a column a lighting, in each "52/60 (86.7 %)": successes, trials
/// with a known outcome, share; NA without a trial. Sums over lightings and over algorithms, where
/// there are several.
[[nodiscard]] Table table_one(const study::StudyRecord& study);

/// `study_cells`: a row for each algorithm and lighting, numbers alone: trials, successes, share,
/// pooled medians of commanded speed and of policy-loop latency; the last row is all of them.
[[nodiscard]] Table study_cells_table(const study::StudyRecord& study);

/// What stands for an algorithm or a lighting without a name: "(none)".
[[nodiscard]] std::string shown_group(const std::string& name);

}  // namespace tcert
