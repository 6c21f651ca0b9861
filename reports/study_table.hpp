#pragma once
/// \file
/// The tables of a study beside the paper's: Table 1, commanded speed, latency.

#include <optional>
#include <span>
#include <vector>

#include "analysis/study/trials/study_tables.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Table 1: successes / trials (share) per algorithm and lighting, with sums.
[[nodiscard]] Table success_table(std::span<const study::StudyGroup> cells);

/// Median commanded speed by algorithm and by lighting beside the published one, and latency.
[[nodiscard]] Table speed_table(std::span<const study::StudyGroup> algorithms,
                                std::span<const study::StudyGroup> lightings);

/// Median latency in every cell.
[[nodiscard]] Table latency_table(std::span<const study::StudyGroup> cells);

/// All of them: table1, speed, latency.
[[nodiscard]] std::vector<Table> study_tables(const study::StudyRecord& study);

}  // namespace tcert
