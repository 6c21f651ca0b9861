#include "reports/figure/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "reports/figure/figure_rows.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr std::array<std::string_view, 6> kClassColours = {
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9"};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const Figure& figure, const std::string& what) {
  throw std::invalid_argument("figure '" + figure.name + "': " + what);
}

/// Every text of `column` among the layer's rows is in `known`.
void require_known(const Figure& figure,
                   const Panel& panel,
                   const Layer& layer,
                   const std::string& column,
                   const std::vector<std::string>& known) {
  for (std::size_t row = 0; row < figure.data.rows.size(); ++row) {
    const std::string text = text_at(figure.data, row, column);
    if (!text.empty() && !has(known, text) && is_of(figure, panel, layer, row)) {
      refuse(figure, fmt::format("'{}' of column '{}' is not declared", text, column));
    }
  }
}

void check_layer(const Figure& figure, const Panel& panel, const Layer& layer) {
  const std::vector<std::string> fields = data_fields(figure.data);
  for (const std::string* column :
       {&layer.x, &layer.y, &layer.x2, &layer.y2, &layer.text, &layer.group, &layer.colour}) {
    if (!column->empty() && !has(fields, *column)) {
      refuse(figure, "no column '" + *column + "'");
    }
  }
  if (layer.x.empty() || layer.y.empty()) {
    refuse(figure, "a layer of part '" + layer.part + "' without x or y");
  }
  if (!layer.label.empty() && !has(figure.key.classes, layer.label)) {
    refuse(figure, "no class '" + layer.label + "'");
  }
  if (!layer.colour.empty() && !figure.gradient) {
    require_known(figure, panel, layer, layer.colour, figure.key.classes);
  }
  if (panel.x.scale == AxisScale::categories) {
    require_known(figure, panel, layer, layer.x, panel.x.categories);
  }
  if (panel.y.scale == AxisScale::categories) {
    require_known(figure, panel, layer, layer.y, panel.y.categories);
  }
}

void require_together(const Figure& figure) {
  const std::vector<std::string> names = series_names(figure);
  std::set<std::string> seen;
  for (std::size_t row = 0; row < names.size(); ++row) {
    if ((row == 0 || names[row] != names[row - 1]) && !seen.insert(names[row]).second) {
      refuse(figure, "rows of a series do not stand together: row " + std::to_string(row + 1));
    }
  }
}

}  // namespace

std::vector<std::string> data_fields(const Table& table) {
  std::vector<std::string> fields;
  for (const Column& column : table.columns) {
    fields.push_back(column.name);
    if (column.kind == ColumnKind::estimate) {
      fields.push_back(column.name + "_low");
      fields.push_back(column.name + "_high");
    }
  }
  return fields;
}

std::string figure_csv(const Figure& figure) {
  Table data = figure.data;
  data.synthetic = figure.synthetic;
  return render(data, TableFormat::csv);
}

std::string axis_title(const Axis& axis) {
  return axis.unit.empty() ? axis.title : axis.title + " [" + axis.unit + "]";
}

std::string_view class_colour(std::size_t index) noexcept {
  return kClassColours[index % kClassColours.size()];
}

const std::vector<std::string>& gradient_stops() {
  static const std::vector<std::string> stops = {
      "#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"};
  return stops;
}

int tick_decimals(const std::vector<double>& ticks) noexcept {
  int decimals = 0;
  for (const double tick : ticks) {
    while (decimals < 9) {
      const double scaled = tick * std::pow(10.0, decimals);
      if (std::abs(scaled - std::round(scaled)) < 1e-6) {
        break;
      }
      ++decimals;
    }
  }
  return decimals;
}

void check(const Figure& figure) {
  if (!has(data_fields(figure.data), "part")) {
    refuse(figure, "no column 'part'");
  }
  require_together(figure);
  for (const Panel& panel : figure.panels) {
    for (const Axis* axis : {&panel.x, &panel.y}) {
      if (axis->title.empty() && !axis->hidden && axis->scale != AxisScale::categories) {
        refuse(figure, "an axis without a title");
      }
    }
    if (panel.equal_scale && !(panel.x.low && panel.x.high && panel.y.low && panel.y.high)) {
      refuse(figure, "equal scales need the ranges of both axes");
    }
    for (const Layer& layer : panel.layers) {
      check_layer(figure, panel, layer);
    }
  }
}

}  // namespace tcert
