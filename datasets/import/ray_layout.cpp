#include "datasets/import/ray_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tcert/geometry.hpp>
#include <utility>

namespace tcert::recording {
namespace {

constexpr double kSameAngleRad = 1e-6;
constexpr double kSameLengthM = 1e-6;

double number_of(const nlohmann::json& ray, const char* key) {
  const auto found = ray.find(key);
  return found != ray.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::string text_of(const nlohmann::json& ray, const char* key) {
  const auto found = ray.find(key);
  return found != ray.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// What a ray says goes before what its stream says; their values that mean no return count both.
NoReturn together(const NoReturn& of_ray, const NoReturn& of_stream) {
  NoReturn rule = of_ray;
  rule.values.insert(rule.values.end(), of_stream.values.begin(), of_stream.values.end());
  rule.range_min_m = rule.range_min_m ? rule.range_min_m : of_stream.range_min_m;
  rule.range_max_m = rule.range_max_m ? rule.range_max_m : of_stream.range_max_m;
  return rule;
}

bool is_same_limit(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && std::abs(a.value_or(0) - b.value_or(0)) < kSameLengthM;
}

bool is_same_ray(const nlohmann::json& a, const nlohmann::json& b) {
  const double turned = number_of(a, "bearing_rad") - number_of(b, "bearing_rad");
  return text_of(a, "name") == text_of(b, "name") &&
         std::abs(wrapped_angle(turned)) < kSameAngleRad &&
         std::ranges::all_of(std::array{"mount_x_m", "mount_y_m", "reach_m"}, [&](auto* key) {
           return std::abs(number_of(a, key) - number_of(b, key)) < kSameLengthM;
         });
}

}  // namespace

bool ScanGeometry::has_beams_of(const ScanGeometry& other) const noexcept {
  return beams == other.beams && std::abs(angle_min_rad - other.angle_min_rad) < kSameAngleRad &&
         std::abs(angle_increment_rad - other.angle_increment_rad) < kSameAngleRad;
}

std::vector<std::string> RayLayout::column_names() const {
  std::vector<std::string> names;
  for (const RayColumns& ray : columns) {
    names.push_back(ray.name + (ray.bends ? "_bend_rad" : "_range_m"));
    if (ray.force.is_given()) {
      names.push_back(ray.name + "_fsr_n");
    }
  }
  return names;
}

RayLayout layout_of(const StreamSource& stream) {
  RayLayout layout;
  for (const MappedRay& mapped : stream.rays) {
    layout.columns.push_back({text_of(mapped.ray, "name"),
                              text_of(mapped.ray, "kind") == "bend",
                              number_of(mapped.ray, "reach_m"),
                              mapped.value,
                              mapped.force,
                              together(mapped.no_return, stream.no_return)});
    layout.rays.push_back(mapped.ray);
  }
  return layout;
}

RayLayout layout_of(const StreamSource& stream,
                    const ScanGeometry& geometry,
                    const std::string& prefix) {
  RayLayout layout;
  layout.geometry = geometry;
  NoReturn no_return = stream.no_return;
  no_return.range_min_m = no_return.range_min_m ? no_return.range_min_m : geometry.range_min_m;
  no_return.range_max_m = no_return.range_max_m ? no_return.range_max_m : geometry.range_max_m;
  // What the sensor cannot see is not known to be free.
  const double asked_m = stream.scan->reach_m.value_or(geometry.range_max_m.value_or(0.0));
  const double reach_m = std::min(asked_m, geometry.range_max_m.value_or(asked_m));
  const ScanOffset& offset = geometry.offset;
  for (std::size_t i = 0; i < geometry.beams; i += stream.scan->every) {
    const double turned = geometry.angle_min_rad +
                          static_cast<double>(i) * geometry.angle_increment_rad + offset.yaw_rad;
    const std::string name = fmt::format("{}{:03}", prefix, i);
    layout.columns.push_back({name, false, reach_m, {{"#"}, 1.0, 0.0}, {}, no_return});
    layout.rays.push_back({{"name", name},
                           {"kind", "range"},
                           {"mount_x_m", offset.x_m},
                           {"mount_y_m", offset.y_m},
                           {"bearing_rad", wrapped_angle(turned)},
                           {"reach_m", reach_m}});
  }
  return layout;
}

std::string in_words(const ScanGeometry& scan) {
  const auto limit = [](const std::optional<double>& value) {
    return value ? fmt::format("{:g}", *value) : std::string("?");
  };
  return fmt::format("{} beams from {:g} rad by {:g}, {} to {} m, at ({:g}, {:g}, {:g})",
                     scan.beams,
                     scan.angle_min_rad,
                     scan.angle_increment_rad,
                     limit(scan.range_min_m),
                     limit(scan.range_max_m),
                     scan.offset.x_m,
                     scan.offset.y_m,
                     scan.offset.yaw_rad);
}

bool are_same_rays(const RayLayout& a, const RayLayout& b) {
  return std::ranges::equal(a.rays, b.rays, is_same_ray) &&
         std::ranges::equal(a.columns, b.columns, [](auto& one, auto& other) {
           return is_same_limit(one.no_return.range_min_m, other.no_return.range_min_m) &&
                  is_same_limit(one.no_return.range_max_m, other.no_return.range_max_m);
         });
}

}  // namespace tcert::recording
