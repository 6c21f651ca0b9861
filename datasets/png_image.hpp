#pragma once
/// \file
/// PNG images, by libpng.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tcert {

/// 8 bits a channel, the first row on top.
struct PngImage {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t channels = 1;  ///< 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha.
  std::vector<std::uint8_t> pixels;
};

/// \pre rows x columns x channels pixels, 1 to 4 channels. The same bytes for the same image and
/// library. O(pixels).
[[nodiscard]] std::string png_bytes(const PngImage& image);

struct PngResult {
  PngImage image;
  std::string problem;  ///< Fit to follow "expected "; empty iff the image was read.
};

/// Any PNG as colour and alpha of 8 bits; the numbers of the file, whatever gamma it declares.
/// Refuses images of more than `most` pixels before they are taken into memory.
[[nodiscard]] PngResult read_png(std::string_view bytes, std::size_t most);

}  // namespace tcert
