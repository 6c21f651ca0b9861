#pragma once
/// \file
/// What the flags of `explore` leave open: of its config file, and of the model that is trusted.

#include "cli/runs/explore.hpp"
#include "cli/runs/terrain_config.hpp"

namespace tcert::cli {

/// Fills what is not given from the config file, and says what of it has no effect.
/// \throws NoInput, UsageError.
void apply_config(ExploreRequest& request, Progress& progress);

/// With --trust-model: the band that it needs unless one was told, and a warning if it is narrower.
void settle_beta(ExploreRequest& request, Progress& progress);

}  // namespace tcert::cli
