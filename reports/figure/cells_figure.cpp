#include "reports/figure/set_figures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
std::optional<Figure> cells_figure(const Table& cells,
                                   const std::string& name,
                                   const std::string& title) {
  const std::vector<std::string> panels = distinct(cells, "panel");
  const std::string last = panels.empty() ? std::string() : panels.back();
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    if (text_at(cells, row, "panel") == last && std::isfinite(number_at(cells, row, "auc"))) {
      rows.push_back(row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return number_at(cells, a, "auc") < number_at(cells, b, "auc");
  });
  Figure figure = named(name, title, cells.synthetic);
  const bool has_full = std::any_of(rows.begin(), rows.end(), [&](std::size_t row) {
    return text_at(cells, row, "cell") == "full";
  });
  figure.caption = "AUC of TC_early under each cell's parameters with " +
                   intervals_of(cells, "auc") + ", sorted. Vertical: 0.5 (chance)" +
                   std::string(has_full ? " and, dashed, the full method" : "") +
                   std::string(last == "landmark" ? "; landmark panel." : ".");
  figure.key = {"", {"full method", "other parameters"}};
  figure.data = figure_table(name, {"cell", "kind"}, {"auc", "auc_low", "auc_high"});
  Panel one;
  Extent extent;
  extent.add(0.5);
  for (const std::size_t row : rows) {
    const std::string cell = text_at(cells, row, "cell");
    const bool full = cell == "full";
    one.y.categories.push_back(cell);
    if (full) {
      one.references.push_back({true, number_at(cells, row, "auc"), true});
    }
    extent.add(number_at(cells, row, "auc_low"));
    extent.add(number_at(cells, row, "auc_high"));
    add_figure_row(figure.data,
                   "cell",
                   {cell, full ? "full method" : "other parameters"},
                   {number_at(cells, row, "auc"),
                    number_at(cells, row, "auc_low"),
                    number_at(cells, row, "auc_high")});
  }
  one.references.push_back({true, 0.5, false});
  one.x = axis("AUC of TC_early");
  extent.apply(one.x);
  one.y.scale = AxisScale::categories;
  Layer range = range_x("cell", "auc_low", "auc_high", "cell");
  range.colour = "kind";
  Layer point = layer(Mark::point, "cell", "auc", "cell");
  point.colour = "kind";
  one.layers = {range, point};
  one.height = std::max(0.5, 0.052 * static_cast<double>(rows.size()));
  figure.panels = {std::move(one)};
  return finished(std::move(figure));
}

}  // namespace tcert
