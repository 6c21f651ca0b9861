#pragma once
/// \file
/// One JSON object without nesting, its numbers as they are written.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::table {

struct FlatMember {
  enum class Kind { number, flag, null, other };
  std::string key;
  Kind kind = Kind::null;
  std::string text;  ///< A number as written, so that no digit is lost; "1" or "0" for a flag.
};

/// Members in the order of the text; empty if it is not exactly one object, or holds a key twice,
/// an array or another object. What Python writes beyond JSON is understood: NaN as null, Infinity
/// and -Infinity as the texts inf and -inf.
[[nodiscard]] std::optional<std::vector<FlatMember>> parse_flat_json(std::string_view text);

}  // namespace tcert::table
