#pragma once
/// \file
/// Text from files, fit for a terminal.

#include <string>
#include <string_view>

namespace tcert {

/// `text` without what a terminal would obey: control characters other than line feed and tab are
/// escaped (\\x1b), those that UTF-8 writes with two bytes (U+0080 to U+009F) too.
[[nodiscard]] std::string without_controls(std::string_view text);

}  // namespace tcert
