#pragma once
/// \file
/// What the figures have in common: their frame, layers, axes, and the last touches. Internal to
/// reports/figure.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/figure/figure.hpp"

namespace tcert {

/// Least and largest of finite values.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) noexcept;
  /// The axis' range, with `room` of the span on both sides; as it is if no value was finite.
  void apply(Axis& axis, double room = 0.05) const;
};

[[nodiscard]] Figure named(const std::string& name,
                           const std::string& title,
                           const std::optional<SyntheticLabel>& synthetic);

[[nodiscard]] Layer layer(Mark mark, const char* part, const char* x, const char* y);
[[nodiscard]] Layer range_x(const char* part, const char* low, const char* high, const char* y);
[[nodiscard]] Layer range_y(const char* part, const char* x, const char* low, const char* high);

/// A dashed line that data are compared with.
[[nodiscard]] Layer guide(const char* part, const char* x, const char* y);

[[nodiscard]] Axis axis(const std::string& title, const std::string& unit = "");

/// From 0 to 1.
[[nodiscard]] Axis share_axis(const std::string& title);

/// Points with their intervals, one a name from the top: VALUE, VALUE_low and VALUE_high of the
/// rows of `part`, by the texts of the column `names`.
[[nodiscard]] Panel interval_panel(const char* part,
                                   const std::string& value,
                                   const char* names,
                                   const std::vector<std::string>& from_the_top);

/// The panels of H1 and H2 in words.
[[nodiscard]] std::string panel_title(const std::string& panel);

/// "TC_early" for tc_early and tc_landmark, and so on; any other column by its name.
[[nodiscard]] std::string predictor_label(const std::string& row);

/// The same of all rows, each once.
[[nodiscard]] std::vector<std::string> predictor_labels(const std::vector<std::string>& rows);

/// The figure as it is drawn: panels without data left out, rows of one line together, texts plain,
/// and even ticks on every axis whose range is known. Empty if nothing but guides would be drawn.
[[nodiscard]] std::optional<Figure> finished(Figure figure);

}  // namespace tcert
