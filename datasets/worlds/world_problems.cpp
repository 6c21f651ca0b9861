#include "datasets/worlds/world_problems.hpp"

#include <fmt/format.h>

#include <optional>

#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

/// Index of an edge that meets one it is not joined to, or turns back on the one before it.
std::optional<std::size_t> crossing_edge(const Polygon& polygon) {
  const auto& v = polygon.vertices;
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = v[i];
    const Point b = v[(i + 1) % n];
    const Point c = v[(i + 2) % n];
    if (a == b || (cross(b - a, c - b) == 0.0 && dot(b - a, c - b) < 0.0)) {
      return i;
    }
    for (std::size_t j = i + 2; j < n; ++j) {
      const bool joined = i == 0 && j == n - 1;
      if (!joined && segments_meet(a, b, v[j], v[(j + 1) % n])) {
        return i;
      }
    }
  }
  return std::nullopt;
}

void check_region(const World& world,
                  const std::optional<Region>& region,
                  const char* name,
                  std::vector<std::string>& problems) {
  if (!region) {
    problems.push_back(fmt::format("a {}", name));
    return;
  }
  const Extent extent = extent_of(*region);
  if (extent.low.x_m < world.bounds.low.x_m || extent.low.y_m < world.bounds.low.y_m ||
      extent.high.x_m > world.bounds.high.x_m || extent.high.y_m > world.bounds.high.y_m) {
    problems.push_back(fmt::format("the {} inside the bounds", name));
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (region_gap(*region, world.obstacles[i]) <= 0.0) {
      problems.push_back(
          fmt::format("a {} free of obstacles, but it touches obstacles[{}]", name, i));
      return;
    }
  }
}

}  // namespace

std::vector<std::string> world_problems(const World& world) {
  std::vector<std::string> problems;
  if (world.obstacles.empty()) {
    problems.emplace_back("an obstacle, but the world is empty");
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (const auto* polygon = std::get_if<Polygon>(&world.obstacles[i])) {
      if (const auto edge = crossing_edge(*polygon)) {
        problems.push_back(fmt::format(
            "a simple polygon, but edge {} of obstacles[{}] crosses or touches another", *edge, i));
      }
    }
  }
  for (const auto& [region, name] : {std::pair(&world.start, "start"), {&world.goal, "goal"}}) {
    if (*region) {
      if (const auto* polygon = std::get_if<Polygon>(&**region)) {
        if (crossing_edge(*polygon)) {
          problems.push_back(fmt::format("a simple polygon as {}, but it crosses itself", name));
        }
      }
    }
    check_region(world, *region, name, problems);
  }
  if (world.start && world.goal && region_gap(*world.start, *world.goal) <= 0.0) {
    problems.emplace_back("start and goal apart from each other, but they overlap or touch");
  }
  return problems;
}

}  // namespace tcert
