#include "datasets/worlds/region_distance.hpp"

#include <algorithm>
#include <limits>
#include <tcert/segment.hpp>

namespace tcert {

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
    least = std::min(least, distance_to_segment(p, v[j], v[i]));
  }
  return least;
}

bool segments_meet(Point a, Point b, Point c, Point d) noexcept {
  // Of segments that are all but collinear the signs below are rounding.
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x_m, b.x_m, c.x_m, d.x_m) || apart(a.y_m, b.y_m, c.y_m, d.y_m)) {
    return false;
  }
  const auto side = [](Point p, Point q, Point r) {
    const double turn = cross(q - p, r - p);
    return turn > 0.0 ? 1 : (turn < 0.0 ? -1 : 0);
  };
  const auto within = [](Point p, Point q, Point r) {  // r on the line p-q
    return std::min(p.x_m, q.x_m) <= r.x_m && r.x_m <= std::max(p.x_m, q.x_m) &&
           std::min(p.y_m, q.y_m) <= r.y_m && r.y_m <= std::max(p.y_m, q.y_m);
  };
  const int of_c = side(a, b, c);
  const int of_d = side(a, b, d);
  const int of_a = side(c, d, a);
  const int of_b = side(c, d, b);
  if (of_c * of_d < 0 && of_a * of_b < 0) {
    return true;
  }
  return (of_c == 0 && within(a, b, c)) || (of_d == 0 && within(a, b, d)) ||
         (of_a == 0 && within(c, d, a)) || (of_b == 0 && within(c, d, b));
}

double region_gap(const Region& a, const Region& b) noexcept {
  if (const auto* disc = std::get_if<Disc>(&a)) {
    return std::max(region_distance(b, disc->centre) - disc->radius_m, 0.0);
  }
  if (std::holds_alternative<Disc>(b)) {
    return region_gap(b, a);
  }
  const auto& v = std::get_if<Polygon>(&a)->vertices;
  const auto& w = std::get_if<Polygon>(&b)->vertices;
  if (contains(a, w.front()) || contains(b, v.front())) {
    return 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    for (std::size_t k = 0, m = w.size() - 1; k < w.size(); m = k++) {
      if (segments_meet(v[j], v[i], w[m], w[k])) {
        return 0.0;
      }
      least = std::min(
          {least, distance_to_segment(v[i], w[m], w[k]), distance_to_segment(w[k], v[j], v[i])});
    }
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
