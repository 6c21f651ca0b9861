#include "reports/html/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tcert {
namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

void keep_extremes(std::span<const double> column,
                   std::size_t from,
                   std::size_t to,
                   std::vector<std::size_t>& kept) {
  std::size_t least = kNowhere;
  std::size_t most = kNowhere;
  for (std::size_t i = from; i < to; ++i) {
    if (std::isnan(column[i])) {
      continue;
    }
    if (least == kNowhere || column[i] < column[least]) {
      least = i;
    }
    if (most == kNowhere || column[i] > column[most]) {
      most = i;
    }
  }
  if (least != kNowhere) {
    kept.push_back(least);
    kept.push_back(most);
  }
}

std::vector<std::size_t> kept_of_buckets(std::size_t rows,
                                         std::span<const std::span<const double>> columns,
                                         std::span<const std::size_t> always,
                                         std::size_t buckets) {
  std::vector<std::size_t> kept(always.begin(), always.end());
  kept.push_back(0);
  kept.push_back(rows - 1);
  for (std::size_t b = 0; b < buckets; ++b) {
    for (const std::span<const double> column : columns) {
      keep_extremes(column, b * rows / buckets, (b + 1) * rows / buckets, kept);
    }
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace

std::vector<std::size_t> kept_ticks(std::size_t rows,
                                    std::span<const std::span<const double>> columns,
                                    std::span<const std::size_t> always,
                                    std::size_t limit) {
  if (rows <= limit) {
    std::vector<std::size_t> all(rows);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  // The number of ticks that stay grows with the buckets, if not at every step: the last number of
  // buckets in a bisection that keeps the limit is near enough to the largest.
  std::vector<std::size_t> best = kept_of_buckets(rows, columns, always, 1);
  std::size_t fits = 1;
  std::size_t too_many = rows + 1;
  while (fits + 1 < too_many) {
    const std::size_t middle = fits + (too_many - fits) / 2;
    std::vector<std::size_t> kept = kept_of_buckets(rows, columns, always, middle);
    if (kept.size() <= limit) {
      fits = middle;
      best = std::move(kept);
    } else {
      too_many = middle;
    }
  }
  return best;
}

}  // namespace tcert
