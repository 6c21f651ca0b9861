#include <algorithm>
#include <charconv>
#include <system_error>

#include "datasets/import/value.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kMostSteps = 64;

/// Takes "[INDEX]" off the front of `text`.
std::optional<std::size_t> take_index(std::string_view& text) {
  const std::size_t close = text.find(']');
  if (close == std::string_view::npos || close < 2) {
    return std::nullopt;
  }
  std::size_t index = 0;
  const char* end = text.data() + close;
  const auto [stop, error] = std::from_chars(text.data() + 1, end, index);
  if (error != std::errc{} || stop != end) {
    return std::nullopt;
  }
  text.remove_prefix(close + 1);
  return index;
}

}  // namespace

std::optional<FieldPath> field_path(std::string_view text) {
  FieldPath path;
  bool name_expected = true;
  while (!text.empty() || name_expected) {
    if (path.steps.size() == kMostSteps) {
      return std::nullopt;
    }
    if (name_expected) {
      const std::string_view name = text.substr(0, text.find_first_of(".[]"));
      if (name.empty()) {
        return std::nullopt;
      }
      path.steps.push_back({std::string(name), std::nullopt});
      text.remove_prefix(name.size());
      name_expected = false;
    } else if (text.front() == '[') {
      const auto index = take_index(text);
      if (!index) {
        return std::nullopt;
      }
      path.steps.push_back({{}, index});
    } else if (text.front() == '.') {
      text.remove_prefix(1);
      name_expected = true;
    } else {
      return std::nullopt;
    }
  }
  return path;
}

}  // namespace tcert::recording
