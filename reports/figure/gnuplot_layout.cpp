#include "reports/figure/gnuplot_layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reports/figure/figure_rows.hpp"
#include "reports/text_width.hpp"

namespace tcert {
namespace {

constexpr double kCharacter = 7.4;  // Pixels of a character at 12 px, about.
constexpr double kFigureWidth = 720.0;
constexpr double kPanelHeight = 300.0;
constexpr double kMargin = 14.0;

std::size_t longest(const std::vector<std::string>& texts) {
  std::size_t length = 0;
  for (const std::string& text : texts) {
    length = std::max(length, width_of(text));
  }
  return length;
}

double left_of(const Panel& panel) {
  if (panel.y.hidden) {
    return kMargin;
  }
  const double labels = panel.y.scale == AxisScale::categories
                            ? kCharacter * static_cast<double>(longest(panel.y.categories)) + 12.0
                            : 48.0;
  return kMargin + labels + (panel.y.title.empty() ? 0.0 : 22.0);
}

double below(const Panel& panel) {
  if (panel.x.hidden) {
    return 12.0;
  }
  return 24.0 + (panel.x.title.empty() ? 0.0 : 22.0) + 18.0;
}

double above(const Panel& panel) { return panel.title.empty() ? 8.0 : 30.0; }

std::size_t columns_of(const Figure& figure) {
  return static_cast<std::size_t>(std::max(1, figure.columns));
}

double key_height(const Figure& figure, FigureLayout& layout) {
  const std::vector<std::string> classes = drawn_classes(figure);
  if (classes.empty()) {
    return 0.0;
  }
  const double entry = kCharacter * static_cast<double>(longest(classes)) + 60.0;
  layout.key_columns = std::clamp(static_cast<int>((layout.width - 2.0 * kMargin) / entry),
                                  1,
                                  static_cast<int>(classes.size()));
  const double rows =
      std::ceil(static_cast<double>(classes.size()) / static_cast<double>(layout.key_columns));
  return kLineHeight * rows + 8.0;
}

}  // namespace

FigureLayout gnuplot_layout(const Figure& figure) {
  FigureLayout layout;
  const std::size_t columns = columns_of(figure);
  layout.width = kFigureWidth + (columns > 1 ? 160.0 : 0.0);
  if (figure.synthetic) {
    layout.subtitles =
        broken(to_string(*figure.synthetic), static_cast<std::size_t>(layout.width / kCharacter));
  }
  // From the left: the widest labels of each column of panels.
  double gutter = 0.0;
  for (const Panel& panel : figure.panels) {
    gutter = std::max(gutter, left_of(panel));
  }
  const double right = figure.gradient ? 96.0 : 18.0;
  const double cell = (layout.width - kMargin) / static_cast<double>(columns);
  const double inner = cell - gutter - right;

  // From above: title, legend, rows of panels.
  double y = kMargin + kLineHeight * static_cast<double>(1 + layout.subtitles.size()) + 6.0;
  layout.key_top = y;
  y += key_height(figure, layout);
  for (std::size_t first = 0; first < figure.panels.size(); first += columns) {
    const std::size_t end = std::min(first + columns, figure.panels.size());
    double top = 0.0;
    double height = 0.0;
    double bottom = 0.0;
    for (std::size_t p = first; p < end; ++p) {
      const Panel& panel = figure.panels[p];
      top = std::max(top, above(panel));
      bottom = std::max(bottom, below(panel));
      height = std::max(height,
                        panel.equal_scale ? inner * (*panel.y.high - *panel.y.low) /
                                                (*panel.x.high - *panel.x.low)
                                          : kPanelHeight * panel.height);
    }
    for (std::size_t p = first; p < end; ++p) {
      const double left = static_cast<double>(p - first) * cell + gutter;
      layout.boxes.push_back({left, y + top + height, inner, height});  // Still from above.
    }
    y += top + height + bottom;
  }
  layout.height = std::round(y + 4.0);
  for (PanelBox& box : layout.boxes) {
    box.bottom = layout.height - box.bottom;
  }
  layout.title_y = layout.height - kMargin - 6.0;
  layout.key_top = layout.height - layout.key_top;
  return layout;
}

}  // namespace tcert
