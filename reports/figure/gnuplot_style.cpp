#include "reports/figure/gnuplot_style.hpp"

#include <array>
#include <table/csv_write.hpp>

#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr std::array<std::string_view, 6> kDashes = {
    "solid", "(16,7)", "(6,6)", "(18,6,5,6)", "(28,8)", "(10,5,4,5)"};
constexpr std::array<int, 6> kFilled = {7, 5, 9, 13, 11, 15};
constexpr std::array<int, 6> kHollow = {6, 4, 8, 12, 10, 14};

std::string_view ink(Tone tone) {
  switch (tone) {
    case Tone::ink:
      return "#222222";
    case Tone::muted:
      return "#888888";
    case Tone::faint:
      return "#d0d0d0";
  }
  return "#222222";
}

std::string dash_of(const Layer& layer, std::size_t index) {
  return " dt " + std::string(layer.guide ? kGuideDash : kDashes[index % kDashes.size()]);
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    out += is_control(c) ? std::string(" ")
           : c == '\''   ? std::string("'.\"'\".'")
                         : std::string(1, c);
  }
  out += "'";
  return text.find('\'') == std::string::npos ? out : "(" + out + ")";
}

std::string number(double value) {
  std::string text;
  table::append_number(text, value);
  return text;
}

Look look_of_class(std::size_t index) {
  return {"rgb '" + std::string(class_colour(index)) + "'", index};
}

Look look_of(Tone tone) { return {"rgb '" + std::string(ink(tone)) + "'", 0}; }

std::string style_of(const Layer& layer, const Look& look) {
  const std::string line = " lw " + number(layer.width) + " lc " + look.colour;
  switch (layer.mark) {
    case Mark::line:
      return "with lines" + line + dash_of(layer, look.index);
    case Mark::step:
      return "with steps" + line + dash_of(layer, look.index);
    case Mark::point: {
      const auto& shapes = layer.hollow ? kHollow : kFilled;
      return "with points pt " + std::to_string(shapes[look.index % shapes.size()]) + " ps " +
             number(0.75 * layer.size) + line;
    }
    case Mark::segment:
    case Mark::range_x:
    case Mark::range_y:
      return "with vectors nohead" + line;
    case Mark::band:
      return "with filledcurves lc " + look.colour + " fs transparent solid 0.18 noborder";
    case Mark::text:
      return "with labels" +
             (layer.raise > 0.0 ? std::string(" left offset 0.6,") + number(layer.raise) : "") +
             " textcolor " + look.colour;
    case Mark::polygon:
      break;
  }
  return "";
}

}  // namespace tcert
