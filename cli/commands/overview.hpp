#pragma once
/// \file
/// What the tool is, as `help` without a topic and the first page of the manual say it.

#include <string>
#include <string_view>

namespace tcert::cli {

inline constexpr std::string_view kToolSummary =
    "traversability certificates from what a robot felt";
inline constexpr std::string_view kToolPurpose =
    "tcert: traversability certificates from what a robot felt, per tick, and what they predict.";
inline constexpr std::string_view kToolExample = "tcert reproduce --output results";

/// The commands, the exit codes, and where there is more.
[[nodiscard]] std::string overview();

}  // namespace tcert::cli
