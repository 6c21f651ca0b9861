#include <cmath>
#include <limits>
#include <numbers>
#include <witness/waypoint.hpp>

namespace tcert::witness {
namespace {

constexpr double kMostBreak = 1e-7;  // rad: two of them are no corner

}  // namespace

double heading_of_leaving(const Pose& waypoint, Side side) noexcept {
  return side == Side::front ? waypoint.yaw_rad : waypoint.yaw_rad + std::numbers::pi;
}

double heading_of_entering(const Pose& waypoint, Side side) noexcept {
  return heading_of_leaving(waypoint, opposite(side));
}

bool is_near(Point place,
             const Node& node,
             const Region& start,
             const Region& goal,
             double merge_radius_m) noexcept {
  const auto share = [&](const Region& region) {
    return contains(region, node.pose.position) && contains(region, place);
  };
  return distance(place, node.pose.position) <= merge_radius_m || share(start) || share(goal);
}

Checked check_edge(const Checker& checker,
                   const Path& path,
                   const Edge& edge,
                   std::span<const Pose> waypoints,
                   const Robot& robot) {
  const Pose& from = waypoints[edge.ends[0].node];
  const Pose& to = waypoints[edge.ends[1].node];
  const auto is_along = [](double heading_rad, double wanted_rad) {
    return std::abs(angle_between(heading_rad, wanted_rad)) <= kMostBreak;
  };
  const bool leads =
      !path.empty() && path.front().from == from.position && path.back().to == to.position &&
      is_along(heading_from(path.front()), heading_of_leaving(from, edge.ends[0].side)) &&
      is_along(heading_to(path.back()), heading_of_entering(to, edge.ends[1].side));
  if (!leads) {
    return {"the path does not lead from waypoint to waypoint",
            -std::numeric_limits<double>::infinity(),
            0.0,
            0.0,
            {}};
  }
  return checker.check(path, Disc{from.position, 0.0}, Disc{to.position, 0.0}, robot);
}

}  // namespace tcert::witness
