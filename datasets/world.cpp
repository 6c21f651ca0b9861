#include "datasets/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <table/json_shape.hpp>

#include "datasets/robot_json.hpp"
#include "datasets/world_fields.hpp"

namespace tcert {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(Point p) { return Json::array({p.x_m, p.y_m}); }

[[noreturn]] void fail(const std::string& where, const std::string& expected) {
  throw WorldFormatError(where + ": expected " + expected);
}

void check_keys(const Json& json, const std::string& where, std::string_view place) {
  if (!json.is_object()) {
    fail(where, "an object");
  }
  const std::vector<std::string> known = names_at(place, world_fields());
  for (const auto& item : json.items()) {
    if (std::ranges::find(known, item.key()) == known.end()) {
      fail(where, "no key '" + item.key() + "'");
    }
  }
}

const Json& member(const Json& json, const std::string& where, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) {
    fail(where, std::string("a key '") + key + "'");
  }
  return *found;
}

double number(const Json& json, const std::string& where) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) {
    fail(where, "a finite number");
  }
  return json.get<double>();
}

Point read_point(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 2) {
    fail(where, "two numbers [x, y]");
  }
  return {number(json[0], where), number(json[1], where)};
}

Disc read_disc(const Json& json, const std::string& where) {
  check_keys(json, where, "disc");
  const Disc disc{
      {number(member(json, where, "x_m"), where), number(member(json, where, "y_m"), where)},
      number(member(json, where, "radius_m"), where)};
  if (disc.radius_m <= 0.0) {
    fail(where, "a positive radius_m");
  }
  return disc;
}

Region read_region(const Json& json, const std::string& where) {
  check_keys(json, where, "region");
  if (json.size() != 1) {
    fail(where, "either a disc or a polygon");
  }
  if (json.contains("disc")) {
    return read_disc(json["disc"], where);
  }
  const Json& vertices = json["polygon"];
  if (!vertices.is_array() || vertices.size() < 3) {
    fail(where, "a polygon of at least 3 vertices");
  }
  Polygon polygon;
  polygon.vertices.reserve(vertices.size());
  for (const Json& vertex : vertices) {
    polygon.vertices.push_back(read_point(vertex, where));
  }
  return polygon;
}

Bounds read_bounds(const Json& json) {
  const std::string where = "bounds";
  check_keys(json, where, "bounds");
  const Bounds bounds{read_point(member(json, where, "low"), where),
                      read_point(member(json, where, "high"), where)};
  if (!(bounds.low.x_m < bounds.high.x_m && bounds.low.y_m < bounds.high.y_m)) {
    fail(where, "low below high in both axes");
  }
  return bounds;
}

void check_format(const Json& json) {
  check_keys(json, "world", "world");
  if (member(json, "world", "format") != "tcert-world") {
    fail("format", "\"tcert-world\"");
  }
  if (member(json, "world", "version") != 1) {
    fail("version", "1");
  }
}

World read_world(const Json& json) {
  check_format(json);
  World world;
  const Json& synthetic = member(json, "world", "synthetic");
  if (!synthetic.is_boolean()) {
    fail("synthetic", "true or false");
  }
  world.synthetic = synthetic.get<bool>();
  if (json.contains("seed")) {
    if (!json["seed"].is_number_unsigned()) {
      fail("seed", "an integer of at least 0");
    }
    world.seed = json["seed"].get<std::uint64_t>();
  }
  if (json.contains("name")) {
    if (!json["name"].is_string()) {
      fail("name", "a string");
    }
    world.name = json["name"].get<std::string>();
  }
  world.bounds = read_bounds(member(json, "world", "bounds"));
  if (json.contains("start")) {
    world.start = read_region(json["start"], "start");
  }
  if (json.contains("goal")) {
    world.goal = read_region(json["goal"], "goal");
  }
  const Json& obstacles = member(json, "world", "obstacles");
  if (!obstacles.is_array()) {
    fail("obstacles", "an array");
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    world.obstacles.push_back(read_region(obstacles[i], "obstacles[" + std::to_string(i) + "]"));
  }
  return world;
}

}  // namespace

std::string to_json(const World& world) {
  Json json = Json::object();
  json["synthetic"] = world.synthetic;
  if (world.seed) {
    json["seed"] = *world.seed;
  }
  json["format"] = "tcert-world";
  json["version"] = 1;
  if (!world.name.empty()) {
    json["name"] = world.name;
  }
  json["bounds"] = {{"low", point_json(world.bounds.low)}, {"high", point_json(world.bounds.high)}};
  if (world.start) {
    json["start"] = region_json(*world.start);
  }
  if (world.goal) {
    json["goal"] = region_json(*world.goal);
  }
  Json obstacles = Json::array();
  for (const Region& obstacle : world.obstacles) {
    obstacles.push_back(region_json(obstacle));
  }
  json["obstacles"] = std::move(obstacles);
  return json.dump() + '\n';
}

World world_from_json(std::string_view text) {
  if (const auto shape = table::json_shape_problem(text); !shape.empty()) {
    throw WorldFormatError(std::string(shape));
  }
  try {
    return read_world(Json::parse(text));
  } catch (const Json::exception& error) {
    throw WorldFormatError(std::string("not JSON: ") + error.what());
  }
}

}  // namespace tcert
