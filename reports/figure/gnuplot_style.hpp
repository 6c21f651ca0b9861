#pragma once
/// \file
/// How layers look in gnuplot, and texts and numbers in its words. Internal to reports/figure.

#include <cstddef>
#include <string>
#include <string_view>

#include "reports/figure/figure.hpp"

namespace tcert {

/// Of lines that are no data; gaps that the round ends of thin lines leave open in print.
inline constexpr std::string_view kGuideDash = "(7,8)";

/// As a gnuplot string.
[[nodiscard]] std::string quoted(const std::string& text);

/// In shortest round-trip form.
[[nodiscard]] std::string number(double value);

/// How a class, or a layer without one, looks.
struct Look {
  std::string colour = "rgb '#222222'";
  std::size_t index = 0;
};

[[nodiscard]] Look look_of_class(std::size_t index);
[[nodiscard]] Look look_of(Tone tone);

/// "with lines lw 1.8 ..."; empty for a polygon.
[[nodiscard]] std::string style_of(const Layer& layer, const Look& look);

}  // namespace tcert
