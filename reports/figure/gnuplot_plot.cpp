#include "reports/figure/gnuplot_plot.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include "reports/figure/figure_rows.hpp"
#include "reports/figure/figure_table.hpp"
#include "reports/figure/gnuplot_style.hpp"

namespace tcert {
namespace {

bool is_line(Mark mark) {
  return is_path(mark) || mark == Mark::segment || mark == Mark::range_x || mark == Mark::range_y;
}

std::size_t panel_index(const Figure& figure, const Panel& panel) {
  return static_cast<std::size_t>(&panel - figure.panels.data());
}

/// A column as a number on its axis.
std::string value_of(const std::string& column,
                     const Axis& axis,
                     const std::string& axis_name,
                     std::size_t panel) {
  if (axis.scale == AxisScale::categories) {
    return axis_name + std::to_string(panel) + "(strcol(" + quoted(column) + "))";
  }
  return "column(" + quoted(column) + ")";
}

/// `strcol('part') eq 'x' && ...`
std::string condition_of(const Panel& panel, const Layer& layer, const std::string& class_name) {
  std::string condition = "strcol('part') eq " + quoted(layer.part);
  if (!panel.name.empty()) {
    condition += " && strcol('panel') eq " + quoted(panel.name);
  }
  if (!class_name.empty()) {
    condition += " && strcol(" + quoted(layer.colour) + ") eq " + quoted(class_name);
  }
  return condition;
}

std::string columns_of(const Figure& figure,
                       const Panel& panel,
                       const Layer& layer,
                       const std::string& condition) {
  const std::size_t p = panel_index(figure, panel);
  const std::string x = value_of(layer.x, panel.x, "px", p);
  const std::string y = value_of(layer.y, panel.y, "py", p);
  // An empty cell would be skipped without breaking a line.
  std::string known = condition;
  for (const std::string* column : {&layer.x, &layer.y, &layer.x2, &layer.y2}) {
    if (!column->empty()) {
      known += " && strcol(" + quoted(*column) + ") ne ''";
    }
  }
  const auto chosen = [&](const std::string& value) {
    return "(" + known + " ? " + value + " : NaN)";
  };
  switch (layer.mark) {
    case Mark::segment:
      return chosen(x) + ":" + chosen(y) + ":" +
             chosen(value_of(layer.x2, panel.x, "px", p) + "-" + x) + ":" +
             chosen(value_of(layer.y2, panel.y, "py", p) + "-" + y);
    case Mark::range_x:
      return chosen(x) + ":" + chosen(y) + ":" +
             chosen(value_of(layer.x2, panel.x, "px", p) + "-" + x) + ":(0)";
    case Mark::range_y:
      return chosen(x) + ":" + chosen(y) +
             ":(0):" + chosen(value_of(layer.y2, panel.y, "py", p) + "-" + y);
    case Mark::band:
      return chosen(x) + ":" + chosen(y) + ":" + chosen(value_of(layer.y2, panel.y, "py", p));
    case Mark::text:
      return chosen(x) + ":" + chosen(y) + ":(strcol(" + quoted(layer.text) + "))";
    default:
      return chosen(x) + ":" + chosen(y);
  }
}

std::string clause(const Figure& figure,
                   const Panel& panel,
                   const Layer& layer,
                   const std::string& class_name,
                   const Look& look) {
  std::string columns = columns_of(figure, panel, layer, condition_of(panel, layer, class_name));
  if (figure.gradient && !layer.colour.empty() && layer.label.empty()) {
    columns += ":(column(" + quoted(layer.colour) + "))";
  }
  return quoted(figure.name + ".csv") + " using " + columns + " " + style_of(layer, look) +
         " notitle";
}

std::size_t class_index(const Figure& figure, const std::string& name) {
  const auto& classes = figure.key.classes;
  return static_cast<std::size_t>(std::find(classes.begin(), classes.end(), name) -
                                  classes.begin());
}

/// The first layer, lines first, that shows the class: its sample in the legend.
const Layer* sample_of(const Figure& figure, const std::string& class_name) {
  const Layer* found = nullptr;
  for (const Panel& panel : figure.panels) {
    for (const Layer& layer : panel.layers) {
      const bool shows = layer.label == class_name ||
                         (layer.label.empty() && !layer.colour.empty() && !figure.gradient);
      if (!shows || layer.mark == Mark::text || layer.mark == Mark::band) {
        continue;
      }
      if (found == nullptr || (layer.mark == Mark::point && is_line(found->mark) &&
                               found->mark != Mark::line && found->mark != Mark::step)) {
        found = &layer;
      }
    }
  }
  return found;
}

std::string key_entry(const Layer& layer, const Look& look, const std::string& name) {
  Layer sample = layer;
  if (is_line(layer.mark)) {
    sample.mark = Mark::line;
  }
  if (layer.mark == Mark::polygon) {
    return "keyentry with boxes fs solid 1 noborder fc " + look.colour + " title " + quoted(name);
  }
  return "keyentry " + style_of(sample, look) + " title " + quoted(name);
}

struct PlottedPolygon {
  std::string vertices;
  std::string first;
};

}  // namespace

// gnuplot reads '' as a quote within quotes, but not '''x': quotes are strings of their own. Double
// quotes round everything would let a back quote run a program.
std::string class_functions(const Figure& figure) {
  std::string out;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const auto add = [&](const Axis& axis, const char* name) {
      if (axis.scale != AxisScale::categories) {
        return;
      }
      out += std::string(name) + std::to_string(p) + "(s) = ";
      for (std::size_t i = 0; i < axis.categories.size(); ++i) {
        out += "s eq " + quoted(axis.categories[i]) + " ? " + std::to_string(i + 1) + " : ";
      }
      out += "NaN\n";
    };
    add(figure.panels[p].x, "px");
    add(figure.panels[p].y, "py");
  }
  return out;
}

std::string polygon_objects(const Figure& figure, const Panel& panel) {
  std::string out;
  int tag = 1;
  for (const Layer& layer : panel.layers) {
    if (layer.mark != Mark::polygon) {
      continue;
    }
    std::vector<std::string> order;
    std::map<std::string, PlottedPolygon> polygons;
    for (const std::size_t row : drawn_rows(figure, panel, layer)) {
      const std::string name = text_at(figure.data, row, layer.group);
      const std::string vertex = number(number_at(figure.data, row, layer.x)) + "," +
                                 number(number_at(figure.data, row, layer.y));
      PlottedPolygon& polygon = polygons[name];
      if (polygon.vertices.empty()) {
        order.push_back(name);
        polygon = {vertex, vertex};
      } else {
        polygon.vertices += " to " + vertex;
      }
    }
    for (const std::string& name : order) {
      out += "set object " + std::to_string(tag++) + " polygon from " + polygons[name].vertices +
             " to " + polygons[name].first +
             " back fc rgb '#d0d0d0' fs solid 1 border lc rgb '#d0d0d0' lw 0.5\n";
    }
  }
  return out;
}

std::string plot_command(const Figure& figure, const Panel& panel) {
  std::vector<std::string> clauses;
  const auto add = [&](const Layer& layer, const std::string& class_name, const Look& look) {
    // gnuplot stops at a plot without a valid point.
    if (!drawn_rows(figure, panel, layer, class_name).empty()) {
      clauses.push_back(clause(figure, panel, layer, class_name, look));
    }
  };
  for (const Layer& layer : panel.layers) {
    if (layer.mark == Mark::polygon) {
      continue;
    }
    if (!layer.label.empty()) {
      add(layer, "", look_of_class(class_index(figure, layer.label)));
    } else if (!layer.colour.empty() && figure.gradient) {
      add(layer, "", {"palette", 0});
    } else if (!layer.colour.empty()) {
      for (std::size_t i = figure.key.classes.size(); i > 0; --i) {  // The first one on top.
        add(layer, figure.key.classes[i - 1], look_of_class(i - 1));
      }
    } else {
      add(layer, "", look_of(layer.tone));
    }
  }
  const bool empty = clauses.empty();
  if (empty) {
    clauses.emplace_back("NaN notitle");
  }
  std::string out = empty ? "set xrange [0:1]\nset yrange [0:1]\nplot " : "plot ";
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    out += (i == 0 ? "" : ", \\\n  ") + clauses[i];
  }
  return out + "\n";
}

std::string key_entries(const Figure& figure) {
  std::string out = "NaN notitle";
  for (const std::string& name : drawn_classes(figure)) {
    if (const Layer* const sample = sample_of(figure, name)) {
      out += ", \\\n  " + key_entry(*sample, look_of_class(class_index(figure, name)), name);
    }
  }
  return out;
}

}  // namespace tcert
