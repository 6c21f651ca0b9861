#include "datasets/values/check_sides.hpp"

#include <cmath>
#include <string>
#include <table/nearest_name.hpp>
#include <vector>

#include "datasets/ray_names.hpp"

namespace tcert {
namespace {

constexpr double kAside = 0.1;   // of the sine of a bearing: what looks ahead is of either side
constexpr double kSquare = 0.7;  // the same: what looks to a side looks there mostly
constexpr double kLeastOffset = 0.02;  // m, of a mount that is on a side

/// 1 of a name with "left" in it, -1 of one with "right", 0 of both and none.
int side_of(const std::string& name) {
  const std::string folded = table::case_folded(name);
  const bool left = folded.find("left") != std::string::npos;
  const bool right = folded.find("right") != std::string::npos;
  return left == right ? 0 : left ? 1 : -1;
}

}  // namespace

std::optional<table::Diagnostic> check_sides(const Robot& robot) {
  std::vector<std::string> wrong;
  for (const Ray& ray : robot.rays) {
    const int side = side_of(ray.name);
    const bool looks_away = side * std::sin(ray.bearing_rad) < -kAside;
    const bool is_mounted_there = side * ray.mount.y_m > 0.0;
    // Square to the heading, over the body that it is mounted on.
    const bool looks_across_the_body =
        std::abs(ray.mount.y_m) > kLeastOffset &&
        std::copysign(1.0, ray.mount.y_m) * std::sin(ray.bearing_rad) < -kSquare;
    if ((looks_away && !is_mounted_there) || looks_across_the_body) {
      wrong.push_back(ray.name);
    }
  }
  if (wrong.empty()) {
    return std::nullopt;
  }
  return table::Diagnostic{
      table::Severity::warning,
      "bundle.json",
      0,
      "rays",
      joined_names(wrong) + (wrong.size() == 1 ? " looks to the other side, or over the body"
                                               : " look to the other sides, or over the body"),
      "bearings anticlockwise from ahead, 1.5708 to the left, and mounts with y to the left",
      1};
}

}  // namespace tcert
