#pragma once
/// \file
/// Bytes of UTF-8.

#include <cstddef>

namespace tcert::table {

inline constexpr std::size_t kLongestCharacter = 4;

/// True of every byte of a character but its first.
[[nodiscard]] inline bool continues_character(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace tcert::table
