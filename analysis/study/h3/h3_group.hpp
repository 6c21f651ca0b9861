#pragma once
/// \file
/// H3 under one lighting, or under all of them together.

#include <set>
#include <string>
#include <vector>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "analysis/study/h3/replay_rows.hpp"

namespace tcert::study {

/// Rates, gains, losses and the front of `trials`, whose replays are `rows`. O(replicates trials
/// cases).
[[nodiscard]] H3Group group_of(const ReplayRows& rows,
                               const std::vector<H3Trial>& trials,
                               const std::set<CaseKey>& cases,
                               const H3Options& options,
                               const Watch& watch,
                               const std::string& lighting);

}  // namespace tcert::study
