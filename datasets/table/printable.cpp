#include <table/printable.hpp>

#include <algorithm>
#include <table/utf8.hpp>

namespace tcert::table {
namespace {

/// Of the first two bytes of a longer character: a longer way to write it than needed, half of a
/// pair, or beyond 10FFFF.
bool is_wrong(unsigned char first, unsigned char second) noexcept {
  return (first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU) ||
         (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU);
}

/// Bytes of the UTF-8 character at the front of `text`; 0 if there is none.
std::size_t length_of_character(std::string_view text) noexcept {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80U    ? 1
                             : first < 0xC2U  ? 0
                             : first < 0xE0U  ? 2
                             : first < 0xF0U  ? 3
                             : first <= 0xF4U ? kLongestCharacter
                                              : 0;
  if (length > text.size()) {
    return 0;
  }
  for (std::size_t k = 1; k < length; ++k) {
    if (!continues_character(text[k])) {
      return 0;
    }
  }
  return length > 2 && is_wrong(first, static_cast<unsigned char>(text[1])) ? 0 : length;
}

/// Characters that move the cursor, turn the line round or end it.
bool is_control(std::string_view character) noexcept {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
  if (character.size() == 1) {
    return byte(0) < 0x20U || byte(0) == 0x7FU;
  }
  if (character.size() == 2) {
    return (byte(0) == 0xC2U && byte(1) < 0xA0U) || (byte(0) == 0xD8U && byte(1) == 0x9CU);
  }
  return character.size() == 3 && byte(0) == 0xE2U &&
         ((byte(1) == 0x80U && byte(2) >= 0xA8U && byte(2) <= 0xAEU) ||
          (byte(1) == 0x80U && (byte(2) == 0x8EU || byte(2) == 0x8FU)) ||
          (byte(1) == 0x81U && byte(2) >= 0xA6U && byte(2) <= 0xA9U));
}

void append_escaped(std::string& out, char c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(c);
  switch (c) {
    case '\n':
      out += "\\n";
      break;
    case '\r':
      out += "\\r";
      break;
    case '\t':
      out += "\\t";
      break;
    default:
      out += "\\x";
      out += kHex[code >> 4U];
      out += kHex[code & 0xFU];
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length != 0 && !is_control(character)) {
      out += character;
    } else {
      for (const char c : character) {
        append_escaped(out, c);
      }
    }
    text.remove_prefix(character.size());
  }
  return out;
}

std::string printable_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    out += printable(text.substr(0, end));
    if (end == text.size()) {
      break;
    }
    out += text[end];
    text.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace tcert::table
