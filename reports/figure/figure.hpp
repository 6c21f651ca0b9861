#pragma once
/// \file
/// The one figure model: what is drawn, in terms of the columns of one table. Every form of a
/// figure (Vega-Lite, gnuplot, CSV) is made from the same cells.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

enum class AxisScale { linear, log, categories };

struct Axis {
  std::string title;
  std::string unit;  ///< Printed behind the title; empty for a pure number or a word.
  AxisScale scale = AxisScale::linear;
  std::optional<double> low;   ///< Of the range; empty: as the data have it.
  std::optional<double> high;  ///< The same.
  std::vector<double> ticks;   ///< Where labels stand; empty: as the drawing program has it.
  std::vector<std::string> categories;  ///< Of a scale of categories: from the left, or the bottom.
  bool hidden = false;                  ///< No line, ticks or title.
};

enum class Mark {
  line,     ///< x, y in the order of the rows; a line for each class of `colour`.
  step,     ///< The same, y held until the next x.
  point,    ///< x, y.
  segment,  ///< x, y to x2, y2.
  range_x,  ///< From x to x2 at y.
  range_y,  ///< From y to y2 at x.
  band,     ///< Filled between y and y2 over x.
  polygon,  ///< x, y closed and filled; one for each value of `group`.
  text,     ///< `text` at x, y.
};

/// Marks that join their rows by a line.
[[nodiscard]] constexpr bool is_path(Mark mark) noexcept {
  return mark == Mark::line || mark == Mark::step;
}

/// What a mark looks like where no data decide its colour. Ink and muted follow the page: dark on
/// light or light on dark.
enum class Tone { ink, muted, faint };

/// Rows of the table with this `part` (and of the panel's, if it names any), drawn by one mark. A
/// row in which a column that is drawn is missing is left out, and a line is broken there. Rows of
/// one line stand together in the table: rows of others between them would break it.
struct Layer {
  Mark mark = Mark::point;
  std::string part;
  std::string x;
  std::string y;
  std::string x2;      ///< segment, range_x.
  std::string y2;      ///< segment, range_y, band.
  std::string text;    ///< text.
  std::string group;   ///< polygon: a text column, one value a polygon.
  std::string colour;  ///< A column: class of the figure's key, or number of its gradient.
  std::string label;   ///< One class of the key for the whole layer, in place of `colour`.
  Tone tone = Tone::ink;
  double width = 1.5;   ///< Of lines, in points.
  double size = 1.0;    ///< Of points, relative.
  bool hollow = false;  ///< Points.
  bool guide = false;   ///< Not data but what they are compared with: a dashed line.
  double raise = 0.0;   ///< Texts, in lines above and to the right of their point; 0: upon it.
};

/// A line across a panel at one value of an axis. Not data: a margin, 0, or 1.
struct Reference {
  bool vertical = false;  ///< At a value of x; else of y.
  double at = 0.0;
  bool strong = false;  ///< Drawn dashed in ink; else faint.
};

struct Panel {
  std::string title;
  std::string name;  ///< Only rows whose column `panel` says so; empty: all rows.
  Axis x;
  Axis y;
  std::vector<Layer> layers;
  std::vector<Reference> references;
  bool equal_scale = false;  ///< A metre is as long in x as in y: maps.
  double height = 1.0;       ///< Relative to other panels.
};

/// Classes with a colour, a dash and a shape each, in the order of the Okabe-Ito palette. A legend
/// names those that are drawn.
struct Key {
  std::string title;
  std::vector<std::string> classes;
};

/// A number as a colour, from `low` (dark) to `high` (bright); beyond them as at the ends.
struct Gradient {
  std::string title;
  std::string unit;
  double low = 0.0;
  double high = 1.0;
  std::vector<double> ticks;  ///< Where labels stand; empty: as the drawing program has it.
};

struct Figure {
  std::string name;  ///< snake_case: the file name without its ending.
  std::string title;
  std::string caption;  ///< What is seen, how it was made; for the text below the figure.
  std::optional<SyntheticLabel> synthetic;
  /// Text columns `part` and, where panels name any, `panel`; then the numbers. Full precision.
  Table data;
  std::vector<Panel> panels;
  int columns = 1;  ///< Panels beside each other.
  Key key;
  std::optional<Gradient> gradient;
};

/// Names of a table's columns in its data: an estimate x is x, x_low, x_high.
[[nodiscard]] std::vector<std::string> data_fields(const Table& table);

/// The data of the figure as CSV: what every form of it draws.
[[nodiscard]] std::string figure_csv(const Figure& figure);

/// "Time [s]".
[[nodiscard]] std::string axis_title(const Axis& axis);

/// Okabe & Ito's colours without black and yellow, so that they show on white and on black: told
/// apart by readers with any common colour blindness. Repeats after six.
[[nodiscard]] std::string_view class_colour(std::size_t index) noexcept;

/// Five stops of a gradient that rises in lightness (viridis), dark first.
[[nodiscard]] const std::vector<std::string>& gradient_stops();

/// Decimals that the labels of these ticks need so that all have as many: 0 to 9.
[[nodiscard]] int tick_decimals(const std::vector<double>& ticks) noexcept;

/// \throws std::invalid_argument if a layer names a column or class that is not there, a row has a
/// class or category that is not declared, rows of one line do not stand together, or an axis has
/// no title.
void check(const Figure& figure);

}  // namespace tcert
