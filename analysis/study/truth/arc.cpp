#include "analysis/study/truth/arc.hpp"

#include <algorithm>
#include <cmath>

namespace tcert::study {
namespace {

/// Lowers `least` to the clearance of [from, from + length] unless that cannot lower it by more
/// than the tolerance.
void lower_to(const Arc& arc,
              double from,
              double length,
              const ObstacleDistance& obstacles,
              double tolerance,
              double& least) noexcept {
  const double middle = obstacles.at(pose_at(arc, from + 0.5 * length).position);
  least = std::min(least, middle);
  if (least <= 0.0 || middle - 0.5 * length >= least - tolerance) {
    return;
  }
  lower_to(arc, from, 0.5 * length, obstacles, tolerance, least);
  lower_to(arc, from + 0.5 * length, 0.5 * length, obstacles, tolerance, least);
}

}  // namespace

Pose pose_at(const Arc& arc, double along_m) noexcept {
  // The chord of an arc has the heading of its middle, and its length is s sin(x) / x, x half the
  // angle turned.
  const double half = 0.5 * arc.curvature_per_m * along_m;
  const double chord = std::abs(half) < 1e-9 ? along_m : along_m * std::sin(half) / half;
  return {arc.from.position + chord * direction(arc.from.yaw_rad + half),
          arc.from.yaw_rad + 2.0 * half};
}

double arc_clearance(const Arc& arc,
                     const ObstacleDistance& obstacles,
                     double tolerance_m) noexcept {
  double least = obstacles.at(arc.from.position);
  lower_to(arc, 0.0, arc.length_m, obstacles, tolerance_m, least);
  return std::max(least - tolerance_m, 0.0);
}

}  // namespace tcert::study
