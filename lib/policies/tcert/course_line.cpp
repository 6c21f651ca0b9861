#include <algorithm>
#include <stdexcept>
#include <string>
#include <tcert/course_line.hpp>
#include <tcert/tick.hpp>

namespace tcert::policies {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) {
    throw std::invalid_argument("course line: " + what);
  }
}

bool lies_in(Point p, Point low, Point high) {
  return p.x_m >= low.x_m && p.x_m <= high.x_m && p.y_m >= low.y_m && p.y_m <= high.y_m;
}

}  // namespace

void validate(const CourseLine& line) {
  constexpr Point kFar{kLargestPose, kLargestPose};
  require(lies_in(line.low, -1.0 * kFar, kFar) && lies_in(line.high, -1.0 * kFar, kFar) &&
              line.low.x_m < line.high.x_m && line.low.y_m < line.high.y_m,
          "low must lie left of and below high");
  require(line.lobes.size() <= kMostLobes,
          "there are more than " + std::to_string(kMostLobes) + " lobes");
  std::size_t way_points = 0;
  for (std::size_t i = 0; i < line.lobes.size(); ++i) {
    const auto& lanes = line.lobes[i].lanes;
    const std::string name = "lobe " + std::to_string(i);
    require(!lanes.empty() && lanes.size() <= kMostLanes,
            name + " needs from 1 to " + std::to_string(kMostLanes) + " lanes");
    for (const LaneLine& lane : lanes) {
      way_points += lane.size();
      require(lane.size() >= 2, name + ": a lane needs at least two way-points");
      require(
          std::all_of(
              lane.begin(), lane.end(), [&](Point p) { return lies_in(p, line.low, line.high); }),
          name + ": a way-point lies outside of the box from low to high");
      require(std::adjacent_find(lane.begin(), lane.end()) == lane.end(),
              name + ": two way-points in a row are the same");
    }
  }
  require(way_points <= kMostWayPoints,
          "there are more than " + std::to_string(kMostWayPoints) + " way-points");
}

}  // namespace tcert::policies
