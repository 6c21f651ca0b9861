#pragma once
/// \file
/// How an exploration ended, in words and as an exit code.

#include <string>
#include <terrain/explore.hpp>

#include "cli/runs/errors.hpp"

namespace tcert::cli {

/// 0 at the goal, or when there is none and all is explored; of the others each kind has its own.
[[nodiscard]] ExitCode exit_code_of(terrain::End end) noexcept;

/// Lines "name: value", the end and what stands in the way first. `cell_m`: metres a cell, for the
/// way; 0: cells alone.
[[nodiscard]] std::string explore_summary(const terrain::ExploreResult& result,
                                          const terrain::ExploreSetup& setup,
                                          double cell_m);

}  // namespace tcert::cli
