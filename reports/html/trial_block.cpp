#include "reports/html/trial_block.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

#include "reports/html/decimate.hpp"
#include "reports/html/packed.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

constexpr double kMillimetre = 1000.0;

Json coded(const std::vector<double>& values, const std::vector<std::size_t>& kept, int scale) {
  Json steps = Json::array();
  std::int64_t last = 0;
  for (const std::size_t i : kept) {
    if (!std::isfinite(values[i])) {
      steps.push_back(nullptr);
      continue;
    }
    const std::int64_t whole = std::llround(values[i] * scale);
    steps.push_back(whole - last);
    last = whole;
  }
  return {{"scale", scale}, {"steps", std::move(steps)}};
}

Json rounded(double value) { return std::round(value * kMillimetre) / kMillimetre; }

Json json_point(Point p) { return {{"x", rounded(p.x_m)}, {"y", rounded(p.y_m)}}; }

Json json_ring(const Polygon& polygon) {
  Json ring = Json::array();
  for (const Point& p : polygon.vertices) {
    ring.push_back(Json::array({rounded(p.x_m), rounded(p.y_m)}));
  }
  return ring;
}

Json json_disc(const Disc& disc) {
  Json json = json_point(disc.centre);
  json["r"] = rounded(disc.radius_m);
  return json;
}

Json json_region(const std::optional<Region>& region) {
  if (!region) {
    return nullptr;
  }
  if (const auto* disc = std::get_if<Disc>(&*region)) {
    return json_disc(*disc);
  }
  return {{"polygon", json_ring(std::get<Polygon>(*region))}};
}

/// Where the free width ends on either side of the robot, at the ticks that are shown.
Json json_felt(const table::NumberTable& series, const std::vector<std::size_t>& kept) {
  const std::vector<double> x = series_column(series, "x_m");
  const std::vector<double> y = series_column(series, "y_m");
  const std::vector<double> yaw = series_column(series, "yaw_rad");
  const std::vector<double> left = series_column(series, "left_m");
  const std::vector<double> right = series_column(series, "right_m");
  Json points = Json::array();
  for (const std::size_t i : kept) {
    for (const double side : {left[i], -right[i]}) {
      const Point end{x[i] - side * std::sin(yaw[i]), y[i] + side * std::cos(yaw[i])};
      if (std::isfinite(end.x_m) && std::isfinite(end.y_m)) {
        points.push_back(Json::array({rounded(end.x_m), rounded(end.y_m)}));
      }
    }
  }
  return points;
}

Json json_map(const TrialMap& map,
              const table::NumberTable& series,
              const std::vector<std::size_t>& kept) {
  Json json;
  json["edges"] = Json::array();
  for (const MapEdge& edge : map.edges) {
    json["edges"].push_back(
        Json::array({rounded(edge.a.x_m),
                     rounded(edge.a.y_m),
                     rounded(edge.b.x_m),
                     rounded(edge.b.y_m),
                     std::isfinite(edge.margin_m) ? rounded(edge.margin_m) : Json()}));
  }
  json["bottleneck"] = map.bottleneck ? json_point(*map.bottleneck) : Json();
  json["witness"] = Json::array();
  for (const Point& p : map.witness) {
    json["witness"].push_back({rounded(p.x_m), rounded(p.y_m)});
  }
  json["witnessBottleneck"] = map.witness_bottleneck ? json_point(*map.witness_bottleneck) : Json();
  json["issued"] = nullptr;
  const std::vector<double> issued = series_column(series, "issued");
  const std::vector<double> x = series_column(series, "x_m");
  const std::vector<double> y = series_column(series, "y_m");
  for (std::size_t i = 0; i < issued.size(); ++i) {
    if (issued[i] == 1.0) {
      if (std::isfinite(x[i]) && std::isfinite(y[i])) {
        json["issued"] = json_point({x[i], y[i]});
      }
      break;
    }
  }
  if (map.felt) {
    json["beams"] = json_felt(series, kept);
  }
  json["note"] = map.note;
  return json;
}

std::vector<std::size_t> changes(const std::vector<double>& values) {
  std::vector<std::size_t> at;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] != values[i - 1] && !(std::isnan(values[i]) && std::isnan(values[i - 1]))) {
      at.push_back(i);
    }
  }
  return at;
}

}  // namespace

std::string_view decimation_rule() noexcept {
  return "of each short stretch of time and each column, those with the smallest and the largest "
         "value, and every change of the certificate; values rounded to a millimetre, a "
         "millisecond, "
         "margins to a tenth of a millimetre. The CSV files have every tick in full precision.";
}

std::string trial_block(const table::NumberTable& series,
                        const TrialMap& map,
                        const std::string& facts,
                        std::size_t limit) {
  std::vector<std::vector<double>> values;
  std::vector<std::span<const double>> watched;
  for (const PageColumn& column : page_columns()) {
    values.push_back(page_column(series, column.name));
  }
  for (std::size_t c = 1; c < values.size(); ++c) {
    watched.emplace_back(values[c]);
  }
  std::vector<std::size_t> always = changes(series_column(series, "certificate_m"));
  if (always.size() > limit / 2) {
    always.clear();  // Its extremes stay like those of any other column.
  }
  const std::vector<std::size_t> kept = kept_ticks(series.rows(), watched, always, limit);
  Json json;
  json["facts"] = facts;
  json["ticks"] = series.rows();
  json["map"] = json_map(map, series, kept);
  for (std::size_t c = 0; c < values.size(); ++c) {
    const PageColumn& column = page_columns()[c];
    if (c == 0 || std::any_of(values[c].begin(), values[c].end(), [](double v) {
          return std::isfinite(v);
        })) {
      json["series"][std::string(column.name)] = coded(values[c], kept, column.scale);
    }
  }
  return packed(dumped(json, -1));
}

std::string world_block(const World& world) {
  Json json;
  const bool bounded = world.bounds.high.x_m > world.bounds.low.x_m;
  json["bounds"] = !bounded ? Json()
                            : Json::array({rounded(world.bounds.low.x_m),
                                           rounded(world.bounds.low.y_m),
                                           rounded(world.bounds.high.x_m),
                                           rounded(world.bounds.high.y_m)});
  json["polygons"] = Json::array();
  json["discs"] = Json::array();
  for (const Region& obstacle : world.obstacles) {
    if (const auto* disc = std::get_if<Disc>(&obstacle)) {
      json["discs"].push_back(json_disc(*disc));
    } else {
      json["polygons"].push_back(json_ring(std::get<Polygon>(obstacle)));
    }
  }
  json["start"] = json_region(world.start);
  json["goal"] = json_region(world.goal);
  return packed(dumped(json, -1));
}

}  // namespace tcert
