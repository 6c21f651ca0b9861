#include "datasets/import/bag_metadata.hpp"

#include <algorithm>
#include <compare>

namespace tcert::recording {
namespace {

constexpr std::string_view kYamlBlanks = " \t\r";
constexpr std::size_t kMostFiles = 4096;

std::string_view bare(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(kYamlBlanks);
  return first == std::string_view::npos
             ? std::string_view{}
             : text.substr(first, text.find_last_not_of(kYamlBlanks) + 1 - first);
}

std::string_view unquoted(std::string_view text) noexcept {
  text = bare(text);
  const bool is_quoted = text.size() >= 2 && text.front() == text.back() &&
                         (text.front() == '\'' || text.front() == '"');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

std::string_view next_line(std::string_view& text) noexcept {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::vector<std::string> in_brackets(std::string_view list) {
  std::vector<std::string> names;
  list = list.substr(1, list.find(']') - 1);
  while (!list.empty() && names.size() < kMostFiles) {
    const std::size_t comma = std::min(list.find(','), list.size());
    names.emplace_back(unquoted(list.substr(0, comma)));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return names;
}

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// Takes the digits at the front of `text`, without zeros before them.
std::string_view take_digits(std::string_view& text) noexcept {
  const auto end =
      static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

}  // namespace

std::vector<std::string> relative_file_paths(std::string_view yaml) {
  constexpr std::string_view kKey = "relative_file_paths:";
  std::vector<std::string> names;
  while (!yaml.empty()) {
    const std::string_view line = bare(next_line(yaml));
    if (!line.starts_with(kKey)) {
      continue;
    }
    if (const std::string_view rest = bare(line.substr(kKey.size())); rest.starts_with('[')) {
      return in_brackets(rest);
    }
    while (!yaml.empty() && names.size() < kMostFiles) {
      const std::string_view entry = bare(next_line(yaml));
      if (entry.empty() || entry.front() == '#') {
        continue;
      }
      if (entry.front() != '-') {
        return names;
      }
      names.emplace_back(unquoted(entry.substr(1)));
    }
    return names;
  }
  return names;
}

bool counts_before(std::string_view a, std::string_view b) noexcept {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view left = take_digits(a);
      const std::string_view right = take_digits(b);
      if (left.size() != right.size() || left != right) {
        return left.size() != right.size() ? left.size() < right.size() : left < right;
      }
    } else if (a.front() != b.front()) {
      return a.front() < b.front();
    } else {
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() != b.size() ? a.size() < b.size() : whole_a < whole_b;
}

}  // namespace tcert::recording
