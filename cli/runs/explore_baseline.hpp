#pragma once
/// \file
/// `explore --baseline`: what the method is compared with, on the same terrain.

#include "analysis/study/terrain/baselines.hpp"
#include "cli/runs/explore.hpp"

namespace tcert::cli {

/// \pre options.baseline is one of its words. \throws UsageError without exactly one goal, and for
/// obstacles that the method does not know of.
[[nodiscard]] terrain::BaselineResult baseline_walk(const ExploreRequest& options,
                                                    const terrain::Terrain& terrain,
                                                    const terrain::ExploreSetup& places);

/// Lines "name: value".
[[nodiscard]] std::string baseline_summary(const std::string& method,
                                           const terrain::BaselineResult& result);

}  // namespace tcert::cli
