#pragma once
/// \file
/// Which flags of `explore` act under which rules, and within which bounds.

#include <string>

#include "cli/runs/explore.hpp"

namespace tcert::cli {

/// \throws UsageError for words, cells and values that cannot be, and for flags that the rule set
/// or the motion would not look at: naming both. Says on stderr which flags change nothing here.
void check(const ExploreRequest& options, Progress& progress);

/// \throws UsageError for numbers that are not within their limits: again once they are in cells.
void check_limits(const ExploreRequest& options);

/// The largest slope. \throws UsageError for what is no number within its limit.
[[nodiscard]] double lipschitz_of(const ExploreRequest& options);

/// What the rules take unless it was given.
[[nodiscard]] std::string motion_of(const ExploreRequest& options);
[[nodiscard]] std::string selection_of(const ExploreRequest& options);

}  // namespace tcert::cli
