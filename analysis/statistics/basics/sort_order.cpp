#include <statistics/basics/sort_order.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace tcert::statistics {
namespace {

constexpr std::size_t kSmall = 512;
constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kPasses = 3;

struct Keyed {
  std::uint32_t key;
  std::uint32_t row;
};

/// Leading half of an unsigned number that orders as the double does.
std::uint32_t leading_bits(double value) noexcept {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
  const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);  // -0 becomes 0
  return static_cast<std::uint32_t>(((bits & kSign) != 0 ? ~bits : bits | kSign) >> 32U);
}

std::size_t digit(std::uint32_t key, std::size_t pass) noexcept {
  return (key >> (kDigitBits * pass)) & (kDigits - 1);
}

void radix_sort(std::vector<Keyed>& keyed) {
  std::array<std::array<std::uint32_t, kDigits>, kPasses> place{};
  for (const Keyed& item : keyed) {
    for (std::size_t pass = 0; pass < kPasses; ++pass) {
      ++place[pass][digit(item.key, pass)];
    }
  }
  std::vector<Keyed> other(keyed.size());
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    auto& start = place[pass];
    if (start[digit(keyed.front().key, pass)] == keyed.size()) {
      continue;
    }
    std::exclusive_scan(start.begin(), start.end(), start.begin(), std::uint32_t{0});
    for (const Keyed& item : keyed) {
      other[start[digit(item.key, pass)]++] = item;
    }
    keyed.swap(other);
  }
}

/// Orders the runs that the leading bits leave equal.
void sort_runs(const std::vector<Keyed>& keyed,
               std::span<const double> values,
               std::vector<std::uint32_t>& order) {
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return values[a] < values[b]; };
  for (std::size_t first = 0; first < keyed.size();) {
    std::size_t last = first + 1;
    while (last < keyed.size() && keyed[last].key == keyed[first].key) {
      ++last;
    }
    if (last - first > 1) {
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(last);
      if (!std::is_sorted(begin, end, less)) {
        std::stable_sort(begin, end, less);
      }
    }
    first = last;
  }
}

}  // namespace

std::vector<std::uint32_t> sort_order(std::span<const double> values) {
  if (values.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("sort order: too many rows");
  }
  if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) {
    throw std::invalid_argument("sort order: a value is NaN");
  }
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  if (values.size() <= kSmall) {
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return values[a] < values[b];
    });
    return order;
  }
  std::vector<Keyed> keyed(values.size());
  for (std::size_t row = 0; row < values.size(); ++row) {
    keyed[row] = {leading_bits(values[row]), static_cast<std::uint32_t>(row)};
  }
  radix_sort(keyed);
  std::transform(
      keyed.begin(), keyed.end(), order.begin(), [](const Keyed& item) { return item.row; });
  sort_runs(keyed, values, order);
  return order;
}

}  // namespace tcert::statistics
