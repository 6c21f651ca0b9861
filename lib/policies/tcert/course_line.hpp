#pragma once
/// \file
/// The line of a course: its lobes in the order in which they are driven, and of each the lanes.

#include <tcert/geometry.hpp>
#include <vector>

namespace tcert::policies {

/// A polyline of way-points from where the lobe is entered to where it is left.
using LaneLine = std::vector<Point>;

/// Ways past the same obstacle. The first is taken; the others, in turn, where it is given up.
struct Lobe {
  std::vector<LaneLine> lanes;
};

/// In the frame of the odometry, in metres. Without lobes a policy aims at G alone.
struct CourseLine {
  std::vector<Lobe> lobes;
  Point low;  ///< Corners of the upright box that the course lies in; grids cover it and no more.
  Point high;
};

inline constexpr std::size_t kMostLobes = 256;
inline constexpr std::size_t kMostLanes = 16;             ///< Of one lobe.
inline constexpr std::size_t kMostWayPoints = 1U << 16U;  ///< Of all lanes together.

/// \throws std::invalid_argument unless the box has an inside, there are no more lobes, lanes and
/// way-points than above, every lobe has a lane, and every lane at least two way-points that lie in
/// the box, no two in a row the same.
void validate(const CourseLine& line);

}  // namespace tcert::policies
