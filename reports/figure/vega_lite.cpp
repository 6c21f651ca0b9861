#include "reports/figure/vega_lite.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "reports/figure/figure_rows.hpp"
#include "reports/figure/vega_layer.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

constexpr double kPanelPixels = 280.0;  // Pixels.
constexpr double kPanelWidth = 380.0;
constexpr double kMapWidth = 620.0;

Json reference_of(const Panel& panel, const Reference& reference) {
  Json mark = {{"type", "rule"}, {"style", reference.strong ? "ink" : "muted"}};
  if (reference.strong) {
    mark["strokeDash"] = {5, 4};
  }
  const Axis& axis = reference.vertical ? panel.x : panel.y;
  // With the same title, scale and labels as the layers of data: an axis is made of all of them.
  Json channel = vega_position(axis, "", !reference.vertical);
  channel.erase("field");
  channel["datum"] = reference.at;
  return {{"data", {{"values", Json::array({Json::object()})}}},
          {"mark", std::move(mark)},
          {"encoding", {{reference.vertical ? "x" : "y", std::move(channel)}}}};
}

Json panel_of(const Figure& figure, const Panel& panel, bool alone) {
  Json view = Json::object();
  if (!panel.title.empty()) {
    view["title"] = panel.title;
  }
  if (panel.equal_scale) {
    view["width"] = kMapWidth;
    view["height"] =
        std::round(kMapWidth * (*panel.y.high - *panel.y.low) / (*panel.x.high - *panel.x.low));
  } else {
    view["width"] = alone ? Json("container") : Json(figure.columns > 1 ? kPanelWidth : kMapWidth);
    view["height"] = std::round(kPanelPixels * panel.height);
  }
  Json layers = Json::array();
  for (const Reference& reference : panel.references) {
    layers.push_back(reference_of(panel, reference));
  }
  for (const Layer& layer : panel.layers) {
    if (!drawn_rows(figure, panel, layer).empty()) {  // A scale of nothing has no extent.
      layers.push_back(vega_layer(figure, panel, layer));
    }
  }
  view["layer"] = std::move(layers);
  return view;
}

/// The look on light ground.
Json default_config() {
  Json style = Json::object();
  const auto tones = std::to_array<std::pair<const char*, const char*>>(
      {{"ink", "#222222"}, {"muted", "#888888"}, {"faint", "#d0d0d0"}});
  for (const auto& [name, colour] : tones) {
    style[name] = {{"color", colour}, {"stroke", colour}};
    style[std::string(name) + "-text"] = {{"color", colour}};
  }
  style["filled-faint"] = {{"color", "#d0d0d0"}, {"fill", "#d0d0d0"}};
  return {{"style", std::move(style)}, {"view", {{"stroke", nullptr}}}};
}

}  // namespace

nlohmann::ordered_json vega_lite(const Figure& figure) {
  check(figure);
  Json spec;
  spec["$schema"] = "https://vega.github.io/schema/vega-lite/v5.json";
  Json title = {{"text", figure.title}, {"anchor", "start"}, {"offset", 14}};
  if (figure.synthetic) {
    title["subtitle"] = to_string(*figure.synthetic);
  }
  spec["title"] = std::move(title);
  spec["description"] = figure.caption.empty() ? figure.title : figure.caption;
  spec["usermeta"] = {{"name", figure.name}, {"synthetic", figure.synthetic.has_value()}};
  spec["config"] = default_config();
  Json values = Json::array();
  for (const auto& row : figure.data.rows) {
    values.push_back(json_row(figure.data, row));
  }
  spec["data"] = {{"name", figure.name}, {"values", std::move(values)}};
  if (figure.panels.size() == 1) {
    Json view = panel_of(figure, figure.panels.front(), true);
    view.erase("title");
    spec.update(view);
    return spec;
  }
  spec["columns"] = figure.columns;
  Json views = Json::array();
  for (const Panel& panel : figure.panels) {
    views.push_back(panel_of(figure, panel, false));
  }
  spec["concat"] = std::move(views);
  spec["resolve"] = {{"scale", {{"color", "shared"}}}, {"legend", {{"color", "shared"}}}};
  return spec;
}

}  // namespace tcert
