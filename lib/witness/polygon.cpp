#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>
#include <witness/polygon.hpp>

namespace tcert::witness {
namespace {

constexpr double kStraight = 1e-9;  // rad
// A shorter straight piece has no heading to speak of.
constexpr double kShortest = 1e-5;  // m

double turn_at(Point a, Point b, Point c) noexcept {
  const Point u = b - a;
  const Point v = c - b;
  return elementary::atan2(cross(u, v), dot(u, v));
}

}  // namespace

std::vector<Point> resampled(const std::vector<Point>& polygon, double spacing_m) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    length_m += distance(polygon[i - 1], polygon[i]);
  }
  const double pieces = std::max(2.0, std::ceil(length_m / spacing_m));
  std::vector<Point> points{polygon.front()};
  std::size_t k = 1;
  double done_m = 0.0;
  for (std::size_t i = 1; static_cast<double>(i) < pieces; ++i) {
    const double want_m = length_m * static_cast<double>(i) / pieces;
    double edge_m = distance(polygon[k - 1], polygon[k]);
    while (k + 1 < polygon.size() && done_m + edge_m < want_m) {
      done_m += edge_m;
      ++k;
      edge_m = distance(polygon[k - 1], polygon[k]);
    }
    const double share = edge_m > 0.0 ? std::min(1.0, (want_m - done_m) / edge_m) : 0.0;
    points.push_back(polygon[k - 1] + share * (polygon[k] - polygon[k - 1]));
  }
  points.push_back(polygon.back());
  return points;
}

std::vector<Point> refined(const std::vector<Point>& polygon) {
  std::vector<Point> points{polygon.front()};
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const Point edge = polygon[i] - polygon[i - 1];
    points.push_back(polygon[i - 1] + 0.25 * edge);
    points.push_back(polygon[i - 1] + 0.75 * edge);
  }
  points.push_back(polygon.back());
  return points;
}

Path path_of(const std::vector<Point>& polygon) {
  Path path;
  Point at = polygon.front();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point b = polygon[i];
    const double turn = turn_at(polygon[i - 1], b, polygon[i + 1]);
    if (std::abs(turn) < kStraight) {
      continue;
    }
    const Point in = b - at;
    const Point out = polygon[i + 1] - b;
    // An arc takes half of the edge after it, and all that is left of the one before.
    double taken_m = std::min(norm(in), 0.5 * norm(out));
    if (norm(in) - taken_m > kShortest) {
      const Point begins = b - (taken_m / norm(in)) * in;
      path.push_back({at, begins, 0.0});
      at = begins;
    } else {
      taken_m = norm(in);
    }
    const Point leaves = b + (taken_m / norm(out)) * out;
    path.push_back({at, leaves, turn});
    at = leaves;
  }
  if (distance(at, polygon.back()) > 0.0) {
    path.push_back({at, polygon.back(), 0.0});
  }
  return path;
}

double corner_radius(Point a, Point b, Point c) noexcept {
  const double turn = std::abs(turn_at(a, b, c));
  return turn < kStraight
             ? std::numeric_limits<double>::infinity()
             : 0.5 * std::min(distance(a, b), distance(b, c)) / elementary::tan(0.5 * turn);
}

Estimate estimate(const std::vector<Point>& polygon,
                  const DistanceField& field,
                  const Robot& robot) {
  Estimate found;
  found.clearance_m = std::min(field.at(polygon.front()), field.at(polygon.back()));
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    found.clearance_m = std::min(found.clearance_m, field.at(0.5 * (polygon[i - 1] + polygon[i])));
    if (i + 1 < polygon.size()) {
      const Point top = 0.125 * (polygon[i - 1] + 6.0 * polygon[i] + polygon[i + 1]);
      found.clearance_m = std::min(found.clearance_m, field.at(top));
      found.turn_radius_m =
          std::min(found.turn_radius_m, corner_radius(polygon[i - 1], polygon[i], polygon[i + 1]));
    }
  }
  const double curvature = 1.0 / found.turn_radius_m + robot.curvature_buffer_per_m;
  found.margin_m =
      std::min(2.0 * found.clearance_m - robot.body_width_m - 2.0 * robot.tracking_buffer_m,
               (curvature > 0.0 ? 1.0 / curvature : std::numeric_limits<double>::infinity()) -
                   robot.min_turn_radius_m);
  return found;
}

double needed_clearance(const Robot& robot, double margin_m) noexcept {
  return 0.5 * (robot.body_width_m + margin_m) + robot.tracking_buffer_m;
}

double needed_radius(const Robot& robot, double margin_m) noexcept {
  const double curvature =
      1.0 / (robot.min_turn_radius_m + std::max(margin_m, 1e-6)) - robot.curvature_buffer_per_m;
  return curvature > 0.0 ? 1.0 / curvature : std::numeric_limits<double>::infinity();
}

}  // namespace tcert::witness
