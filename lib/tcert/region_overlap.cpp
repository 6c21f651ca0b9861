#include <algorithm>
#include <tcert/region_overlap.hpp>
#include <tcert/segment.hpp>
#include <variant>

namespace tcert {
namespace {

// Two segments that cross have ends on either side of each other; others are closest at an end.
bool segments_touch(Point a, Point b, Point c, Point d) noexcept {
  const bool crossing = (cross(b - a, c - a) > 0.0) != (cross(b - a, d - a) > 0.0) &&
                        (cross(d - c, a - c) > 0.0) != (cross(d - c, b - c) > 0.0);
  return crossing || distance_to_segment(a, c, d) == 0.0 || distance_to_segment(b, c, d) == 0.0 ||
         distance_to_segment(c, a, b) == 0.0 || distance_to_segment(d, a, b) == 0.0;
}

/// Whether `holds` is true of any edge (from, to).
template <class Predicate>
bool any_edge(const Polygon& polygon, Predicate holds) noexcept {
  const auto& v = polygon.vertices;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    if (holds(v[j], v[i])) {
      return true;
    }
  }
  return false;
}

Point point_in(const Disc& disc) noexcept { return disc.centre; }
Point point_in(const Polygon& polygon) noexcept { return polygon.vertices.front(); }

bool borders_touch(const Disc& a, const Disc& b) noexcept {
  return distance(a.centre, b.centre) <= a.radius_m + b.radius_m;
}

bool borders_touch(const Polygon& polygon, const Disc& disc) noexcept {
  return any_edge(polygon, [&](Point from, Point to) {
    return distance_to_segment(disc.centre, from, to) <= disc.radius_m;
  });
}

bool borders_touch(const Disc& disc, const Polygon& polygon) noexcept {
  return borders_touch(polygon, disc);
}

bool borders_touch(const Polygon& a, const Polygon& b) noexcept {
  return any_edge(a, [&](Point from, Point to) {
    return any_edge(b, [&](Point c, Point d) { return segments_touch(from, to, c, d); });
  });
}

/// What `holds` says of the disc or the polygon; unlike std::visit() it cannot throw.
template <class Predicate>
bool holds_of(const Region& region, Predicate holds) noexcept {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return holds(*disc);
  }
  return holds(*std::get_if<Polygon>(&region));
}

}  // namespace

bool touch(const Region& a, const Region& b) noexcept {
  return holds_of(a, [&](const auto& one) {
    return holds_of(b, [&](const auto& other) {
      return contains(a, point_in(other)) || contains(b, point_in(one)) ||
             borders_touch(one, other);
    });
  });
}

}  // namespace tcert
