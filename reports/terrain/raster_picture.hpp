#pragma once
/// \file
/// A layer of a terrain as a picture: pixels are cells.

#include <optional>
#include <string>
#include <terrain/grid.hpp>
#include <utility>
#include <vector>

#include "datasets/terrain_file.hpp"

namespace tcert {

/// A place that is marked.
struct RasterMark {
  terrain::Cell at;
  std::uint32_t colour = 0;  ///< 0xRRGGBB.
};

/// Least and largest value of a layer.
using RasterRange = std::pair<double, double>;

/// PNG with a cell a pixel, oriented as esri_raster() is: dark blue at the least, over green to
/// yellow at the largest value, of the layer or of `range`; transparent where there is none; marks
/// are discs of three cells.
[[nodiscard]] std::string raster_picture(const TerrainGrid& layer,
                                         const std::vector<RasterMark>& marks = {},
                                         const std::optional<RasterRange>& range = {});

}  // namespace tcert
