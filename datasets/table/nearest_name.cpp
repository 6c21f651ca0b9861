#include <table/nearest_name.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tcert::table {

namespace {

constexpr std::size_t kLongestName = 100;

/// Levenshtein distance, two rows.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

bool holds(std::string_view longer, std::string_view shorter) {
  return shorter.size() >= 3 && longer.find(shorter) != std::string_view::npos;
}

}  // namespace

std::string case_folded(std::string_view text) {
  std::string folded(text);
  for (char& c : folded) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return folded;
}

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> names) {
  if (name.size() > kLongestName) {
    return std::nullopt;
  }
  const std::string wanted = case_folded(name);
  std::optional<std::string> nearest;
  std::size_t fewest = kLongestName + 1;
  for (const std::string& candidate : names) {
    if (candidate.size() > kLongestName) {
      continue;
    }
    const std::string folded = case_folded(candidate);
    const std::size_t distance = edits(wanted, folded);
    const bool is_near = distance * 2 <= std::max(wanted.size(), folded.size()) ||
                         holds(folded, wanted) || holds(wanted, folded);
    if (is_near && distance < fewest) {
      fewest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace tcert::table
