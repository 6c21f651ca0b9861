#include "datasets/printable.hpp"

namespace tcert {
namespace {

void append_code(std::string& out, unsigned char code) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += "\\x";
  out += kHex[code >> 4U];
  out += kHex[code & 0xFU];
}

}  // namespace

std::string without_controls(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (code == 0xC2U && next >= 0x80U && next < 0xA0U) {
      append_code(out, next);
      ++i;
    } else if ((code < 0x20U && code != '\n' && code != '\t') || code == 0x7FU) {
      append_code(out, code);
    } else {
      out += text[i];
    }
  }
  return out;
}

}  // namespace tcert
