#include "analysis/truth/region_distance.hpp"

#include <algorithm>
#include <limits>

namespace tcert {

Point nearest_on_segment(Point a, Point b, Point p) noexcept {
  const Point along = b - a;
  const double squared = dot(along, along);
  if (squared == 0.0) {
    return a;
  }
  return a + std::clamp(dot(p - a, along) / squared, 0.0, 1.0) * along;
}

double region_distance(const Region& region, Point p) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return std::max(distance(p, disc->centre) - disc->radius_m, 0.0);
  }
  if (contains(region, p)) {
    return 0.0;
  }
  const auto& v = std::get_if<Polygon>(&region)->vertices;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    least = std::min(least, distance(p, nearest_on_segment(v[j], v[i], p)));
  }
  return least;
}

Extent extent_of(const Region& region) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    const Point r{disc->radius_m, disc->radius_m};
    return {disc->centre - r, disc->centre + r};
  }
  const auto& v = std::get_if<Polygon>(&region)->vertices;
  Extent extent{v.front(), v.front()};
  for (const Point p : v) {
    extent.low = {std::min(extent.low.x_m, p.x_m), std::min(extent.low.y_m, p.y_m)};
    extent.high = {std::max(extent.high.x_m, p.x_m), std::max(extent.high.y_m, p.y_m)};
  }
  return extent;
}

}  // namespace tcert
