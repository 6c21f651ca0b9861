#pragma once
/// \file
/// The layers of an exploration as files of `explore --rasters`.

#include <string>
#include <terrain/explore.hpp>

#include "cli/runs/result_folder.hpp"
#include "datasets/terrain_file.hpp"

namespace tcert::cli {

/// Which formats are written.
struct RasterFormats {
  bool esri = false;
  bool points = false;
  bool png = false;

  [[nodiscard]] bool any() const noexcept { return esri || points || png; }
};

/// "asc,csv,png", any of them; none of an empty text. \throws UsageError.
[[nodiscard]] RasterFormats raster_formats_of(const std::string& text);

/// \throws UsageError for an ESRI ASCII grid of cells that are not square.
void require_writable(const RasterFormats& formats, const TerrainGrid& place);

/// rasters/safe, standing (with a body), lower, upper, mean, sd and certificate, and of PNG also
/// the terrain itself with the start and the goals. `place` is a terrain without values: size and
/// frame.
void write_rasters(const ResultFolder& folder,
                   const RasterFormats& formats,
                   const TerrainGrid& place,
                   const terrain::Layers& layers);

/// rasters/terrain.png: start orange, goals dark blue, as the thesis' Figure 4.1 has them.
void write_terrain_picture(const ResultFolder& folder,
                           TerrainGrid terrain,
                           const terrain::ExploreSetup& setup);

}  // namespace tcert::cli
