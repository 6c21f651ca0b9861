#include "datasets/robot_json.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <table/nearest_name.hpp>
#include <tcert/region_overlap.hpp>
#include <utility>
#include <variant>

#include "datasets/bundle_fields.hpp"
#include "datasets/range_json.hpp"

namespace tcert {

namespace {

constexpr double kWideBody = 20.0;  // m; no robot that feels its way is wider

bool is_number(const nlohmann::json& value) { return value.is_number(); }

bool is_point(const nlohmann::json& value) {
  return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/// Fit to be part of a column name.
bool is_ray_name(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '.' || c == '-';
  });
}

std::vector<double> read_numbers(const table::JsonObject& from, const std::string& key) {
  if (from.require(key) == nullptr) {
    return {};
  }
  const nlohmann::json* list = from.list(key, is_number, "a list of numbers");
  return list == nullptr ? std::vector<double>{} : list->get<std::vector<double>>();
}

Calibration read_calibration(const table::JsonObject& ray) {
  const nlohmann::json* value = ray.require("calibration");
  if (value == nullptr) {
    return {};
  }
  const table::JsonObject from =
      ray.child("calibration", *value, names_at("calibration", bundle_fields()));
  return {read_numbers(from, "bend_rad"), read_numbers(from, "clearance_m")};
}

RayKind read_kind(const table::JsonObject& ray) {
  const nlohmann::json* kind = ray.require("kind");
  if (kind != nullptr && *kind != "bend" && *kind != "range") {
    ray.reject("kind", *kind, R"("bend" or "range")");
  }
  return kind != nullptr && *kind == "bend" ? RayKind::bend : RayKind::range;
}

Ray read_ray(const table::JsonObject& from) {
  Ray ray;
  if (const nlohmann::json* name = from.require("name")) {
    ray.name = from.text("name").value_or("");
    if (!is_ray_name(ray.name)) {
      from.reject("name", *name, "letters, digits and _ . - only: it is part of column names");
    }
  }
  ray.mount = {from.number("mount_x_m").value_or(0.0), from.number("mount_y_m").value_or(0.0)};
  ray.bearing_rad = from.required_number("bearing_rad").value_or(0.0);
  ray.reach_m = from.required_number("reach_m").value_or(0.0);
  ray.kind = read_kind(from);
  if (ray.kind == RayKind::bend) {
    ray.calibration = read_calibration(from);
  } else if (const nlohmann::json* calibration = from.find("calibration")) {
    from.reject("calibration", *calibration, "none: a range ray reads the clearance itself");
  }
  return ray;
}

void read_rays(const table::JsonObject& bundle, Robot& robot, std::vector<RangeKeys>& keys) {
  const nlohmann::json* rays = bundle.require("rays");
  if (rays == nullptr) {
    return;
  }
  if (!rays->is_array() || rays->empty()) {
    bundle.reject("rays", *rays, "a list of at least one ray");
    return;
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < rays->size(); ++i) {
    const table::JsonObject from = bundle.child(
        "rays[" + std::to_string(i) + "]", (*rays)[i], names_at("ray", bundle_fields()));
    robot.rays.push_back(read_ray(from));
    keys.push_back(read_range_keys(from, robot.rays.back().kind));
    const std::string& name = robot.rays.back().name;
    if (!names.insert(table::case_folded(name)).second) {
      from.reject("name", name, "ray names that differ when case is folded");
    }
  }
}

std::optional<Region> read_disc(const table::JsonObject& region, const nlohmann::json& value) {
  const table::JsonObject from = region.child("disc", value, names_at("disc", bundle_fields()));
  const auto x = from.required_number("x_m");
  const auto y = from.required_number("y_m");
  const auto radius = from.required_number("radius_m");
  if (radius && !(*radius > 0.0)) {
    from.reject("radius_m", *radius, "a number above 0");
  }
  return Disc{{x.value_or(0.0), y.value_or(0.0)}, radius.value_or(0.0)};
}

std::optional<Region> read_polygon(const table::JsonObject& region, const nlohmann::json& value) {
  const std::string expectation = "a list of at least three points [x, y]";
  const nlohmann::json* list = region.list("polygon", is_point, expectation);
  if (list == nullptr) {
    return std::nullopt;
  }
  if (list->size() < 3) {
    region.reject("polygon", value, expectation);
  }
  Polygon polygon;
  for (const nlohmann::json& point : *list) {
    polygon.vertices.push_back({point[0].get<double>(), point[1].get<double>()});
  }
  return polygon;
}

std::optional<Region> read_region(const table::JsonObject& course, const std::string& key) {
  const nlohmann::json* value = course.find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  const table::JsonObject from = course.child(key, *value, names_at("region", bundle_fields()));
  const nlohmann::json* disc = from.find("disc");
  const nlohmann::json* polygon = from.find("polygon");
  if ((disc == nullptr) == (polygon == nullptr)) {
    course.reject(key, *value, "either a disc or a polygon");
    return std::nullopt;
  }
  return disc != nullptr ? read_disc(from, *disc) : read_polygon(from, *polygon);
}

void read_if_given(const table::JsonObject& from, const std::string& key, double& value) {
  value = from.number(key).value_or(value);
}

}  // namespace

Robot read_robot(const table::JsonObject& bundle, std::vector<RangeKeys>& keys) {
  Robot robot;
  if (const nlohmann::json* value = bundle.require("robot")) {
    const table::JsonObject from =
        bundle.child("robot", *value, names_at("robot", bundle_fields()));
    read_if_given(from, "body_width_m", robot.body_width_m);
    read_if_given(from, "min_turn_radius_m", robot.min_turn_radius_m);
    read_if_given(from, "tracking_buffer_m", robot.tracking_buffer_m);
    read_if_given(from, "curvature_buffer_per_m", robot.curvature_buffer_per_m);
  }
  read_rays(bundle, robot, keys);
  if (robot.body_width_m > kWideBody) {
    bundle.problems().add({table::Severity::warning,
                           "bundle.json",
                           0,
                           "robot.body_width_m",
                           to_text(robot.body_width_m),
                           "metres: millimetres, centimetres?",
                           1});
  }
  if (!bundle.problems().has_error()) {
    try {
      validate(robot);
    } catch (const std::invalid_argument& error) {
      bundle.problems().add({table::Severity::error,
                             "bundle.json",
                             0,
                             "robot",
                             error.what(),
                             "a robot within its ranges",
                             1});
    }
  }
  return robot;
}

Course read_course(const table::JsonObject& bundle) {
  Course course;
  if (const nlohmann::json* value = bundle.find("course")) {
    const table::JsonObject from =
        bundle.child("course", *value, names_at("course", bundle_fields()));
    course.start = read_region(from, "start");
    course.goal = read_region(from, "goal");
    if (course.start && course.goal && touch(*course.start, *course.goal)) {
      from.reject("goal",
                  value->at("goal"),
                  "a region apart from 'start': between regions that overlap there is no way to "
                  "certify");
    }
  }
  return course;
}

nlohmann::ordered_json ray_json(const Ray& ray, const RangeKeys& keys) {
  nlohmann::ordered_json out{{"name", ray.name},
                             {"mount_x_m", ray.mount.x_m},
                             {"mount_y_m", ray.mount.y_m},
                             {"bearing_rad", ray.bearing_rad},
                             {"reach_m", ray.reach_m},
                             {"kind", ray.kind == RayKind::bend ? "bend" : "range"}};
  if (ray.kind == RayKind::bend) {
    out["calibration"] = {{"bend_rad", ray.calibration.bend_rad},
                          {"clearance_m", ray.calibration.clearance_m}};
  }
  add_range_keys(keys, out);
  return out;
}

nlohmann::ordered_json region_json(const Region& region) {
  nlohmann::ordered_json out;
  if (const auto* disc = std::get_if<Disc>(&region)) {
    out["disc"] = {
        {"x_m", disc->centre.x_m}, {"y_m", disc->centre.y_m}, {"radius_m", disc->radius_m}};
    return out;
  }
  out["polygon"] = nlohmann::ordered_json::array();
  for (const Point& p : std::get<Polygon>(region).vertices) {
    out["polygon"].push_back({p.x_m, p.y_m});
  }
  return out;
}

}  // namespace tcert
