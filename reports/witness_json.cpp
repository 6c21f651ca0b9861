#include "reports/witness_json.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <table/json_shape.hpp>
#include <vector>

#include "datasets/robot_json.hpp"
#include "reports/sha256.hpp"
#include "reports/witness_edges_json.hpp"
#include "reports/witness_path_json.hpp"

namespace tcert {
namespace {

using nlohmann::ordered_json;
using Runs = std::vector<std::vector<int>>;

constexpr double kLeastCell = 1e-4;                      // m
constexpr std::int64_t kMostAlong = 1'000'000'000;       // cells
constexpr std::int64_t kFarthest = 100'000'000'000'000;  // the number of a cell

constexpr std::array<std::string_view, 4> kAssumptions = {
    "Readings, less reading_bound_m, are not above the true clearance; poses are true, between two "
    "pose samples too.",
    "At depth h behind its tip every obstacle is at least h / lost_share wide, up to "
    "least_obstacle_m.",
    "S and G are free, and so is the body's disc at every sample.",
    "A path of this turn radius can be driven by this robot within its buffers."};

/// Of each row, alternately how many cells are not free and free, from the left; the last not free
/// ones are left out.
Runs runs_of(const witness::FreeCells& cells) {
  Runs runs(static_cast<std::size_t>(cells.lattice().rows));
  for (int iy = 0; iy < cells.lattice().rows; ++iy) {
    std::vector<int>& row = runs[static_cast<std::size_t>(iy)];
    bool free = false;
    int begin = 0;
    for (int ix = 0; ix < cells.lattice().columns; ++ix) {
      if (cells.is_free(ix, iy) != free) {
        row.push_back(ix - begin);
        begin = ix;
        free = !free;
      }
    }
    if (free) {
      row.push_back(cells.lattice().columns - begin);
    }
  }
  return runs;
}

/// Over a line a row, its numbers with a space between two.
std::string digest_of(const Runs& runs) {
  std::string lines;
  for (const std::vector<int>& row : runs) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      lines += (i > 0 ? " " : "") + std::to_string(row[i]);
    }
    lines += '\n';
  }
  return sha256(lines);
}

Region region_from(const ordered_json& json) {
  if (json.contains("disc")) {
    const ordered_json& disc = json.at("disc");
    return Disc{{disc.at("x_m"), disc.at("y_m")}, disc.at("radius_m")};
  }
  Polygon polygon;
  for (const ordered_json& vertex : json.at("polygon")) {
    polygon.vertices.push_back(point_from(vertex));
  }
  return polygon;
}

Ray ray_from(const ordered_json& json) {
  Ray ray{json.at("name"),
          {json.at("mount_x_m"), json.at("mount_y_m")},
          json.at("bearing_rad"),
          json.at("reach_m"),
          json.at("kind") == "bend" ? RayKind::bend : RayKind::range,
          {}};
  if (ray.kind == RayKind::bend) {
    json.at("calibration").at("bend_rad").get_to(ray.calibration.bend_rad);
    json.at("calibration").at("clearance_m").get_to(ray.calibration.clearance_m);
  }
  return ray;
}

/// \throws WitnessFormatError unless the number is finite and at least `least`.
double number_from(const ordered_json& json, const char* key, double least) {
  const double value = json.at(key).get<double>();
  if (!(value >= least && value <= std::numeric_limits<double>::max())) {
    throw WitnessFormatError(std::string(key) + " is below its least value, or not finite");
  }
  return value;
}

std::int64_t whole(const ordered_json& json, std::int64_t low, std::int64_t high) {
  const bool is_huge =
      json.is_number_unsigned() && json.get<std::uint64_t>() > static_cast<std::uint64_t>(high);
  const auto value = json.is_number_integer() && !is_huge ? json.get<std::int64_t>() : low - 1;
  if (value < low || value > high) {
    throw WitnessFormatError("a number of cells is not a whole one within its bounds");
  }
  return value;
}

Runs runs_from(const ordered_json& json) {
  Runs runs;
  for (const ordered_json& row : json) {
    runs.emplace_back();
    for (const ordered_json& length : row) {
      runs.back().push_back(static_cast<int>(whole(length, 0, kMostAlong)));
    }
  }
  return runs;
}

witness::FreeCells cells_from(const ordered_json& free, double cell_m, std::size_t max_cells) {
  const Runs runs = runs_from(free.at("runs"));
  const witness::Lattice lattice{cell_m,
                                 whole(free.at("first_x"), -kFarthest, kFarthest),
                                 whole(free.at("first_y"), -kFarthest, kFarthest),
                                 static_cast<int>(whole(free.at("columns"), 1, kMostAlong)),
                                 static_cast<int>(whole(free.at("rows"), 1, kMostAlong))};
  const bool fits =
      lattice.columns > 0 && lattice.rows > 0 &&
      static_cast<double>(lattice.columns) * lattice.rows <= static_cast<double>(max_cells);
  if (!fits || runs.size() != static_cast<std::size_t>(lattice.rows)) {
    throw WitnessFormatError("the free space has too many cells, or other runs than rows");
  }
  if (free.at("sha256") != digest_of(runs)) {
    throw WitnessFormatError("the free space does not have its digest");
  }
  witness::FreeCells cells(lattice);
  for (int iy = 0; iy < lattice.rows; ++iy) {
    int begin = 0;
    bool is_free = false;
    for (const int length : runs[static_cast<std::size_t>(iy)]) {
      if (length > lattice.columns - begin) {
        throw WitnessFormatError("a row of the free space is longer than its columns");
      }
      if (is_free && length > 0) {
        cells.mark_run(iy, begin, begin + length - 1);
      }
      begin += length;
      is_free = !is_free;
    }
  }
  return cells;
}

WitnessDocument document_from(const ordered_json& json, std::size_t max_cells) {
  if (json.at("format") != "tcert-witness" || json.at("version") != 1) {
    throw WitnessFormatError("it is not of format tcert-witness, version 1");
  }
  WitnessDocument document;
  if (json.value("synthetic", false)) {
    document.synthetic.emplace();
    if (json.contains("seed")) {
      document.synthetic->seed = json.at("seed").get<std::uint64_t>();
    }
  }
  json.at("trial_id").get_to(document.trial_id);
  json.at("log_sha256").get_to(document.log_sha256);
  const ordered_json& robot = json.at("robot");
  robot.at("body_width_m").get_to(document.robot.body_width_m);
  robot.at("min_turn_radius_m").get_to(document.robot.min_turn_radius_m);
  robot.at("tracking_buffer_m").get_to(document.robot.tracking_buffer_m);
  robot.at("curvature_buffer_per_m").get_to(document.robot.curvature_buffer_per_m);
  for (const ordered_json& ray : json.at("rays")) {
    document.robot.rays.push_back(ray_from(ray));
  }
  document.start = region_from(json.at("start"));
  document.goal = region_from(json.at("goal"));
  const ordered_json& rule = json.at("rule");
  document.rule.cell_m = number_from(rule, "cell_m", kLeastCell);
  document.rule.strips.least_obstacle_m = number_from(rule, "least_obstacle_m", 0.0);
  document.rule.strips.lost_share = number_from(rule, "lost_share", 0.0);
  document.rule.strips.reading_bound_m = number_from(rule, "reading_bound_m", 0.0);
  document.pose_bridge_s = number_from(rule, "pose_bridge_s", 0.0);
  document.rule.max_cells = max_cells;
  validate(document.robot);
  validate(Course{document.start, document.goal});
  document.cells = cells_from(json.at("free"), document.rule.cell_m, max_cells);
  document.path = path_from(json.at("path"), document.cells.lattice());
  document.stated = measured_from(json, !document.path.empty());
  if (json.contains("edges")) {
    document.edges = edges_from(json.at("edges"), document.cells.lattice());
  }
  return document;
}

}  // namespace

std::string to_json(const WitnessDocument& document) {
  ordered_json json;
  if (document.synthetic) {
    json["synthetic"] = true;
    if (document.synthetic->seed) {
      json["seed"] = *document.synthetic->seed;
    }
  }
  json["format"] = "tcert-witness";
  json["version"] = 1;
  json["trial_id"] = document.trial_id;
  json["log_sha256"] = document.log_sha256;
  add_measured(document.stated, !document.path.empty(), json);
  json["assumptions"] = kAssumptions;
  json["robot"] = {{"body_width_m", document.robot.body_width_m},
                   {"min_turn_radius_m", document.robot.min_turn_radius_m},
                   {"tracking_buffer_m", document.robot.tracking_buffer_m},
                   {"curvature_buffer_per_m", document.robot.curvature_buffer_per_m}};
  json["rays"] = ordered_json::array();
  for (const Ray& ray : document.robot.rays) {
    json["rays"].push_back(ray_json(ray, {}));
  }
  json["start"] = region_json(document.start);
  json["goal"] = region_json(document.goal);
  json["rule"] = {{"cell_m", document.rule.cell_m},
                  {"least_obstacle_m", document.rule.strips.least_obstacle_m},
                  {"lost_share", document.rule.strips.lost_share},
                  {"reading_bound_m", document.rule.strips.reading_bound_m},
                  {"pose_bridge_s", document.pose_bridge_s}};
  json["path"] = path_json(document.path);
  const witness::Lattice& lattice = document.cells.lattice();
  const Runs runs = runs_of(document.cells);
  json["free"] = {{"first_x", lattice.first_x},
                  {"first_y", lattice.first_y},
                  {"columns", lattice.columns},
                  {"rows", lattice.rows},
                  {"sha256", digest_of(runs)},
                  {"runs", runs}};
  if (document.edges) {
    json["edges"] = edges_json(*document.edges);
  }
  return json.dump() + '\n';
}

WitnessDocument witness_from_json(std::string_view text, std::size_t max_cells) {
  if (const std::string_view problem = table::json_shape_problem(text); !problem.empty()) {
    throw WitnessFormatError(std::string(problem));
  }
  try {
    return document_from(ordered_json::parse(text), max_cells);
  } catch (const nlohmann::json::exception& error) {
    throw WitnessFormatError(error.what());
  } catch (const std::invalid_argument& error) {
    throw WitnessFormatError(error.what());
  }
}

}  // namespace tcert
