#pragma once
/// \file
/// The tables of a study beside the paper's: Table 1, commanded speed, latency.

#include <optional>
#include <span>
#include <vector>

#include "analysis/study/trials/study_tables.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Table 1: successes / trials (share) per algorithm and lighting, with sums; median commanded
/// speed by algorithm and by lighting beside the published one, and latency; median latency in
/// every cell.
[[nodiscard]] std::vector<Table> study_tables(const study::StudyRecord& study);

}  // namespace tcert
