#include "cli/figure_ink.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>

#include "reports/figure/figure_rows.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/gnuplot_layout.hpp"

namespace tcert::test_support {
namespace {

using Colour = std::array<double, 3>;

Colour colour_of(std::string_view hex) {
  const auto channel = [&](std::size_t at) {
    return static_cast<double>(std::strtol(std::string(hex.substr(at, 2)).c_str(), nullptr, 16));
  };
  return {channel(1), channel(3), channel(5)};
}

Colour colour_of(Tone tone) {
  return colour_of(tone == Tone::ink ? "#222222" : tone == Tone::muted ? "#888888" : "#d0d0d0");
}

/// A place in the layout, in its pixels from the lower left.
struct Place {
  double x = 0.0;
  double y = 0.0;
};

struct Count {
  int samples = 0;
  int own = 0;      ///< Ink of the series' own colour.
  int covered = 0;  ///< Ink of something else that lies on top.
  int bare = 0;     ///< No ink at the very pixel: between dashes.

  [[nodiscard]] double empty() const {
    return samples == 0 ? 0.0 : 1.0 - static_cast<double>(own + covered) / samples;
  }
};

class Ink {
 public:
  Ink(const Picture& picture, double scale) : picture_(picture), scale_(scale) {}

  /// Looks for ink within `reach` pixels of the layout. Without a colour any ink is its own.
  void sample(Place at, double reach, const std::optional<Colour>& colour, Count& count) const {
    bool own = false;
    bool other = false;
    const auto cx = static_cast<int>(std::lround(at.x * scale_));
    const auto cy = static_cast<int>(std::lround(picture_.height - at.y * scale_));
    const auto r = static_cast<int>(std::ceil(reach * scale_));
    for (int y = std::max(0, cy - r); y <= std::min(picture_.height - 1, cy + r); ++y) {
      for (int x = std::max(0, cx - r); x <= std::min(picture_.width - 1, cx + r); ++x) {
        own = own || (colour ? has(x, y, *colour, 0.35) : darkness(x, y) > 60.0);
        other = other || darkness(x, y) > 90.0;
      }
    }
    ++count.samples;
    count.bare += tinted(at, 60.0) ? 0 : 1;
    count.own += own ? 1 : 0;
    count.covered += !own && other ? 1 : 0;
  }

  /// True if the pixel is darker than that: by default the tint of a band.
  [[nodiscard]] bool tinted(Place at, double least = 12.0) const {
    const auto x = static_cast<int>(std::lround(at.x * scale_));
    const auto y = static_cast<int>(std::lround(picture_.height - at.y * scale_));
    return x >= 0 && y >= 0 && x < picture_.width && y < picture_.height && darkness(x, y) > least;
  }

  /// Pixels of nearly this colour for which `where` is true.
  template <class Where>
  [[nodiscard]] int count(const Colour& colour, const Where& where) const {
    int found = 0;
    for (int y = 0; y < picture_.height; ++y) {
      for (int x = 0; x < picture_.width; ++x) {
        if (has(x, y, colour, 0.9) && where(Place{x / scale_, (picture_.height - y) / scale_})) {
          ++found;
        }
      }
    }
    return found;
  }

 private:
  [[nodiscard]] double channel(int x, int y, std::size_t c) const {
    return picture_
        .rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                  static_cast<std::size_t>(x)) +
             c];
  }
  [[nodiscard]] double darkness(int x, int y) const {
    return 255.0 - std::min({channel(x, y, 0), channel(x, y, 1), channel(x, y, 2)});
  }
  /// A mixture of white and at least `share` of the colour.
  [[nodiscard]] bool has(int x, int y, const Colour& colour, double share) const {
    double dot = 0.0;
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      dot += (255.0 - channel(x, y, c)) * (255.0 - colour[c]);
      square += (255.0 - colour[c]) * (255.0 - colour[c]);
    }
    const double mixed = dot / square;
    if (mixed < share || mixed > 1.2) {
      return false;
    }
    double rest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      rest = std::max(rest, std::abs(255.0 - channel(x, y, c) - mixed * (255.0 - colour[c])));
    }
    return rest < 36.0;
  }

  const Picture& picture_;
  double scale_;
};

/// One panel of the picture, with all that is wrong with it.
class PanelCheck {
 public:
  PanelCheck(const Figure& figure, const Panel& panel, const PanelBox& box, const Ink& ink)
      : figure_(figure), panel_(panel), box_(box), ink_(ink) {}

  std::vector<std::string> problems() && {
    for (const Layer& layer : panel_.layers) {
      if (!layer.label.empty()) {
        check(layer, "", class_of(layer.label));
      } else if (!layer.colour.empty() && !figure_.gradient) {
        for (std::size_t i = 0; i < figure_.key.classes.size(); ++i) {
          check(layer, figure_.key.classes[i], i);
        }
      } else {
        check(layer, "", std::nullopt);
      }
    }
    for (const Reference& reference : panel_.references) {
      const double across = reference.vertical ? along(panel_.x, reference.at, box_.width)
                                               : along(panel_.y, reference.at, box_.height);
      Count count;
      if (reference.vertical) {
        line({box_.left + across, box_.bottom},
             {box_.left + across, box_.bottom + box_.height},
             colour_of(reference.strong ? Tone::ink : Tone::muted),
             count);
      } else {
        line({box_.left, box_.bottom + across},
             {box_.left + box_.width, box_.bottom + across},
             colour_of(reference.strong ? Tone::ink : Tone::muted),
             count);
      }
      judge_line("a reference at " + std::to_string(reference.at), count, reference.strong, true);
    }
    return std::move(problems_);
  }

 private:
  [[nodiscard]] std::size_t class_of(const std::string& name) const {
    const auto& classes = figure_.key.classes;
    return static_cast<std::size_t>(std::find(classes.begin(), classes.end(), name) -
                                    classes.begin());
  }

  /// Pixels from the low end of an axis.
  double along(const Axis& axis, double value, double length) {
    if (axis.scale == AxisScale::categories) {
      return value / static_cast<double>(axis.categories.size()) * length;
    }
    if (!axis.low || !axis.high) {
      problems_.push_back("an axis without a range: " + axis.title);
      return 0.0;
    }
    return axis.scale == AxisScale::log
               ? std::log(value / *axis.low) / std::log(*axis.high / *axis.low) * length
               : (value - *axis.low) / (*axis.high - *axis.low) * length;
  }

  double coordinate(const Axis& axis, std::size_t row, const std::string& column, double length) {
    if (axis.scale != AxisScale::categories) {
      return along(axis, number_at(figure_.data, row, column), length);
    }
    const auto& names = axis.categories;
    const auto found = std::find(names.begin(), names.end(), text_at(figure_.data, row, column));
    return along(axis, static_cast<double>(found - names.begin()) + 0.5, length);
  }

  Place place(std::size_t row, const std::string& x, const std::string& y) {
    return {box_.left + coordinate(panel_.x, row, x, box_.width),
            box_.bottom + coordinate(panel_.y, row, y, box_.height)};
  }

  [[nodiscard]] bool inside(Place at) const {
    return at.x >= box_.left - 0.5 && at.x <= box_.left + box_.width + 0.5 &&
           at.y >= box_.bottom - 0.5 && at.y <= box_.bottom + box_.height + 0.5;
  }

  /// A sample for each pixel of the way.
  void line(Place from, Place to, const std::optional<Colour>& colour, Count& count) const {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const auto steps = std::max(1, static_cast<int>(std::ceil(length)));
    for (int i = 0; i < steps; ++i) {
      const double share = (i + 0.5) / steps;
      const Place at{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
      if (inside(at)) {
        ink_.sample(at, 1.0, colour, count);
      }
    }
  }

  /// A winding line has its corners in the gaps too: fewer pixels of them are bare.
  void judge_line(const std::string& what, const Count& count, bool dashed, bool straight) {
    if (count.samples < 4) {
      return;
    }
    const double most = dashed ? 0.75 : 0.1;
    if (count.empty() > most || (count.own == 0 && count.covered < count.samples)) {
      say(what, "is not drawn", count);
    } else if (dashed && count.samples > 80 && count.covered * 2 < count.samples &&
               count.bare * (straight ? 10 : 50) < count.samples) {
      say(what, "is not interrupted", count);
    }
  }

  void say(const std::string& what, const std::string& fault, const Count& count) {
    problems_.push_back(figure_.name + ", panel '" + panel_.name + "': " + what + " " + fault +
                        ": of " + std::to_string(count.samples) + " places " +
                        std::to_string(count.own) + " have its ink, " +
                        std::to_string(count.covered) + " are covered, " +
                        std::to_string(count.bare) + " are bare");
  }

  void check(const Layer& layer,
             const std::string& class_name,
             const std::optional<std::size_t>& index) {
    const std::vector<std::size_t> rows = drawn_rows(figure_, panel_, layer, class_name);
    if (rows.empty()) {
      return;
    }
    std::optional<Colour> colour =
        colour_of(layer.mark == Mark::polygon ? Tone::faint : layer.tone);
    if (index) {
      colour = colour_of(class_colour(*index));
    } else if (!layer.colour.empty()) {
      colour.reset();  // Of the gradient.
    }
    const std::string what = "part '" + layer.part + "' " + class_name + layer.label;
    Count count;
    switch (layer.mark) {
      case Mark::line:
      case Mark::step:
        path(layer, class_name, rows, colour, count);
        judge_line(what, count, layer.guide || (index && *index % 6 != 0), layer.guide);
        return;
      case Mark::segment:
      case Mark::range_x:
      case Mark::range_y:
        for (const std::size_t row : rows) {
          line(place(row, layer.x, layer.y),
               place(row,
                     layer.x2.empty() ? layer.x : layer.x2,
                     layer.y2.empty() ? layer.y : layer.y2),
               colour,
               count);
        }
        judge_line(what, count, false, true);
        return;
      case Mark::polygon:
        outlines(layer, rows, colour, count);
        judge_line(what, count, false, true);
        return;
      case Mark::band:
        band(layer, rows, count);
        break;
      case Mark::point:
      case Mark::text:
        for (const std::size_t row : rows) {
          const Place at = place(row, layer.x, layer.y);
          if (inside(at)) {
            ink_.sample(
                at, layer.mark == Mark::text ? 12.0 : 2.0 + 4.0 * layer.size, colour, count);
          }
        }
        break;
    }
    if (count.empty() > 0.05 || (count.own == 0 && count.covered < count.samples)) {
      say(what, "is not drawn", count);
    }
  }

  void path(const Layer& layer,
            const std::string& class_name,
            const std::vector<std::size_t>& rows,
            const std::optional<Colour>& colour,
            Count& count) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      // Rows of this very line between them have a value missing: a gap that is meant.
      bool joined = true;
      for (std::size_t row = rows[i - 1] + 1; row < rows[i]; ++row) {
        joined = joined && !is_of(figure_, panel_, layer, row, class_name);
      }
      if (!joined) {
        continue;
      }
      const Place from = place(rows[i - 1], layer.x, layer.y);
      const Place to = place(rows[i], layer.x, layer.y);
      const Place corner = layer.mark == Mark::step ? Place{to.x, from.y} : to;
      line(from, corner, colour, count);
      line(corner, to, colour, count);
    }
  }

  void outlines(const Layer& layer,
                const std::vector<std::size_t>& rows,
                const std::optional<Colour>& colour,
                Count& count) {
    std::map<std::string, std::vector<Place>> corners;
    for (const std::size_t row : rows) {
      corners[text_at(figure_.data, row, layer.group)].push_back(place(row, layer.x, layer.y));
    }
    for (const auto& [name, ring] : corners) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        line(ring[i], ring[(i + 1) % ring.size()], colour, count);
      }
    }
  }

  void band(const Layer& layer, const std::vector<std::size_t>& rows, Count& count) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const Place low[] = {place(rows[i - 1], layer.x, layer.y), place(rows[i], layer.x, layer.y)};
      const Place high[] = {place(rows[i - 1], layer.x, layer.y2),
                            place(rows[i], layer.x, layer.y2)};
      const Place at{(low[0].x + low[1].x) / 2.0,
                     (low[0].y + low[1].y + high[0].y + high[1].y) / 4.0};
      if (low[1].x - low[0].x >= 2.0 && high[0].y - low[0].y >= 4.0 && inside(at)) {
        ++count.samples;
        count.own += ink_.tinted(at) ? 1 : 0;
      }
    }
  }

  const Figure& figure_;
  const Panel& panel_;
  const PanelBox& box_;
  const Ink& ink_;
  std::vector<std::string> problems_;
};

bool near_a_panel(const FigureLayout& layout, Place at) {
  constexpr double kMark = 14.0;  // Half of the largest mark.
  return std::any_of(layout.boxes.begin(), layout.boxes.end(), [&](const PanelBox& box) {
    return at.x >= box.left - kMark && at.x <= box.left + box.width + kMark &&
           at.y >= box.bottom - kMark && at.y <= box.bottom + box.height + kMark;
  });
}

}  // namespace

Picture read_ppm(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  Picture picture;
  int most = 0;
  file >> kind >> picture.width >> picture.height >> most;
  file.get();
  if (!file || kind != "P6" || most != 255 || picture.width <= 0 || picture.height <= 0) {
    throw std::runtime_error("'" + path.string() + "' is no picture of the form P6");
  }
  picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) *
                     static_cast<std::size_t>(picture.height));
  file.read(reinterpret_cast<char*>(picture.rgb.data()),
            static_cast<std::streamsize>(picture.rgb.size()));
  if (!file) {
    throw std::runtime_error("'" + path.string() + "' ends early");
  }
  return picture;
}

std::vector<std::string> ink_problems(const Figure& figure, const Picture& picture, double scale) {
  std::vector<std::string> problems;
  const FigureLayout layout = gnuplot_layout(figure);
  if (std::abs(picture.width - scale * layout.width) > 2.0 ||
      std::abs(picture.height - scale * layout.height) > 2.0) {
    return {figure.name + ": the picture has another size than the layout"};
  }
  const Ink ink(picture, scale);
  double top = 0.0;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    std::vector<std::string> found =
        PanelCheck(figure, figure.panels[p], layout.boxes[p], ink).problems();
    problems.insert(problems.end(), found.begin(), found.end());
    top = std::max(top, layout.boxes[p].bottom + layout.boxes[p].height);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(6, figure.key.classes.size()); ++i) {
    const int outside = ink.count(colour_of(class_colour(i)), [&](Place at) {
      return at.y < top && !near_a_panel(layout, at);  // Above them is the legend.
    });
    if (outside > 0 && !figure.gradient) {
      problems.push_back(figure.name + ": " + std::to_string(outside) +
                         " pixels of the colour of '" + figure.key.classes[i] +
                         "' outside of every panel");
    }
  }
  return problems;
}

}  // namespace tcert::test_support
