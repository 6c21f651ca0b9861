#include "datasets/values/check_sides.hpp"

#include <cmath>
#include <string>
#include <table/nearest_name.hpp>
#include <utility>
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
  std::vector<std::string> over_the_body;
  std::size_t outwards = 0;
  for (const Ray& ray : robot.rays) {
    const int side = side_of(ray.name);
    const bool looks_away = side * std::sin(ray.bearing_rad) < -kAside;
    const bool is_mounted_there = side * ray.mount.y_m > 0.0;
    if (looks_away && !is_mounted_there) {
      wrong.push_back(ray.name);
    }
    const bool is_aside =
        std::abs(ray.mount.y_m) > kLeastOffset && std::abs(std::sin(ray.bearing_rad)) > kSquare;
    if (is_aside && ray.mount.y_m * std::sin(ray.bearing_rad) < 0.0) {
      over_the_body.push_back(ray.name);
    } else if (is_aside) {
      ++outwards;
    }
  }
  // One ray may look across the body on purpose; where all do, the sides are taken for each other.
  if (wrong.empty() && over_the_body.size() > 1 && outwards == 0) {
    wrong = std::move(over_the_body);
  }
  if (wrong.empty()) {
    return std::nullopt;
  }
  return table::Diagnostic{
      table::Severity::warning,
      "bundle.json",
      0,
      "rays",
      joined_names(wrong) + (wrong.size() == 1 ? " on the other side" : " on the other sides"),
      "bearings anticlockwise from ahead, 1.5708 to the left, and mounts with y to the left",
      1};
}

}  // namespace tcert
