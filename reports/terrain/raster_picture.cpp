#include "reports/terrain/raster_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/png_image.hpp"

namespace tcert {
namespace {

using Colour = std::array<double, 3>;

/// Equal steps of lightness from dark to light, told apart by who sees no red as well.
constexpr std::array<Colour, 5> kRamp{
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

[[nodiscard]] Colour colour_of(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
  const double part = at - static_cast<double>(below);
  Colour colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    colour[k] = kRamp[below][k] + part * (kRamp[below + 1][k] - kRamp[below][k]);
  }
  return colour;
}

}  // namespace

std::string raster_picture(const TerrainGrid& layer, const std::vector<RasterMark>& marks) {
  double low = 0.0;
  double high = 0.0;
  bool any = false;
  for (const double v : layer.values) {
    if (std::isfinite(v)) {
      low = any ? std::min(low, v) : v;
      high = any ? std::max(high, v) : v;
      any = true;
    }
  }
  const bool is_turned = layer.frame.is_declared && !layer.frame.rows_run_south;
  const int rows = is_turned ? layer.columns : layer.rows;
  const int columns = is_turned ? layer.rows : layer.columns;
  PngImage image{static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), 4, {}};
  image.pixels.reserve(4 * layer.values.size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int x = is_turned ? column : row;
      const int y = is_turned ? rows - 1 - row : column;
      const double v =
          layer.values[static_cast<std::size_t>(x) * static_cast<std::size_t>(layer.columns) +
                       static_cast<std::size_t>(y)];
      const auto mark = std::find_if(marks.begin(), marks.end(), [&](const RasterMark& one) {
        return squared_distance(one.at, terrain::Cell{x, y}) <= 9.0;
      });
      std::array<std::uint8_t, 4> pixel{};
      if (mark != marks.end()) {
        pixel = {static_cast<std::uint8_t>(mark->colour >> 16U),
                 static_cast<std::uint8_t>(mark->colour >> 8U & 0xffU),
                 static_cast<std::uint8_t>(mark->colour & 0xffU),
                 255};
      } else if (std::isfinite(v)) {
        const Colour c = colour_of(high > low ? (v - low) / (high - low) : 1.0);
        for (std::size_t k = 0; k < c.size(); ++k) {
          pixel[k] = static_cast<std::uint8_t>(std::lround(c[k]));
        }
        pixel[3] = 255;
      }
      image.pixels.insert(image.pixels.end(), pixel.begin(), pixel.end());
    }
  }
  return png_bytes(image);
}

}  // namespace tcert
