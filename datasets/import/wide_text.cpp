#include "datasets/import/wide_text.hpp"

namespace tcert::recording {
namespace {

void append_utf8(std::uint32_t code, std::string& out) {
  const auto put = [&out](std::uint32_t byte) {
    out.push_back(static_cast<char>(static_cast<unsigned char>(byte)));
  };
  if (code < 0x80U) {
    put(code);
  } else if (code < 0x800U) {
    put(0xC0U | (code >> 6U));
    put(0x80U | (code & 0x3FU));
  } else if (code < 0x10000U) {
    put(0xE0U | (code >> 12U));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  } else {
    put(0xF0U | (code >> 18U));
    put(0x80U | ((code >> 12U) & 0x3FU));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  }
}

}  // namespace

bool to_utf8(const std::vector<std::uint64_t>& units, std::string& out) {
  out.clear();
  for (std::size_t i = 0; i < units.size(); ++i) {
    auto code = static_cast<std::uint32_t>(units[i]);
    const bool is_high = code >= 0xD800U && code < 0xDC00U;
    if (is_high && i + 1 < units.size() && units[i + 1] >= 0xDC00U && units[i + 1] < 0xE000U) {
      ++i;
      code = 0x10000U + ((code - 0xD800U) << 10U) + static_cast<std::uint32_t>(units[i] - 0xDC00U);
    }
    if (code > 0x10FFFFU || (code >= 0xD800U && code < 0xE000U)) {
      return false;
    }
    append_utf8(code, out);
  }
  return true;
}

}  // namespace tcert::recording
