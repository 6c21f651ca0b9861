#include "reports/terrain/raster_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

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

/// Least and largest value; none without one.
[[nodiscard]] std::optional<RasterRange> range_of(const std::vector<double>& values) {
  std::optional<RasterRange> range;
  for (const double v : values) {
    if (std::isfinite(v)) {
      range = range ? std::pair(std::min(range->first, v), std::max(range->second, v))
                    : std::pair(v, v);
    }
  }
  return range;
}

using Pixel = std::array<std::uint8_t, 4>;

[[nodiscard]] Pixel pixel_of(double value, const RasterRange& range) {
  Pixel pixel{};
  if (std::isfinite(value)) {
    const double span = range.second - range.first;
    const Colour c = colour_of(span > 0.0 ? (value - range.first) / span : 1.0);
    for (std::size_t k = 0; k < c.size(); ++k) {
      pixel[k] = static_cast<std::uint8_t>(std::lround(c[k]));
    }
    pixel[3] = 255;
  }
  return pixel;
}

[[nodiscard]] Pixel pixel_of(std::uint32_t colour) {
  return {static_cast<std::uint8_t>(colour >> 16U),
          static_cast<std::uint8_t>(colour >> 8U & 0xffU),
          static_cast<std::uint8_t>(colour & 0xffU),
          255};
}

}  // namespace

std::string raster_picture(const TerrainGrid& layer,
                           const std::vector<RasterMark>& marks,
                           const std::optional<RasterRange>& range) {
  const RasterRange shown = range ? *range : range_of(layer.values).value_or(RasterRange{});
  const bool is_turned = layer.frame.is_declared && !layer.frame.rows_run_south;
  const int rows = is_turned ? layer.columns : layer.rows;
  const int columns = is_turned ? layer.rows : layer.columns;
  PngImage image{static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), 4, {}};
  image.pixels.reserve(4 * layer.values.size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const terrain::Cell c{is_turned ? column : row, is_turned ? rows - 1 - row : column};
      const auto mark = std::find_if(marks.begin(), marks.end(), [&](const RasterMark& one) {
        return squared_distance(one.at, c) <= 9.0;
      });
      const std::size_t i =
          static_cast<std::size_t>(c.x) * static_cast<std::size_t>(layer.columns) +
          static_cast<std::size_t>(c.y);
      const Pixel pixel =
          mark != marks.end() ? pixel_of(mark->colour) : pixel_of(layer.values[i], shown);
      image.pixels.insert(image.pixels.end(), pixel.begin(), pixel.end());
    }
  }
  return png_bytes(image);
}

}  // namespace tcert
