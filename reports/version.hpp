#pragma once
/// \file
/// Which build of the tool this is.

#include <string_view>

namespace tcert {

[[nodiscard]] std::string_view tool_version() noexcept;

/// Commit that was checked out when the build was configured, or "unknown".
[[nodiscard]] std::string_view tool_commit() noexcept;

}  // namespace tcert
