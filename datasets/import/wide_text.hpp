#pragma once
/// \file
/// Text of characters of two or four bytes.

#include <cstdint>
#include <string>
#include <vector>

namespace tcert::recording {

/// The UTF-8 of UTF-16 or UTF-32 units; false, and `out` unspecified, if one is no character.
[[nodiscard]] bool to_utf8(const std::vector<std::uint64_t>& units, std::string& out);

}  // namespace tcert::recording
