#pragma once
/// \file
/// `hypotheses h3`.

#include "cli/runs/hypotheses.hpp"

namespace tcert::cli {

/// \throws UsageError, BadData, NoInput, WriteError.
[[nodiscard]] ExitCode hypothesis_3(const HypothesesRequest& request, Progress& progress);

}  // namespace tcert::cli
