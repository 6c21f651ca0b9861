#pragma once
/// \file
/// The course: a figure-8 of lanes, its gates, and the walls that both make.

#include <cstdint>
#include <tcert/geometry.hpp>
#include <tcert/region.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

/// One of the four lanes, which lead from S or from G to the crossing.
struct Lane {
  bool at_goal = false;  ///< Round the second post, which G lies behind; else round the first.
  bool upper = false;    ///< Over the post (y > 0); else under it.
  friend bool operator==(Lane, Lane) = default;
};

/// Two posts 4.8 m apart on the x axis, lanes of one width round them at `radius_m`, joined by the
/// tangents that cross at the origin at 2 asin(radius / 2.4), 29 to 49 degrees for radii of
/// 0.6 to 1.0 m. S lies behind the first post, G behind the second.
struct FigureEight {
  double radius_m = 0.8;
  double lane_width_m = 1.2;
};

/// A narrowing of a lane by two jaws.
struct Gate {
  Lane lane;
  double along_m = 0.0;   ///< Of its middle, along the centre line from the lane's outer end.
  double offset_m = 0.0;  ///< Of its middle from the centre line, left of the way to the crossing.
  double width_m = 0.0;   ///< Free width between the jaws.
  double length_m = 0.0;
};

/// S and G are the same for every trial.
[[nodiscard]] Region course_start();
[[nodiscard]] Region course_goal();

/// Length of a lane's centre line, outer end to crossing.
[[nodiscard]] double lane_length(const FigureEight& course);

/// How far along a lane both of its walls stand; beyond it the crossing is open to one side.
[[nodiscard]] double walled_length(const FigureEight& course);

/// Point of a lane's centre line and heading towards the crossing. \pre 0 <= along_m <= its length.
[[nodiscard]] Pose lane_pose(const FigureEight& course, Lane lane, double along_m);

/// Everything that stands: two islands, the outer walls, the jaws; vertices rounded to 0.1 mm.
[[nodiscard]] World build_world(const FigureEight& course, const std::vector<Gate>& gates);

}  // namespace tcert
