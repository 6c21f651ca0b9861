#include "reports/figure/figure_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

bool is_there(const Table& data, std::size_t row, const std::string& column) {
  return column.empty() || !text_at(data, row, column).empty() ||
         std::isfinite(number_at(data, row, column));
}

bool divides(const Figure& figure, const Layer& layer) {
  return layer.label.empty() && !layer.colour.empty() && !figure.gradient;
}

bool shows(const Figure& figure, const Panel& panel, const std::string& name) {
  return std::any_of(panel.layers.begin(), panel.layers.end(), [&](const Layer& layer) {
    return (layer.label == name && !drawn_rows(figure, panel, layer).empty()) ||
           (divides(figure, layer) && !drawn_rows(figure, panel, layer, name).empty());
  });
}

}  // namespace

bool is_of(const Figure& figure,
           const Panel& panel,
           const Layer& layer,
           std::size_t row,
           const std::string& class_name) {
  const Table& data = figure.data;
  return text_at(data, row, "part") == layer.part &&
         (panel.name.empty() || text_at(data, row, "panel") == panel.name) &&
         (class_name.empty() || text_at(data, row, layer.colour) == class_name);
}

std::vector<std::size_t> drawn_rows(const Figure& figure,
                                    const Panel& panel,
                                    const Layer& layer,
                                    const std::string& class_name) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    if (is_of(figure, panel, layer, row, class_name) && is_there(figure.data, row, layer.x) &&
        is_there(figure.data, row, layer.y) && is_there(figure.data, row, layer.x2) &&
        is_there(figure.data, row, layer.y2)) {
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<std::string> drawn_classes(const Figure& figure) {
  std::vector<std::string> classes;
  for (const std::string& name : figure.key.classes) {
    if (std::any_of(figure.panels.begin(), figure.panels.end(), [&](const Panel& panel) {
          return shows(figure, panel, name);
        })) {
      classes.push_back(name);
    }
  }
  return classes;
}

std::vector<std::string> series_names(const Figure& figure) {
  std::map<std::string, std::set<std::string>> columns;  // Of each part.
  for (const Panel& panel : figure.panels) {
    for (const Layer& layer : panel.layers) {
      if (divides(figure, layer) && (is_path(layer.mark) || layer.mark == Mark::band)) {
        columns[layer.part].insert(layer.colour);
      }
    }
  }
  std::vector<std::string> names;
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    const std::string part = text_at(figure.data, row, "part");
    std::string name = part + '\n' + text_at(figure.data, row, "panel");
    for (const std::string& column : columns[part]) {
      name += '\n' + text_at(figure.data, row, column);
    }
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace tcert
