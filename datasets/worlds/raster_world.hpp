#pragma once
/// \file
/// A map of free and occupied cells as a world of rectangles.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

inline constexpr std::size_t kMostRasterCells = 100'000'000;

/// Row-major, the first row at high y.
struct Raster {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<std::uint8_t> occupied;
};

/// Bounds and obstacles. Runs of occupied cells of a row, merged with equal runs of the next row,
/// become rectangles; together they cover the same cells. O(cells).
[[nodiscard]] World raster_world(const Raster& raster, Point low_corner, double cell_m);

}  // namespace tcert
