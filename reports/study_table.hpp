#pragma once
/// \file
/// The tables of a study: Table 1, commanded speed, and every cell of algorithm and lighting.

#include <string>
#include <vector>

#include "analysis/study/trials/study_tables.hpp"
#include "reports/table.hpp"

namespace tcert {

/// `table1` in the paper's shape; `speed`: median commanded speed by algorithm and by lighting,
/// with latency in one line below; `study_cells`: every cell in a row of its own. What the paper
/// prints stands beside trials of its algorithms alone.
[[nodiscard]] std::vector<Table> study_tables(const study::StudyRecord& study);

/// "Policy-loop latency: median 19.6 ms; 19.5 to 19.7 over the 18 cells."; empty if no latency was
/// logged.
[[nodiscard]] std::string latency_line(const study::StudyRecord& study);

}  // namespace tcert
