#include "analysis/study/trials/tally.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace tcert::study {
namespace {

constexpr std::size_t kFewestPlaces = 1024;

/// Decimals differ in the high bits of their mantissas and, as doubles, in all of the low ones.
std::size_t hash_of(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(bits ^ (bits >> 32U));
}

}  // namespace

Tally::Entry& Tally::place_of(double value) noexcept {
  const std::size_t last = entries_.size() - 1;
  std::size_t i = hash_of(value) & last;
  while (entries_[i].count != 0 && entries_[i].value != value) {
    i = (i + 1) & last;
  }
  return entries_[i];
}

void Tally::grow() {
  std::vector<Entry> before(std::max(kFewestPlaces, 2 * entries_.size()));
  before.swap(entries_);
  for (const Entry& entry : before) {
    if (entry.count != 0) {
      place_of(entry.value) = entry;
    }
  }
}

void Tally::add(double value, std::uint64_t count) {
  if (4 * distinct_ >= entries_.size()) {
    grow();
  }
  Entry& entry = place_of(value);
  distinct_ += entry.count == 0 ? 1 : 0;
  entry.value = value;
  entry.count += count;
  total_ += count;
}

void Tally::add(std::span<const double> samples) {
  for (const double sample : samples) {
    if (!std::isnan(sample)) {
      add(sample + 0.0, 1);
    }
  }
}

void Tally::add(const Tally& other) {
  for (const Entry& entry : other.entries_) {
    if (entry.count != 0) {
      add(entry.value, entry.count);
    }
  }
}

std::optional<double> Tally::median() const {
  if (total_ == 0) {
    return std::nullopt;
  }
  std::vector<Entry> sorted;
  sorted.reserve(distinct_);
  std::ranges::copy_if(
      entries_, std::back_inserter(sorted), [](const Entry& entry) { return entry.count != 0; });
  std::ranges::sort(sorted, {}, &Entry::value);
  // The samples at the 0-based ranks (n - 1) / 2 and n / 2; the same one if n is odd.
  const auto at_rank = [&sorted](std::uint64_t rank) {
    std::uint64_t below = 0;
    const auto found = std::ranges::find_if(
        sorted, [&](const Entry& entry) { return (below += entry.count) > rank; });
    return found->value;
  };
  return std::midpoint(at_rank((total_ - 1) / 2), at_rank(total_ / 2));
}

}  // namespace tcert::study
