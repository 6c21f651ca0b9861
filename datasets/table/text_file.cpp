#include <table/text_file.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace tcert::table {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFDU;

void append_utf8(std::string& out, std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    out += static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80U) {
    out += static_cast<char>(code);
  } else if (code < 0x800U) {
    out += static_cast<char>(0xC0U | (code >> 6U));
    tail(0);
  } else if (code < 0x10000U) {
    out += static_cast<char>(0xE0U | (code >> 12U));
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xF0U | (code >> 18U));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// The text behind a byte-order mark, whose high byte is `high` of each two.
std::string utf8_of_utf16(std::string_view bytes, std::size_t high) {
  std::string out;
  out.reserve(bytes.size());
  const auto unit = [&](std::size_t i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
    return static_cast<std::uint32_t>((byte(i + high) << 8U) | byte(i + 1 - high));
  };
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800U && code < 0xE000U) {
      const bool leads = code < 0xDC00U && i + 3 < bytes.size();
      const std::uint32_t next = leads ? unit(i + 2) : 0U;
      if (next >= 0xDC00U && next < 0xE000U) {
        code = 0x10000U + ((code - 0xD800U) << 10U) + (next - 0xDC00U);
        i += 2;
      } else {
        code = kReplacement;
      }
    }
    append_utf8(out, code);
  }
  return out;
}

}  // namespace

Bytes as_text(Bytes bytes) {
  const std::string_view view = bytes.view();
  if (view.starts_with("\xFF\xFE")) {
    bytes = Bytes::copy_of(utf8_of_utf16(view, 1));
  } else if (view.starts_with("\xFE\xFF")) {
    bytes = Bytes::copy_of(utf8_of_utf16(view, 0));
  }
  if (bytes.view().find('\n') == std::string_view::npos) {
    std::replace(bytes.data(), bytes.data() + bytes.size(), '\r', '\n');
  }
  return bytes;
}

BytesResult read_text_file(const std::filesystem::path& path) {
  BytesResult result = read_file(path);
  if (result.bytes) {
    result.bytes = as_text(std::move(*result.bytes));
  }
  return result;
}

}  // namespace tcert::table
