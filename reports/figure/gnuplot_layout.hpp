#pragma once
/// \file
/// Where the panels of a printed figure lie. Internal to reports/figure.

#include <string>
#include <vector>

#include "reports/figure/figure.hpp"

namespace tcert {

/// Inner box of a panel, in pixels from the lower left of the figure.
struct PanelBox {
  double left = 0.0;
  double bottom = 0.0;
  double width = 0.0;
  double height = 0.0;
};

struct FigureLayout {
  double width = 0.0;
  double height = 0.0;
  std::vector<PanelBox> boxes;  ///< One a panel.
  double title_y = 0.0;         ///< Baseline of the title, from below.
  double key_top = 0.0;         ///< Of the legend.
  int key_columns = 1;
  std::vector<std::string> subtitles;  ///< Lines below the title.
};

inline constexpr double kLineHeight = 17.0;

/// Room for tick labels, titles and the legend by the number of their characters, so that nothing
/// overlaps.
[[nodiscard]] FigureLayout gnuplot_layout(const Figure& figure);

}  // namespace tcert
