#include "reports/text_width.hpp"

#include <algorithm>
#include <utility>

namespace tcert {

std::size_t width_of(std::string_view text) noexcept {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::vector<std::string> broken(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    if (!line.empty() && width_of(line) + 1 + width_of(word) > width) {
      lines.push_back(std::exchange(line, {}));
    }
    line += line.empty() ? "" : " ";
    line += word;
    begin = end + 1;
  }
  if (!line.empty()) {
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string wrapped(std::string_view text, std::size_t width) {
  constexpr std::string_view kIndent = "  ";
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (width == 0 || width_of(line) <= width) {
      out += line;
    } else {
      const std::vector<std::string> parts = broken(line, width - kIndent.size());
      for (const std::string& part : parts) {
        out += &part == &parts.front() ? "" : "\n" + std::string(kIndent);
        out += part;
      }
    }
    out += end < text.size() ? "\n" : "";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

}  // namespace tcert
