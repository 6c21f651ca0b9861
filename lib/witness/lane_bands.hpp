#pragma once
/// \file
/// Bands along the lanes of a corridor graph: where they cross the nodes' lines lie the waypoints.

#include <span>
#include <tcert/corridor_graph.hpp>
#include <tcert/robot.hpp>
#include <vector>
#include <witness/lanes.hpp>
#include <witness/search_space.hpp>

namespace tcert::witness {

/// A corridor graph of a run, and where paths along it are looked for.
struct EdgeProblem {
  const SearchSpace& space;
  std::span<const Node> nodes;
  std::span<const Edge> edges;
  const Region& start;
  const Region& goal;
  const Robot& robot;
};

/// Where the paths of edges lead.
struct EdgeWays {
  std::vector<Pose> waypoints;           ///< By node, about along its heading.
  std::vector<std::vector<Point>> ways;  ///< By edge, from its end 0 to its end 1.
};

/// A polygon from one pose to the other whose first two points, and last two, keep the headings:
/// the way, shifted to them, and smooth in between. \pre two points or more; the poses are apart.
[[nodiscard]] std::vector<Point> polygon_between(const Pose& from,
                                                 const Pose& to,
                                                 std::vector<Point> way);

/// Stretches bands along lanes and moves ways and waypoints onto them. A waypoint is where a band
/// crosses its node's line, or ends, so near that is_near() holds.
class LaneBands {
 public:
  /// `ways` holds the nodes' poses and ways along the edges, and outlives it; `steps` of the band
  /// are taken along four edges, at most.
  LaneBands(const EdgeProblem& problem, double merge_radius_m, int steps, EdgeWays& ways);

  /// A band along the whole lane, its ends free near their nodes. Where it would pass a node too
  /// far off the lane is cut. O(edges^2 steps) at worst, O(edges steps) where it is not cut.
  void stretch_lane(std::span<const EdgeStep> lane);

  /// A band between the waypoints at the ends of some steps of a lane, those held; if it passes a
  /// node in between too far off, all stays as it is.
  void stretch_between(std::span<const EdgeStep> steps);

 private:
  [[nodiscard]] std::vector<Point> joined(std::span<const EdgeStep> steps) const;
  [[nodiscard]] Region end_region(std::uint32_t node, EdgeStep step) const;
  [[nodiscard]] double most_across(std::uint32_t node) const;
  std::size_t take(std::span<const EdgeStep> steps, const std::vector<Point>& polygon);
  void end_at(const EdgeEnd& end, Point position, Point outward);

  const EdgeProblem& problem_;
  double merge_radius_m_;
  int steps_;
  EdgeWays& found_;
  std::vector<bool> is_crossed_;  // by node: by a band that leads on, which an end does not move
};

}  // namespace tcert::witness
