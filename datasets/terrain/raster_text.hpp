#pragma once
/// \file
/// A layer of values, one a cell, as a raster that other programs read.

#include <span>
#include <string>

#include "datasets/terrain_file.hpp"

namespace tcert {

/// To which side a value is rounded to the digits that are written: a lower bound stays one.
enum class RasterRounding { nearest, down, up };

/// ESRI ASCII grid: six lines of header, the northernmost row first, -9999 or a smaller number of
/// nines where a value is NaN or infinite. Seven significant digits of the largest value. A frame
/// that is not declared has its corner at the origin and the rows as they are. \pre the frame is
/// square. O(values).
[[nodiscard]] std::string esri_raster(const TerrainGrid& layer, RasterRounding rounding);

/// CSV with columns x, y and value, of which x and y are the map's; NaN and infinite values are
/// left out. Digits as above. O(values).
[[nodiscard]] std::string point_raster(const TerrainGrid& layer, RasterRounding rounding);

}  // namespace tcert
