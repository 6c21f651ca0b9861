#pragma once
/// \file
/// The path that an open polygon stands for, and what it is worth.

#include <limits>
#include <tcert/robot.hpp>
#include <vector>
#include <witness/distance_field.hpp>
#include <witness/path.hpp>

namespace tcert::witness {

/// Points at most `spacing_m` apart along the polygon and equally far from each other along it, its
/// ends among them. \pre at least two points.
[[nodiscard]] std::vector<Point> resampled(const std::vector<Point>& polygon, double spacing_m);

/// Twice as many points, half as far apart: every corner is cut at a quarter of its edges, so that
/// turns are halved (Chaikin 1974). The ends stay.
[[nodiscard]] std::vector<Point> refined(const std::vector<Point>& polygon);

/// Each inner corner is rounded by an arc that leaves its edges at half of the shorter one, or up
/// to 0.01 mm later.
[[nodiscard]] Path path_of(const std::vector<Point>& polygon);

/// The radius of the arc at the corner `b`; infinity if it is none.
[[nodiscard]] double corner_radius(Point a, Point b, Point c) noexcept;

/// What the search goes by: an estimate of the margin, by the distance field at the middles of the
/// edges and the tops of the arcs. O(points).
struct Estimate {
  double clearance_m = 0.0;
  double turn_radius_m = std::numeric_limits<double>::infinity();
  double margin_m = 0.0;
};
[[nodiscard]] Estimate estimate(const std::vector<Point>& polygon,
                                const DistanceField& field,
                                const Robot& robot);

/// The clearance and the radius that a margin asks for, in m; an infinite radius if none will do.
[[nodiscard]] double needed_clearance(const Robot& robot, double margin_m) noexcept;
[[nodiscard]] double needed_radius(const Robot& robot, double margin_m) noexcept;

}  // namespace tcert::witness
