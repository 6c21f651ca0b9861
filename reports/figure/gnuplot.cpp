#include "reports/figure/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <table/csv_write.hpp>

#include "reports/figure/figure_table.hpp"
#include "reports/figure/gnuplot_layout.hpp"
#include "reports/figure/gnuplot_plot.hpp"
#include "reports/figure/gnuplot_style.hpp"

namespace tcert {
namespace {

std::string screen(double pixels, double whole) { return fixed(pixels / whole, 6); }

/// A comment line: gnuplot runs what stands behind a newline, and a backslash at the end of a line
/// takes the next one in.
std::string comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return is_control(c) || c == '\\'; }, ' ');
  return "# " + text + "\n";
}

/// One script, three terminals. Points of the PDF are three quarters of a pixel.
std::string terminals(const Figure& figure, const FigureLayout& layout) {
  const std::string pixels = fixed(layout.width, 0) + "," + fixed(layout.height, 0);
  const std::string inches =
      fixed(layout.width / 96.0, 4) + "in," + fixed(layout.height / 96.0, 4) + "in";
  return "form = ARGC > 0 ? ARG1 : 'svg'\n"
         "if (form eq 'pdf') {\n"
         "  set terminal pdfcairo noenhanced size " +
         inches +
         " font 'DejaVu Sans,9' fontscale 0.75 linewidth 1.5 rounded background rgb 'white'\n"
         "} else { if (form eq 'png') {\n"
         "  set terminal pngcairo noenhanced size " +
         pixels +
         " font 'DejaVu Sans,9' linewidth 1 rounded background rgb 'white'\n"
         "} else {\n"
         "  set terminal svg noenhanced size " +
         pixels +
         " font 'DejaVu Sans,12' linewidth 1 rounded background rgb 'white'\n"
         "} }\n"
         "set output " +
         quoted(figure.name + ".") + ".form\n";
}

std::string range_of(const Axis& axis) {
  if (axis.scale == AxisScale::categories) {
    return "[0.5:" + fixed(static_cast<double>(axis.categories.size()) + 0.5, 1) + "]";
  }
  std::string range = "[";
  range += axis.low ? number(*axis.low) : "*";
  range += ":";
  range += axis.high ? number(*axis.high) : "*";
  return range + "]";
}

/// Labels with the same number of decimals, and where they stand.
std::string tick_list(const std::vector<double>& ticks) {
  std::string out;
  for (const double tick : ticks) {
    out +=
        (out.empty() ? "(" : ", ") + quoted(fixed(tick, tick_decimals(ticks))) + " " + number(tick);
  }
  return out + ")";
}

std::string axis_commands(const Axis& axis, const std::string& name) {
  std::string out = "set " + name + "range " + range_of(axis) + "\n";
  out += axis.scale == AxisScale::log ? "set logscale " + name + "\n"
                                      : "unset logscale " + name + "\n";
  if (axis.hidden) {
    return out + "unset " + name + "tics\nunset " + name + "label\n";
  }
  if (axis.scale == AxisScale::categories) {
    out += "set " + name + "tics (";
    for (std::size_t i = 0; i < axis.categories.size(); ++i) {
      out += (i == 0 ? "" : ", ") + quoted(axis.categories[i]) + " " + std::to_string(i + 1);
    }
    out += ") nomirror scale 0\n";
  } else if (!axis.ticks.empty()) {
    out += "set " + name + "tics " + tick_list(axis.ticks) + " nomirror scale 1\n";
  } else {
    out += "set " + name + "tics autofreq nomirror scale 1\n";
  }
  return out + "set " + name + "label " + quoted(axis_title(axis)) + "\n";
}

std::string reference_commands(const Panel& panel) {
  std::string out = "unset arrow\n";
  for (const Reference& reference : panel.references) {
    const std::string at = number(reference.at);
    out +=
        fmt::format(fmt::runtime(reference.vertical
                                     ? "set arrow from first {0}, graph 0 to first {0}, graph 1"
                                     : "set arrow from graph 0, first {0} to graph 1, first {0}"),
                    at);
    out += reference.strong
               ? " nohead back lw 1.2 lc rgb '#222222' dt " + std::string(kGuideDash) + "\n"
               : " nohead back lw 1 lc rgb '#888888'\n";
  }
  return out;
}

std::string box_commands(const PanelBox& box, const FigureLayout& layout) {
  return "set lmargin at screen " + screen(box.left, layout.width) + "\nset rmargin at screen " +
         screen(box.left + box.width, layout.width) + "\nset bmargin at screen " +
         screen(box.bottom, layout.height) + "\nset tmargin at screen " +
         screen(box.bottom + box.height, layout.height) + "\n";
}

std::string gradient_commands(const Gradient& gradient) {
  std::string out = "set palette defined (";
  const std::vector<std::string>& stops = gradient_stops();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    out += (i == 0 ? "" : ", ") + std::to_string(i) + " " + quoted(stops[i]);
  }
  return out + ")\nset cbrange [" + number(gradient.low) + ":" + number(gradient.high) +
         "]\nset cblabel " +
         quoted(gradient.unit.empty() ? gradient.title
                                      : gradient.title + " [" + gradient.unit + "]") +
         "\nset cbtics " + (gradient.ticks.empty() ? "autofreq" : tick_list(gradient.ticks)) +
         "\nset colorbox\n";
}

bool draws_gradient(const Figure& figure, const Panel& panel) {
  if (!figure.gradient) {
    return false;
  }
  return std::ranges::any_of(panel.layers, [](const Layer& layer) {
    return !layer.colour.empty() && layer.label.empty();
  });
}

/// Title, label and legend: a plot of its own over the whole figure, since gnuplot makes a legend
/// no wider than its plot.
std::string head_commands(const Figure& figure, const FigureLayout& layout) {
  std::string out = "set label 1 " + quoted(figure.title) + " at screen " +
                    screen(14.0, layout.width) + ", screen " +
                    screen(layout.title_y, layout.height) +
                    " left font 'DejaVu Sans Bold,' front\n";
  double y = layout.title_y;
  int tag = 2;
  for (const std::string& line : layout.subtitles) {
    y -= kLineHeight;
    out += "set label " + std::to_string(tag++) + " " + quoted(line) + " at screen " +
           screen(14.0, layout.width) + ", screen " + screen(y, layout.height) +
           " left textcolor rgb '#a00000' front\n";
  }
  out += box_commands({14.0, 4.0, layout.width - 28.0, layout.height - 8.0}, layout);
  out += "unset border\nunset tics\nset xrange [0:1]\nset yrange [0:1]\n";
  if (!figure.key.classes.empty()) {
    out += "set key at screen " + screen(14.0, layout.width) + ", screen " +
           screen(layout.key_top, layout.height) +
           " left top Left reverse noautotitle horizontal maxcols " +
           std::to_string(layout.key_columns) + " samplen 3 width 1\n";
  }
  return out + "plot " + key_entries(figure) + "\nunset label\nunset key\n";
}

}  // namespace

std::string gnuplot_script(const Figure& figure) {
  check(figure);
  const FigureLayout layout = gnuplot_layout(figure);
  std::string out = comment(figure.title);
  if (figure.synthetic) {
    out += comment(to_string(*figure.synthetic));
  }
  out += comment("gnuplot -c " + figure.name + ".gp svg|pdf|png reads " + figure.name + ".csv");
  out += terminals(figure, layout);
  out +=
      "set encoding utf8\nset datafile separator ','\nset datafile columnheaders\n"
      "set border 3 lc rgb '#444444'\nset tics textcolor rgb '#222222'\n"
      "unset key\nunset colorbox\nset multiplot\n";
  out += class_functions(figure) + head_commands(figure, layout);
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const Panel& panel = figure.panels[p];
    out += "\n" + comment(panel.title.empty() ? "panel " + std::to_string(p + 1) : panel.title);
    out += "unset object\n";
    out += box_commands(layout.boxes[p], layout);
    out += panel.x.hidden ? "unset border\n" : "set border 3 lc rgb '#444444'\n";
    out += axis_commands(panel.x, "x") + axis_commands(panel.y, "y");
    out += panel.title.empty() ? "unset title\n"
                               : "set title " + quoted(panel.title) + " offset 0,-0.4\n";
    out += reference_commands(panel);
    out += draws_gradient(figure, panel) ? gradient_commands(*figure.gradient) : "unset colorbox\n";
    out += polygon_objects(figure, panel);
    out += plot_command(figure, panel);
  }
  return out + "unset multiplot\nunset output\n";
}

}  // namespace tcert
