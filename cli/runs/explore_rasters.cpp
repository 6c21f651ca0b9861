#include "cli/runs/explore_rasters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/runs/errors.hpp"
#include "datasets/terrain/raster_text.hpp"
#include "reports/terrain/raster_picture.hpp"

namespace tcert::cli {
namespace {

[[nodiscard]] std::vector<double> numbers(const terrain::CellSet& set) {
  return {set.begin(), set.end()};
}

}  // namespace

RasterFormats raster_formats_of(const std::string& text) {
  RasterFormats formats;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string word = text.substr(at, end - at);
    bool* const format = word == "asc"   ? &formats.esri
                         : word == "csv" ? &formats.points
                         : word == "png" ? &formats.png
                                         : nullptr;
    if (format == nullptr) {
      throw UsageError("--rasters: found '" + word + "', expected asc, csv or png, comma between");
    }
    *format = true;
    at = end + 1;
  }
  return formats;
}

void require_writable(const RasterFormats& formats, const TerrainGrid& place) {
  if (formats.esri && !place.frame.is_square()) {
    throw UsageError(
        fmt::format("--rasters asc: the cells are {:g} x {:g}, and an ESRI ASCII grid has square "
                    "ones; take csv or png",
                    place.frame.x_step,
                    place.frame.y_step));
  }
}

void write_rasters(const ResultFolder& folder,
                   const RasterFormats& formats,
                   const TerrainGrid& place,
                   const terrain::Layers& layers) {
  const auto write = [&](const std::string& name,
                         std::vector<double> values,
                         RasterRounding rounding,
                         const std::optional<RasterRange>& range = {}) {
    TerrainGrid layer = place;
    layer.values = std::move(values);
    const std::string path = "rasters/" + name;
    if (formats.esri) {
      folder.write(path + ".asc", esri_raster(layer, rounding));
    }
    if (formats.points) {
      folder.write(path + ".csv", point_raster(layer, rounding));
    }
    if (formats.png) {
      folder.write(path + ".png", raster_picture(layer, {}, range));
    }
  };
  constexpr RasterRange kSet{0.0, 1.0};  // Also of a set that has all cells, or none.
  write("safe", numbers(layers.safe), RasterRounding::nearest, kSet);
  if (layers.standing != layers.safe) {
    write("standing", numbers(layers.standing), RasterRounding::nearest, kSet);
  }
  write("lower", layers.lower, RasterRounding::down);
  write("upper", layers.upper, RasterRounding::up);
  write("mean", layers.mean, RasterRounding::nearest);
  write("sd", layers.sd, RasterRounding::up);
  write("certificate", layers.certificate, RasterRounding::down);
}

void write_terrain_picture(const ResultFolder& folder,
                           TerrainGrid terrain,
                           const terrain::ExploreSetup& setup) {
  constexpr std::uint32_t kStart = 0xff8c00;
  constexpr std::uint32_t kGoal = 0x00007f;
  std::vector<RasterMark> marks{{setup.start, kStart}};
  if (setup.goal) {
    marks.push_back({*setup.goal, kGoal});
  }
  for (const terrain::Cell goal : setup.more_goals) {
    marks.push_back({goal, kGoal});
  }
  folder.write("rasters/terrain.png", raster_picture(terrain, marks));
}

}  // namespace tcert::cli
