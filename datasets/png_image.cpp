#include "datasets/png_image.hpp"

#include <png.h>

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

PngResult read_grey_png(std::string_view bytes, std::size_t most) {
  PngResult result;
  PngControl png;
  if (png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size()) == 0) {
    result.problem = std::string("a PNG image that is whole: ") + png->message;
    return result;
  }
  if (png->width == 0 || png->height == 0 || png->width > most / png->height) {
    result.problem = "at most " + std::to_string(most) + " pixels";
    return result;
  }
  png->format = PNG_FORMAT_GA;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(*png.get()));
  if (png_image_finish_read(png.get(), nullptr, pixels.data(), 0, nullptr) == 0) {
    result.problem = std::string("a PNG image that is whole: ") + png->message;
    return result;
  }
  result.image = {png->width, png->height, 1, {}};
  result.image.pixels.reserve(pixels.size() / 2);
  for (std::size_t i = 0; i < pixels.size(); i += 2) {
    result.image.pixels.push_back(pixels[i]);
  }
  return result;
}

}  // namespace tcert
