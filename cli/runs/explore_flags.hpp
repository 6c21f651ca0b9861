#pragma once
/// \file
/// Which flags of `explore` act under which rules, and within which bounds.

#include "cli/explore_options.hpp"

namespace tcert::cli {

/// \throws UsageError for words, cells and values that cannot be, and for flags that the rule set
/// or the motion would not look at: naming both. Says on stderr which flags change nothing here.
void check(const ExploreOptions& options, const CommonOptions& common);

/// The largest slope. \throws UsageError for what is no number within its limit.
[[nodiscard]] double lipschitz_of(const ExploreOptions& options);

[[nodiscard]] bool is_given(const CommonOptions& common, std::string_view option);

}  // namespace tcert::cli
