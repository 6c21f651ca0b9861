#pragma once
/// \file
/// "Did you mean": the known name nearest to a misspelt one.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tcert::table {

/// `text` with A-Z in lower case; other bytes as they are.
[[nodiscard]] std::string case_folded(std::string_view text);

/// Name with the fewest single-character edits from `name`, case ignored, if they are at most
/// half as many as the longer has characters or one name holds the other; the first of equals.
/// O(|names| |name|^2) for names of one length; names over 100 bytes have no neighbour.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      std::span<const std::string> names);

}  // namespace tcert::table
