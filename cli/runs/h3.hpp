#pragma once
/// \file
/// `hypotheses h3`.

#include "cli/runs/hypotheses.hpp"

namespace tcert::cli {

/// \throws UsageError, BadData, NoInput, WriteError.
[[nodiscard]] RunResult hypothesis_3(const HypothesesRequest& request, Progress& progress);

}  // namespace tcert::cli
