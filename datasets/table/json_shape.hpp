#pragma once
/// \file
/// How deep a JSON document may be nested, and how many keys an object of it may have: readers
/// recurse, and a stack has an end; they look for each key among those before it.

#include <cstddef>
#include <string_view>

namespace tcert::table {

inline constexpr std::size_t kDeepestJson = 64;
inline constexpr std::size_t kMostJsonKeys = 4096;

inline constexpr std::string_view kNestedTooDeeply = "nested too deeply: more than 64 levels";
inline constexpr std::string_view kTooManyKeys = "an object with more than 4096 keys";

/// One of the two above if arrays and objects of `text` are open more than kDeepestJson deep
/// anywhere, or an object has more than kMostJsonKeys keys, whether or not it is JSON otherwise;
/// else empty. To be asked before a document is parsed. O(bytes).
[[nodiscard]] std::string_view json_shape_problem(std::string_view text) noexcept;

}  // namespace tcert::table
