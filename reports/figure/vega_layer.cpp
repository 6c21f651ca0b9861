#include "reports/figure/vega_layer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "reports/figure/figure_rows.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

Json dash_array_of(std::size_t index) {
  static const std::array<Json, 6> dashes = {Json::array({1, 0}),
                                             Json::array({7, 3}),
                                             Json::array({2, 2}),
                                             Json::array({8, 3, 2, 3}),
                                             Json::array({12, 3}),
                                             Json::array({4, 2, 1, 2})};
  return dashes[index % dashes.size()];
}

std::string_view shape_of(std::size_t index) {
  constexpr std::array<std::string_view, 6> kShapes = {
      "circle", "square", "triangle-up", "diamond", "triangle-down", "cross"};
  return kShapes[index % kShapes.size()];
}

std::string_view word_of(Tone tone) {
  switch (tone) {
    case Tone::ink:
      return "ink";
    case Tone::muted:
      return "muted";
    case Tone::faint:
      return "faint";
  }
  return "ink";
}

bool has_classes(const Figure& figure, const Layer& layer) {
  return !layer.label.empty() || (!layer.colour.empty() && !figure.gradient);
}

Json scale_of(const Axis& axis, bool vertical) {
  Json scale = Json::object();
  if (axis.scale == AxisScale::categories) {
    std::vector<std::string> domain = axis.categories;
    if (vertical) {
      std::reverse(domain.begin(), domain.end());
    }
    scale["domain"] = domain;
    return scale;
  }
  if (axis.scale == AxisScale::log) {
    scale["type"] = "log";
  }
  if (axis.scale != AxisScale::log) {
    scale["zero"] = false;
  }
  if (axis.low) {
    scale["domainMin"] = *axis.low;
  }
  if (axis.high) {
    scale["domainMax"] = *axis.high;
  }
  scale["nice"] = !axis.low && !axis.high;
  return scale;
}

std::string tick_format(const std::vector<double>& ticks) {
  return "." + std::to_string(tick_decimals(ticks)) + "f";
}

Json class_scale(const Figure& figure) {
  Json colours = Json::array();
  for (std::size_t i = 0; i < figure.key.classes.size(); ++i) {
    colours.push_back(class_colour(i));
  }
  return {{"domain", figure.key.classes}, {"range", std::move(colours)}};
}

template <class Of>
Json scale_by(const Figure& figure, const Of& of) {
  Json range = Json::array();
  for (std::size_t i = 0; i < figure.key.classes.size(); ++i) {
    range.push_back(of(i));
  }
  return {{"domain", figure.key.classes}, {"range", std::move(range)}};
}

void add_classes(const Figure& figure, const Layer& layer, Json& encoding) {
  Json channel = layer.label.empty() ? Json{{"field", layer.colour}} : Json{{"datum", layer.label}};
  channel["type"] = "nominal";
  const Json title = figure.key.title.empty() ? Json(nullptr) : Json(figure.key.title);
  const Json legend = {{"title", title},
                       {"values", drawn_classes(figure)},
                       {"orient", "top"},
                       {"columns", 2},
                       {"labelLimit", 260},
                       {"symbolSize", 90},
                       {"symbolStrokeWidth", 2},
                       {"symbolOpacity", 1},
                       {"direction", "horizontal"}};
  Json colour = channel;
  colour["scale"] = class_scale(figure);
  colour["legend"] = legend;
  encoding["color"] = std::move(colour);
  if (is_path(layer.mark)) {
    Json dash = channel;
    dash["scale"] = scale_by(figure, dash_array_of);
    dash["legend"] = legend;
    encoding["strokeDash"] = std::move(dash);
  } else if (layer.mark == Mark::point) {
    Json shape = channel;
    shape["scale"] = scale_by(figure, shape_of);
    shape["legend"] = legend;
    encoding["shape"] = std::move(shape);
  }
}

void add_gradient(const Gradient& gradient, const Layer& layer, Json& encoding) {
  const std::string title =
      gradient.unit.empty() ? gradient.title : gradient.title + " [" + gradient.unit + "]";
  encoding["stroke"] = {
      {"field", layer.colour},
      {"type", "quantitative"},
      {"scale",
       {{"domain", {gradient.low, gradient.high}}, {"range", gradient_stops()}, {"clamp", true}}},
      {"legend", {{"title", title}, {"orient", "right"}}}};
  if (!gradient.ticks.empty()) {
    encoding["stroke"]["legend"]["values"] = gradient.ticks;
    encoding["stroke"]["legend"]["format"] = tick_format(gradient.ticks);
  }
}

Json mark_of(const Figure& figure, const Panel& panel, const Layer& layer) {
  Json mark = Json::object();
  const bool clipped = panel.x.low || panel.x.high || panel.y.low || panel.y.high;
  switch (layer.mark) {
    case Mark::line:
    case Mark::step:
      mark = {{"type", "line"},
              {"interpolate", layer.mark == Mark::step ? "step-after" : "linear"},
              {"strokeWidth", layer.width}};
      if (layer.guide) {
        mark["strokeDash"] = {5, 4};
      }
      break;
    case Mark::point:
      mark = {{"type", "point"},
              {"filled", !layer.hollow},
              {"size", 45.0 * layer.size},
              {"opacity", 1}};
      if (layer.hollow) {
        mark["strokeWidth"] = layer.width;
      }
      mark["tooltip"] = {{"content", "data"}};
      break;
    case Mark::segment:
    case Mark::range_x:
    case Mark::range_y:
      mark = {{"type", "rule"}, {"strokeWidth", layer.width}};
      break;
    case Mark::band:
      mark = {{"type", "area"}, {"opacity", 0.18}};
      break;
    case Mark::polygon:
      mark = {{"type", "line"}, {"interpolate", "linear-closed"}, {"strokeWidth", 0.5}};
      break;
    case Mark::text:
      mark = {{"type", "text"}, {"fontSize", 11}, {"dy", -13.0 * layer.raise}};
      if (layer.raise > 0.0) {
        mark["align"] = "left";
        mark["dx"] = 5;
      }
      break;
  }
  if (!has_classes(figure, layer)) {
    mark["style"] = layer.mark == Mark::polygon ? std::string("filled-faint")
                    : layer.mark == Mark::text  ? std::string(word_of(layer.tone)) + "-text"
                                                : std::string(word_of(layer.tone));
  }
  if (clipped && layer.mark != Mark::text && layer.mark != Mark::point) {
    mark["clip"] = true;
  }
  return mark;
}

Json filters_of(const Panel& panel, const Layer& layer) {
  Json filters = Json::array();
  filters.push_back({{"filter", {{"field", "part"}, {"equal", layer.part}}}});
  if (!panel.name.empty()) {
    filters.push_back({{"filter", {{"field", "panel"}, {"equal", panel.name}}}});
  }
  if (is_path(layer.mark) || layer.mark == Mark::polygon) {
    // Drawn as the rows are ordered; a missing value breaks the line.
    filters.push_back({{"window", Json::array({{{"op", "row_number"}, {"as", "row"}}})}});
    return filters;
  }
  const auto require = [&](const std::string& field, const Axis& axis) {
    if (!field.empty() && axis.scale != AxisScale::categories) {
      filters.push_back({{"filter", {{"field", field}, {"valid", true}}}});
    }
  };
  require(layer.x, panel.x);
  require(layer.x2, panel.x);
  require(layer.y, panel.y);
  require(layer.y2, panel.y);
  return filters;
}

}  // namespace

OrderedJson vega_position(const Axis& axis, const std::string& field, bool vertical) {
  Json channel = {{"field", field}};
  const bool categories = axis.scale == AxisScale::categories;
  channel["type"] = categories ? "nominal" : "quantitative";
  channel["title"] = axis.title.empty() ? Json(nullptr) : Json(axis_title(axis));
  channel["scale"] = scale_of(axis, vertical);
  if (axis.hidden) {
    channel["axis"] = nullptr;
  } else if (!axis.ticks.empty()) {
    channel["axis"] = {{"values", axis.ticks}, {"format", tick_format(axis.ticks)}};
  } else if (categories) {
    channel["axis"] = {{"labelLimit", 260}, {"labelAngle", 0}, {"grid", false}};
  } else {
    channel["axis"] = {{"format", ".6~g"}};
  }
  return channel;
}

OrderedJson vega_layer(const Figure& figure, const Panel& panel, const Layer& layer) {
  Json encoding = {{"x", vega_position(panel.x, layer.x, false)},
                   {"y", vega_position(panel.y, layer.y, true)}};
  if (!layer.x2.empty()) {
    encoding["x2"] = {{"field", layer.x2}};
  }
  if (!layer.y2.empty()) {
    encoding["y2"] = {{"field", layer.y2}};
  }
  if (!layer.text.empty()) {
    encoding["text"] = {{"field", layer.text}};
  }
  if (!layer.group.empty()) {
    encoding["detail"] = {{"field", layer.group}, {"type", "nominal"}};
  }
  if (has_classes(figure, layer)) {
    add_classes(figure, layer, encoding);
  } else if (!layer.colour.empty()) {
    add_gradient(*figure.gradient, layer, encoding);
  }
  if (is_path(layer.mark) || layer.mark == Mark::polygon) {
    encoding["order"] = {{"field", "row"}, {"type", "quantitative"}};
  }
  return {{"transform", filters_of(panel, layer)},
          {"mark", mark_of(figure, panel, layer)},
          {"encoding", std::move(encoding)}};
}

}  // namespace tcert
