#pragma once
/// \file
/// Fewer ticks for a picture, without losing what an eye would see.

#include <cstddef>
#include <span>
#include <vector>

namespace tcert {

/// At most `limit` of `rows` ticks, ascending. The ticks are cut into equal buckets; of each bucket
/// and each column the first tick with the smallest and the first with the largest value stay, so
/// every peak and every dip of every column is there with its value. The first and the last tick
/// and those of `always` stay too, and count towards the limit. All ticks if there are no more than
/// `limit`. Of every gap of NaN in a column the ticks on both sides of its ends stay; where such
/// ticks and `always` are more than half the limit, the first NaN of each bucket, so that every gap
/// that is not beside another in its bucket stays a gap. If `always` alone, or one bucket, is more
/// than the limit, that is what stays. O(rows * columns * log rows). \pre every column has `rows`
/// values; `always` is within them.
[[nodiscard]] std::vector<std::size_t> kept_ticks(std::size_t rows,
                                                  std::span<const std::span<const double>> columns,
                                                  std::span<const std::size_t> always,
                                                  std::size_t limit);

}  // namespace tcert
