#pragma once
/// \file
/// A text without its outer blanks.

#include <string_view>

namespace tcert::table {

/// Without blanks, tabs and ends of lines at either end. O(length).
[[nodiscard]] inline std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view kBlanks = " \t\r\n";
  const auto first = text.find_first_not_of(kBlanks);
  const auto last = text.find_last_not_of(kBlanks);
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, last - first + 1);
}

}  // namespace tcert::table
