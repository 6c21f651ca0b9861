#include "reports/html/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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

bool is_all_missing(std::span<const double> column) {
  return std::all_of(column.begin(), column.end(), [](double v) { return std::isnan(v); });
}

/// The first tick of the bucket without a value: without one a curve would go on over the gap.
void keep_gap(std::span<const double> column,
              std::size_t from,
              std::size_t to,
              std::vector<std::size_t>& kept) {
  for (std::size_t i = from; i < to; ++i) {
    if (std::isnan(column[i])) {
      kept.push_back(i);
      return;
    }
  }
}

/// Ticks on both sides of every gap of every column, `always` with them.
std::vector<std::size_t> with_gap_ends(std::span<const std::span<const double>> columns,
                                       std::span<const std::size_t> always) {
  std::vector<std::size_t> ends(always.begin(), always.end());
  for (const std::span<const double> column : columns) {
    for (std::size_t i = 1; i < column.size(); ++i) {
      if (std::isnan(column[i]) != std::isnan(column[i - 1])) {
        ends.push_back(i - 1);
        ends.push_back(i);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

std::vector<std::size_t> kept_of_buckets(std::size_t rows,
                                         std::span<const std::span<const double>> columns,
                                         std::span<const std::span<const double>> broken,
                                         std::span<const std::size_t> always,
                                         std::size_t buckets) {
  std::vector<std::size_t> kept(always.begin(), always.end());
  kept.push_back(0);
  kept.push_back(rows - 1);
  for (std::size_t b = 0; b < buckets; ++b) {
    for (const std::span<const double> column : columns) {
      keep_extremes(column, b * rows / buckets, (b + 1) * rows / buckets, kept);
    }
    for (const std::span<const double> column : broken) {
      keep_gap(column, b * rows / buckets, (b + 1) * rows / buckets, kept);
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
  std::vector<std::size_t> ends = with_gap_ends(columns, always);
  std::vector<std::span<const double>> broken;
  if (ends.size() <= limit / 2) {
    always = ends;
  } else {
    std::copy_if(columns.begin(), columns.end(), std::back_inserter(broken), [](const auto& one) {
      return !is_all_missing(one);
    });
  }
  // The number of ticks that stay grows with the buckets, if not at every step: the last number of
  // buckets in a bisection that keeps the limit is near enough to the largest.
  std::vector<std::size_t> best = kept_of_buckets(rows, columns, broken, always, 1);
  std::size_t fits = 1;
  std::size_t too_many = rows + 1;
  while (fits + 1 < too_many) {
    const std::size_t middle = fits + (too_many - fits) / 2;
    std::vector<std::size_t> kept = kept_of_buckets(rows, columns, broken, always, middle);
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
