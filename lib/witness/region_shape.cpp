#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/segment.hpp>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

constexpr double kInside = 1e-6;  // m, from the border

}  // namespace

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

RowOfRegion::RowOfRegion(const Region& region, double middle_y_m, double half_diagonal_m)
    : disc_(std::get_if<Disc>(&region)) {
  const auto* const polygon = std::get_if<Polygon>(&region);
  for (std::size_t i = 0; polygon != nullptr && i < polygon->vertices.size(); ++i) {
    const auto& v = polygon->vertices;
    const Edge edge{v[(i + v.size() - 1) % v.size()], v[i]};
    const auto [low_m, high_m] = std::minmax(edge.from.y_m, edge.to.y_m);
    if (low_m - 2.0 * half_diagonal_m <= middle_y_m &&
        middle_y_m <= high_m + 2.0 * half_diagonal_m) {
      near_.push_back(edge);
    }
  }
}

bool RowOfRegion::covers(const Box& box) const noexcept {
  if (disc_ != nullptr) {
    const double dx = std::max(disc_->centre.x_m - box.low.x_m, box.high.x_m - disc_->centre.x_m);
    const double dy = std::max(disc_->centre.y_m - box.low.y_m, box.high.y_m - disc_->centre.y_m);
    return dx * dx + dy * dy <= disc_->radius_m * disc_->radius_m;
  }
  const Point middle = 0.5 * (box.low + box.high);
  const double radius_m = distance(middle, box.low);
  bool inside = false;
  for (const Edge& edge : near_) {
    if (distance_to_segment(middle, edge.from, edge.to) <= radius_m) {
      return false;
    }
    const bool straddles = (edge.to.y_m > middle.y_m) != (edge.from.y_m > middle.y_m);
    if (straddles && middle.x_m < edge.to.x_m + (middle.y_m - edge.to.y_m) /
                                                    (edge.from.y_m - edge.to.y_m) *
                                                    (edge.from.x_m - edge.to.x_m)) {
      inside = !inside;
    }
  }
  return inside;
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
