#pragma once
/// \file
/// A lower bound of T(E; A) with the turning limit: a good path, found and then measured.

#include <tcert/robot.hpp>
#include <vector>

#include "analysis/study/truth/arc.hpp"
#include "analysis/study/truth/clearance_value.hpp"
#include "analysis/study/truth/slack.hpp"
#include "datasets/world.hpp"

namespace tcert::study {

struct CurvatureOptions {
  SlackConvention convention = SlackConvention::width;
  double cell_m = 0.1;    ///< Of the lattice of positions; one pose is kept per cell and heading.
  int headings = 48;      ///< Per turn.
  double table_m = 0.04;  ///< Spacing of the table of clearances that the search looks up.
  int rounds = 3;         ///< Each after the first asks for more than the last found.
  double path_cell_m = 0.01;  ///< In which the path is stretched at the end; 0: it is not.
};

struct CurvatureValue {
  double slack_m = ClearanceValue::kNoPath;  ///< Minus infinity: no path was found.
  double clearance_m = 0.0;                  ///< Of the path, at least.
  double radius_m = 0.0;                     ///< Its smallest; infinite if it is straight.
  std::vector<Arc> path;                     ///< Begins in S with any heading and ends in G.
};

/// Max-min search over (x, y, yaw): from every pose in S, arcs of curvature 0 and +-1/r go to where
/// they really end, and the first pose to arrive in a cell of the lattice stands for it. An arc is
/// worth min(least clearance slack along it, r - R_min). Radii below R_min are tried too, when no
/// better path is found: a negative value says by how much the robot turns too widely.
///
/// The search looks clearances up in a table; what is returned does not: the arcs of the path that
/// it finds are measured on the exact distances, so slack_m is attained and thus a lower bound.
/// Values above `upper_m`, which no path exceeds, count as that. Rounds after the first refine the
/// radii above the value found. At the end a path is stretched in cells of `path_cell_m`, from that
/// of the search and from the widest route, measured likewise, and kept if it is worth more.
///
/// O(cells x headings x radii) a round.
/// \throws std::invalid_argument if S or G is missing or the lattice would have more than 2^28
/// poses.
[[nodiscard]] CurvatureValue curvature_value(const World& world,
                                             const Robot& robot,
                                             double upper_m,
                                             const CurvatureOptions& options = {});

}  // namespace tcert::study
