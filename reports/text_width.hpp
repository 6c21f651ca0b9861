#pragma once
/// \file
/// How wide text is where every character takes one place, and where its lines are broken.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tcert {

/// Characters, not bytes: continuation bytes of UTF-8 take no place of their own.
[[nodiscard]] std::size_t width_of(std::string_view text) noexcept;

/// `text` in lines of at most `width` characters, broken at spaces; a longer word has a line of its
/// own.
[[nodiscard]] std::vector<std::string> broken(std::string_view text, std::size_t width);

/// Every line of `text` likewise; what goes on in another line is indented by two spaces. 0: as it
/// is.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width);

}  // namespace tcert
