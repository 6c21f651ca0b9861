#pragma once
/// \file
/// Whether a picture of a figure shows what the figure has.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/figure/figure.hpp"

namespace tcert::test_support {

/// Pixels, from above; three bytes each.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// A binary PPM file. \throws std::runtime_error if it is none.
[[nodiscard]] Picture read_ppm(const std::filesystem::path& path);

/// What is wrong with the picture, which has `scale` pixels for each of the figure's layout: a
/// line, interval, mark, band or text without ink where its numbers are, a dashed line that is not
/// interrupted, a solid one that is, colours of classes outside of every panel.
[[nodiscard]] std::vector<std::string> ink_problems(const Figure& figure,
                                                    const Picture& picture,
                                                    double scale);

}  // namespace tcert::test_support
