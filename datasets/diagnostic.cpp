#include "datasets/diagnostic.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tcert {

namespace {

constexpr std::size_t kLongestValue = 40;

std::string_view severity_name(Severity severity) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"note", "warning", "error"};
  return kNames[static_cast<std::size_t>(severity)];
}

constexpr std::size_t kLongestCharacter = 4;

bool continues_character(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
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
  if (length > 2) {
    // Neither a longer way to write a character than needed, nor half of a pair, nor beyond 10FFFF.
    const auto second = static_cast<unsigned char>(text[1]);
    const bool wrong = (first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU) ||
                       (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU);
    return wrong ? 0 : length;
  }
  return length;
}

/// Characters that move the cursor, turn the line round or end it.
bool is_control(std::string_view character) noexcept {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
  if (character.size() == 1) {
    return byte(0) < 0x20U || byte(0) == 0x7FU;
  }
  if (character.size() == 2) {
    return byte(0) == 0xC2U && byte(1) < 0xA0U;
  }
  return character.size() == 3 && byte(0) == 0xE2U &&
         ((byte(1) == 0x80U && byte(2) >= 0xA8U && byte(2) <= 0xAEU) ||
          (byte(1) == 0x81U && byte(2) >= 0xA6U && byte(2) <= 0xA9U));
}

std::string_view cut_between_characters(std::string_view text, std::size_t length) noexcept {
  if (text.size() <= length) {
    return text;
  }
  std::size_t cut = length;
  while (cut > 0 && length - cut < kLongestCharacter && continues_character(text[cut])) {
    --cut;
  }
  return text.substr(0, length - cut < kLongestCharacter ? cut : length);
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

std::string shortened(std::string_view text) {
  const std::string_view kept = cut_between_characters(text, kLongestValue);
  return printable(kept) + (kept.size() < text.size() ? "..." : "");
}

std::string to_string(const Diagnostic& diagnostic) {
  std::string out = diagnostic.file;
  if (diagnostic.line != 0) {
    out += ':' + std::to_string(diagnostic.line);
  }
  out += out.empty() ? "" : ": ";
  out += severity_name(diagnostic.severity);
  out += ": ";
  if (!diagnostic.column.empty()) {
    out += "column '" + diagnostic.column + "': ";
  }
  if (!diagnostic.value.empty()) {
    out += "found '" + diagnostic.value + "', ";
  }
  out += "expected " + diagnostic.expectation;
  if (diagnostic.count > 1) {
    out += " (and " + std::to_string(diagnostic.count - 1) + " more)";
  }
  return out;
}

bool has_error(std::span<const Diagnostic> diagnostics) noexcept {
  return std::ranges::any_of(diagnostics,
                             [](const Diagnostic& d) { return d.severity == Severity::error; });
}

void DiagnosticGroups::add(Diagnostic diagnostic) {
  Kind kind{diagnostic.severity, diagnostic.file, diagnostic.column, diagnostic.expectation};
  const auto [place, is_new] = index_.try_emplace(std::move(kind), groups_.size());
  if (is_new) {
    groups_.push_back(std::move(diagnostic));
  } else {
    groups_[place->second].count += diagnostic.count;
  }
}

std::vector<Diagnostic> DiagnosticGroups::take() {
  index_.clear();
  return std::exchange(groups_, {});
}

}  // namespace tcert
