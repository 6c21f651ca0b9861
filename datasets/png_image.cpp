#include "datasets/png_image.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace tcert {
namespace {

/// The simplified interface of libpng; freed whatever happens.
class PngControl {
 public:
  PngControl() {
    std::memset(&image_, 0, sizeof image_);
    image_.version = PNG_IMAGE_VERSION;
  }
  ~PngControl() { png_image_free(&image_); }
  PngControl(const PngControl&) = delete;
  PngControl& operator=(const PngControl&) = delete;
  png_image* operator->() noexcept { return &image_; }
  png_image* get() noexcept { return &image_; }

 private:
  png_image image_{};
};

[[nodiscard]] png_uint_32 format_of(std::size_t channels) {
  switch (channels) {
    case 1:
      return PNG_FORMAT_GRAY;
    case 2:
      return PNG_FORMAT_GA;
    case 3:
      return PNG_FORMAT_RGB;
    default:
      return PNG_FORMAT_RGBA;
  }
}

/// Without the chunks that declare gamma or colour, by which libpng would change the numbers; what
/// is no PNG as it is.
[[nodiscard]] std::string without_colour_spaces(std::string_view bytes) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kAround = 12;  // Length, type and checksum of a chunk.
  constexpr std::array<std::string_view, 4> kSpaces{"gAMA", "cHRM", "sRGB", "iCCP"};
  std::string kept(bytes.substr(0, kSignature));
  std::size_t at = std::min(kSignature, bytes.size());
  while (bytes.size() - at >= kAround) {
    std::size_t length = kAround;
    for (std::size_t k = 0; k < 4; ++k) {
      length += static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + k])) << (24 - 8 * k);
    }
    const std::string_view chunk = bytes.substr(at, length);
    if (std::find(kSpaces.begin(), kSpaces.end(), chunk.substr(4, 4)) == kSpaces.end()) {
      kept += chunk;
    }
    at += chunk.size();
  }
  kept += bytes.substr(at);
  return kept;
}

}  // namespace

std::string png_bytes(const PngImage& image) {
  PngControl png;
  png->width = static_cast<png_uint_32>(image.columns);
  png->height = static_cast<png_uint_32>(image.rows);
  png->format = format_of(image.channels);
  png->flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*png.get());
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(
          png.get(), bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
    return {};
  }
  bytes.resize(size);
  return bytes;
}

PngResult read_png(std::string_view bytes, std::size_t most) {
  PngResult result;
  PngControl png;
  const std::string plain = without_colour_spaces(bytes);
  if (png_image_begin_read_from_memory(png.get(), plain.data(), plain.size()) == 0) {
    result.problem = std::string("a PNG image that is whole: ") + png->message;
    return result;
  }
  if (png->width == 0 || png->height == 0 || png->width > most / png->height) {
    result.problem = "at most " + std::to_string(most) + " pixels";
    return result;
  }
  png->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // Not linear, as libpng takes 16 bits to be.
  png->format = PNG_FORMAT_RGBA;
  result.image = {png->width, png->height, 4, {}};
  result.image.pixels.resize(PNG_IMAGE_SIZE(*png.get()));
  if (png_image_finish_read(png.get(), nullptr, result.image.pixels.data(), 0, nullptr) == 0) {
    result.problem = std::string("a PNG image that is whole: ") + png->message;
    result.image = {};
  }
  return result;
}

}  // namespace tcert
