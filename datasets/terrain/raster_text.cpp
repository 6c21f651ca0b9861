#include "datasets/terrain/raster_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tcert {
namespace {

/// Shortest decimals that read back, without an exponent, which not every reader takes.
void append_fixed(std::string& text, double value) {
  std::array<char, 400> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  text.append(digits.data(), end);
}

/// Writes values with a fixed number of decimals, some ten times as fast as the shortest decimals
/// that read back.
class FixedDecimals {
 public:
  FixedDecimals(std::span<const double> values, RasterRounding rounding) : rounding_(rounding) {
    double largest = 0.0;
    for (const double v : values) {
      largest = std::isfinite(v) ? std::max(largest, std::abs(v)) : largest;
    }
    constexpr int kDigits = 7;
    const int before = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) + 1 : 1;
    decimals_ = std::clamp(kDigits - before, 0, kMostDecimals);
    is_small_ = largest < 1e15;
    scale_ = std::pow(10.0, decimals_);
    // Whole values need no decimals.
    is_whole_ = is_small_ && std::all_of(values.begin(), values.end(), [](double v) {
                  return !std::isfinite(v) || v == std::floor(v);
                });
  }

  /// \pre `value` is finite
  void append(std::string& text, double value) const {
    if (!is_small_) {
      append_fixed(text, value);
      return;
    }
    if (is_whole_) {
      append_whole(text, static_cast<std::int64_t>(value));
      return;
    }
    std::int64_t units = rounded(value * scale_);
    if (units < 0) {
      text += '-';
      units = -units;
    }
    const auto scale = static_cast<std::int64_t>(scale_);
    append_whole(text, units / scale);
    if (decimals_ > 0) {
      std::array<char, kMostDecimals> digits{};
      std::int64_t rest = units % scale;
      for (int k = decimals_ - 1; k >= 0; --k) {
        digits[static_cast<std::size_t>(k)] = static_cast<char>('0' + rest % 10);
        rest /= 10;
      }
      text += '.';
      text.append(digits.data(), static_cast<std::size_t>(decimals_));
    }
  }

 private:
  static constexpr int kMostDecimals = 12;

  static void append_whole(std::string& text, std::int64_t value) {
    std::array<char, 24> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end);
  }

  [[nodiscard]] std::int64_t rounded(double units) const {
    switch (rounding_) {
      case RasterRounding::down:
        return static_cast<std::int64_t>(std::floor(units));
      case RasterRounding::up:
        return static_cast<std::int64_t>(std::ceil(units));
      case RasterRounding::nearest:
        break;
    }
    return std::llround(units);
  }

  RasterRounding rounding_;
  int decimals_ = 0;
  double scale_ = 1.0;
  bool is_small_ = true;
  bool is_whole_ = false;
};

/// A value that no cell has, nor is rounded to, for cells without one.
[[nodiscard]] double nodata_of(std::span<const double> values) {
  double low = 0.0;
  for (const double v : values) {
    low = std::isfinite(v) ? std::min(low, v) : low;
  }
  double nodata = -9999.0;
  while (nodata >= low - 1.0) {
    nodata = nodata * 10.0 - 9.0;
  }
  return nodata;
}

}  // namespace

std::string esri_raster(const TerrainGrid& layer, RasterRounding rounding) {
  const MapFrame& frame = layer.frame;
  // Of a list of points x runs east.
  const bool is_turned = frame.is_declared && !frame.rows_run_south;
  const int rows = is_turned ? layer.columns : layer.rows;
  const int columns = is_turned ? layer.rows : layer.columns;
  const double half = 0.5 * frame.x_step;
  const int last = (is_turned ? 0 : layer.rows - 1);
  const double west = frame.is_declared ? frame.first_of(0, 0) - half : 0.0;
  const double south = frame.is_declared ? frame.second_of(last, 0) - half : 0.0;
  const double nodata = nodata_of(layer.values);
  std::string text;
  text.reserve(layer.values.size() * 9 + 200);
  const auto key = [&](const char* name, double value) {
    text += name;
    text += ' ';
    append_fixed(text, value);
    text += '\n';
  };
  key("ncols", columns);
  key("nrows", rows);
  key("xllcorner", west);
  key("yllcorner", south);
  key("cellsize", frame.x_step);
  key("NODATA_value", nodata);
  std::string gap;
  append_fixed(gap, nodata);
  const FixedDecimals format(layer.values, rounding);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int x = is_turned ? column : row;
      const int y = is_turned ? rows - 1 - row : column;
      const double v =
          layer.values[static_cast<std::size_t>(x) * static_cast<std::size_t>(layer.columns) +
                       static_cast<std::size_t>(y)];
      if (std::isfinite(v)) {
        format.append(text, v);
      } else {
        text += gap;
      }
      text += column + 1 == columns ? '\n' : ' ';
    }
  }
  return text;
}

std::string point_raster(const TerrainGrid& layer, RasterRounding rounding) {
  std::string text = "x,y,value\n";
  text.reserve(layer.values.size() * 24);
  const FixedDecimals format(layer.values, rounding);
  std::size_t i = 0;
  for (int x = 0; x < layer.rows; ++x) {
    for (int y = 0; y < layer.columns; ++y, ++i) {
      if (std::isfinite(layer.values[i])) {
        append_fixed(text, layer.frame.first_of(x, y));
        text += ',';
        append_fixed(text, layer.frame.second_of(x, y));
        text += ',';
        format.append(text, layer.values[i]);
        text += '\n';
      }
    }
  }
  return text;
}

}  // namespace tcert
