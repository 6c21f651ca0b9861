#include <algorithm>
#include <cmath>
#include <limits>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

constexpr double kInside = 1e-6;  // m, from the border

Point nearest_on_segment(Point p, Point a, Point b) noexcept {
  const Point along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return a + t * along;
}

bool cross_each_other(Point a, Point b, Point c, Point d) noexcept {
  const auto side = [](Point from, Point to, Point p) { return cross(to - from, p - from); };
  return side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0 &&
         std::max(a.x_m, b.x_m) >= std::min(c.x_m, d.x_m) &&
         std::max(c.x_m, d.x_m) >= std::min(a.x_m, b.x_m) &&
         std::max(a.y_m, b.y_m) >= std::min(c.y_m, d.y_m) &&
         std::max(c.y_m, d.y_m) >= std::min(a.y_m, b.y_m);
}

double distance_to_border(const Polygon& polygon, Point p) noexcept {
  double least = std::numeric_limits<double>::infinity();
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    least = std::min(least, distance_to_segment(p, v[j], v[i]));
  }
  return least;
}

bool overlap(const Disc& disc, const Polygon& polygon) noexcept {
  return contains(Region(polygon), disc.centre) ||
         distance_to_border(polygon, disc.centre) <= disc.radius_m;
}

bool overlap(const Polygon& a, const Polygon& b) noexcept {
  if (contains(Region(a), b.vertices.front()) || contains(Region(b), a.vertices.front())) {
    return true;
  }
  for (std::size_t i = 0, j = a.vertices.size() - 1; i < a.vertices.size(); j = i++) {
    for (std::size_t k = 0, l = b.vertices.size() - 1; k < b.vertices.size(); l = k++) {
      if (cross_each_other(a.vertices[j], a.vertices[i], b.vertices[l], b.vertices[k])) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

double distance_to_segment(Point p, Point a, Point b) noexcept {
  return distance(p, nearest_on_segment(p, a, b));
}

Box bounding_box(const Region& region) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    const Point half{disc->radius_m, disc->radius_m};
    return {disc->centre - half, disc->centre + half};
  }
  const auto& vertices = std::get_if<Polygon>(&region)->vertices;
  Box box{vertices.front(), vertices.front()};
  for (const Point p : vertices) {
    box.low = {std::min(box.low.x_m, p.x_m), std::min(box.low.y_m, p.y_m)};
    box.high = {std::max(box.high.x_m, p.x_m), std::max(box.high.y_m, p.y_m)};
  }
  return box;
}

bool covers(const Region& region, const Box& box) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    const double dx = std::max(disc->centre.x_m - box.low.x_m, box.high.x_m - disc->centre.x_m);
    const double dy = std::max(disc->centre.y_m - box.low.y_m, box.high.y_m - disc->centre.y_m);
    return dx * dx + dy * dy <= disc->radius_m * disc->radius_m;
  }
  const Point middle = 0.5 * (box.low + box.high);
  return contains(region, middle) &&
         distance_to_border(*std::get_if<Polygon>(&region), middle) > distance(middle, box.low);
}

bool overlap(const Region& a, const Region& b) noexcept {
  const auto* const disc_a = std::get_if<Disc>(&a);
  const auto* const disc_b = std::get_if<Disc>(&b);
  if (disc_a != nullptr && disc_b != nullptr) {
    return distance(disc_a->centre, disc_b->centre) <= disc_a->radius_m + disc_b->radius_m;
  }
  if (disc_a != nullptr) {
    return overlap(*disc_a, *std::get_if<Polygon>(&b));
  }
  const Polygon& polygon = *std::get_if<Polygon>(&a);
  return disc_b != nullptr ? overlap(*disc_b, polygon)
                           : overlap(polygon, *std::get_if<Polygon>(&b));
}

Point nearest_within(const Region& region, Point p) noexcept {
  if (contains(region, p)) {
    return p;
  }
  if (const auto* disc = std::get_if<Disc>(&region)) {
    const double inner_m = std::max(0.0, disc->radius_m - kInside);
    return disc->centre + (inner_m / distance(p, disc->centre)) * (p - disc->centre);
  }
  const auto& v = std::get_if<Polygon>(&region)->vertices;
  Point nearest = v.front();
  Point along;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    const Point q = nearest_on_segment(p, v[j], v[i]);
    if (distance(p, q) < least) {
      least = distance(p, q);
      nearest = q;
      along = (1.0 / std::max(kInside, distance(v[j], v[i]))) * (v[i] - v[j]);
    }
  }
  const Point across{-along.y_m, along.x_m};
  for (const Point inward : {kInside * across,
                             -1.0 * kInside * across,
                             kInside * (across + along),
                             kInside * (across - along),
                             -1.0 * kInside * (across + along),
                             -1.0 * kInside * (across - along)}) {
    if (contains(region, nearest + inward)) {
      return nearest + inward;
    }
  }
  return nearest;
}

}  // namespace tcert::witness
