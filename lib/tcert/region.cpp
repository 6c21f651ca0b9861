#include <tcert/region.hpp>

namespace tcert {
namespace {

bool contains(const Disc& disc, Point p) noexcept {
  const Point d = p - disc.centre;
  return dot(d, d) <= disc.radius_m * disc.radius_m;
}

// Crossing number of the ray from p towards +x.
bool contains(const Polygon& polygon, Point p) noexcept {
  bool inside = false;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    const bool straddles = (v[i].y_m > p.y_m) != (v[j].y_m > p.y_m);
    if (!straddles) {
      continue;
    }
    const double x_m =
        v[i].x_m + (p.y_m - v[i].y_m) / (v[j].y_m - v[i].y_m) * (v[j].x_m - v[i].x_m);
    if (p.x_m < x_m) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace

bool contains(const Region& region, Point p) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return contains(*disc, p);
  }
  return contains(*std::get_if<Polygon>(&region), p);
}

}  // namespace tcert
