#include "reports/figure/trial_figures.hpp"

#include <table/not_a_number.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr const char* kContact = "new contact";
constexpr int kDiscCorners = 36;
constexpr double kGradientHigh = 0.3;  // Metres; wider edges are as bright.

/// Corners of a region.
std::vector<Point> outline(const Region& region) {
  if (const auto* const polygon = std::get_if<Polygon>(&region)) {
    return polygon->vertices;
  }
  const Disc& disc = std::get<Disc>(region);
  std::vector<Point> points;
  for (int i = 0; i < kDiscCorners; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / kDiscCorners;
    points.push_back({disc.centre.x_m + disc.radius_m * std::cos(angle),
                      disc.centre.y_m + disc.radius_m * std::sin(angle)});
  }
  return points;
}

/// The table of a map and how far it reaches.
class MapData {
 public:
  MapData()
      : table_(figure_table(
            "map", {"shape"}, {"x_m", "y_m", "to_x_m", "to_y_m", "margin_m", "time_s"})) {}

  void add(const char* part,
           const std::string& shape,
           Point from,
           Point to = {table::kNaN, table::kNaN},
           double margin_m = table::kNaN,
           double time_s = table::kNaN) {
    add_figure_row(table_, part, {shape}, {from.x_m, from.y_m, to.x_m, to.y_m, margin_m, time_s});
    for (const Point p : {from, to}) {
      if (std::isfinite(p.x_m) && std::isfinite(p.y_m)) {
        low_ = {std::min(low_.x_m, p.x_m), std::min(low_.y_m, p.y_m)};
        high_ = {std::max(high_.x_m, p.x_m), std::max(high_.y_m, p.y_m)};
      }
    }
  }

  /// Ranges with some room.
  void apply(Panel& panel) const {
    const double room = 0.03 * std::max(high_.x_m - low_.x_m, high_.y_m - low_.y_m) + 0.05;
    panel.x.low = low_.x_m - room;
    panel.x.high = high_.x_m + room;
    panel.y.low = low_.y_m - room;
    panel.y.high = high_.y_m + room;
  }

  [[nodiscard]] Table table() && { return std::move(table_); }

 private:
  Table table_;
  Point low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high_{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

void add_world(const World& world, MapData& data) {
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    for (const Point p : outline(world.obstacles[i])) {
      data.add("wall", "wall " + std::to_string(i + 1), p);
    }
  }
  const std::array<std::pair<const char*, const std::optional<Region>&>, 2> regions = {
      {{"S", world.start}, {"G", world.goal}}};
  for (const auto& [name, region] : regions) {
    if (!region) {
      continue;
    }
    std::vector<Point> points = outline(*region);
    Point centre{0.0, 0.0};
    for (const Point p : points) {
      data.add("region", name, p);
      centre.x_m += p.x_m / static_cast<double>(points.size());
      centre.y_m += p.y_m / static_cast<double>(points.size());
    }
    data.add("region", name, points.front());
    data.add("region", name, {table::kNaN, table::kNaN});  // The next outline is another line.
    data.add("name", name, centre);
  }
}

/// Where the rays prove the sides free: no walls are known.
void add_sides(const table::DataTable& series, MapData& data) {
  for (std::size_t row = 0; row < series.rows; ++row) {
    const double x = number_at(series, row, "x_m");
    const double y = number_at(series, row, "y_m");
    const double yaw = number_at(series, row, "yaw_rad");
    const double left = number_at(series, row, "left_m");
    const double right = number_at(series, row, "right_m");
    if (std::isfinite(left)) {
      data.add("felt", "", {x - left * std::sin(yaw), y + left * std::cos(yaw)});
    }
    if (std::isfinite(right)) {
      data.add("felt", "", {x + right * std::sin(yaw), y - right * std::cos(yaw)});
    }
  }
}

void add_path(const TrialPicture& trial, MapData& data) {
  const table::DataTable& series = trial.series;
  const std::vector<double> times = trial_times(series);
  bool issued = false;
  for (std::size_t row = 0; row < series.rows; ++row) {
    const Point p{number_at(series, row, "x_m"), number_at(series, row, "y_m")};
    if (text_at(series, row, "flags").find("break") != std::string::npos) {
      data.add("path", "", {table::kNaN, table::kNaN});
    }
    data.add("path", "", p, {table::kNaN, table::kNaN}, table::kNaN, times[row]);
    if (!issued && number_at(series, row, "issued") == 1.0) {
      data.add("issued",
               "",
               p,
               {table::kNaN, table::kNaN},
               number_at(series, row, "certificate_m"),
               times[row]);
      issued = true;
    }
  }
}

/// Where the robot was when a ray touched something that it had not touched the tick before.
void add_contacts(const table::DataTable& series, MapData& data) {
  const std::vector<double> times = trial_times(series);
  for (std::size_t row = 0; row < series.rows; ++row) {
    if (number_at(series, row, "new_contacts") > 0.0) {
      data.add("contact",
               "",
               {number_at(series, row, "x_m"), number_at(series, row, "y_m")},
               {table::kNaN, table::kNaN},
               table::kNaN,
               times[row]);
    }
  }
}

void add_edges(const table::DataTable& edges, MapData& data) {
  for (std::size_t row = 0; row < edges.rows; ++row) {
    data.add("edge",
             "",
             {number_at(edges, row, "a_x_m"), number_at(edges, row, "a_y_m")},
             {number_at(edges, row, "b_x_m"), number_at(edges, row, "b_y_m")},
             number_at(edges, row, "margin_m"));
  }
}

std::vector<Layer> map_layers(bool walls) {
  std::vector<Layer> layers;
  if (walls) {
    Layer wall = layer(Mark::polygon, "wall", "x_m", "y_m");
    wall.group = "shape";
    Layer region = layer(Mark::line, "region", "x_m", "y_m");
    region.tone = Tone::muted;
    Layer name = layer(Mark::text, "name", "x_m", "y_m");
    name.text = "shape";
    layers = {wall, region, name};
  } else {
    Layer felt = layer(Mark::point, "felt", "x_m", "y_m");
    felt.tone = Tone::faint;
    felt.size = 0.3;
    layers = {felt};
  }
  Layer edge = layer(Mark::segment, "edge", "x_m", "y_m");
  edge.x2 = "to_x_m";
  edge.y2 = "to_y_m";
  edge.colour = "margin_m";
  edge.width = 5.0;
  Layer path = layer(Mark::line, "path", "x_m", "y_m");
  path.width = 1.2;
  Layer contact = layer(Mark::point, "contact", "x_m", "y_m");
  contact.label = kContact;
  contact.size = 1.4;
  Layer bottleneck = layer(Mark::point, "bottleneck", "x_m", "y_m");
  bottleneck.label = "bottleneck of T_t";
  bottleneck.size = 3.0;
  bottleneck.hollow = true;
  bottleneck.width = 2.5;
  Layer issued = layer(Mark::point, "issued", "x_m", "y_m");
  issued.label = "issued here";
  issued.size = 2.2;
  layers.insert(layers.end(), {edge, path, contact, bottleneck, issued});
  return layers;
}

}  // namespace

std::optional<Figure> trial_map_figure(const TrialPicture& trial) {
  Figure figure = named(
      "trial_" + trial.trial_id + "_map", "Trial " + trial.trial_id + ": map", trial.synthetic);
  figure.caption = std::string(trial.world ? "Walls of the known world"
                                           : "What the rays prove free on both sides") +
                   ", odometry (thin line), and the corridor graph by the margin of its edges. The "
                   "hollow mark is the bottleneck that decides T_t; triangles are where the robot "
                   "was when a ray touched something anew.";
  MapData data;
  if (trial.world) {
    add_world(*trial.world, data);
  } else {
    add_sides(trial.series, data);
  }
  if (trial.edges) {
    add_edges(*trial.edges, data);
  }
  add_path(trial, data);
  if (trial.bottleneck_x_m && trial.bottleneck_y_m) {
    data.add("bottleneck", "", {*trial.bottleneck_x_m, *trial.bottleneck_y_m});
  }
  add_contacts(trial.series, data);
  figure.key.classes = {"issued here", "bottleneck of T_t", kContact};
  figure.gradient = Gradient{"edge margin", "m", 0.0, kGradientHigh, {}};
  Panel map;
  map.x = axis("x", "m");
  map.y = axis("y", "m");
  map.equal_scale = true;
  data.apply(map);
  map.layers = map_layers(trial.world.has_value());
  figure.data = std::move(data).table();
  figure.panels = {std::move(map)};
  return finished(std::move(figure));
}

}  // namespace tcert
