#pragma once
/// \file
/// How deep a JSON document may be nested: readers recurse, and a stack has an end.

#include <cstddef>
#include <string_view>

namespace tcert::table {

inline constexpr std::size_t kDeepestJson = 64;

/// What there is to say of a document that is deeper.
inline constexpr std::string_view kNestedTooDeeply = "nested too deeply: more than 64 levels";

/// True if arrays and objects of `text` are open more than kDeepestJson deep anywhere, whether or
/// not it is JSON otherwise. To be asked before a document is parsed. O(bytes).
[[nodiscard]] bool is_nested_too_deeply(std::string_view text) noexcept;

}  // namespace tcert::table
