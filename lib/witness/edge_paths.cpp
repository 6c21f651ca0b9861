#include <algorithm>
#include <utility>
#include <witness/driven_route.hpp>
#include <witness/edge_paths.hpp>
#include <witness/polygon.hpp>
#include <witness/tried_polygon.hpp>
#include <witness/waypoint.hpp>

namespace tcert::witness {
namespace {

constexpr double kNear = 0.08;  // m, from a node to the position driven that its way begins at
constexpr std::size_t kLongestLane = 64;  // edges that one band leads along
constexpr std::size_t kFour = 4;
constexpr int kLevels = 2;
constexpr std::size_t kHeld = 2;
constexpr double kShortest = 0.001;  // m

/// The nodes' poses, and the ways driven between them.
EdgeWays driven_ways(const EdgeProblem& problem, const Samples& samples, double longest_way_m) {
  EdgeWays found;
  for (const Node& node : problem.nodes) {
    found.waypoints.push_back(node.pose);
  }
  const DrivenPositions driven(samples);
  for (const Edge& edge : problem.edges) {
    const Point from = problem.nodes[edge.ends[0].node].pose.position;
    const Point to = problem.nodes[edge.ends[1].node].pose.position;
    const double near_m = std::min(kNear, 0.4 * distance(from, to));
    std::vector<Point> way{from};
    const std::vector<Point> between =
        driven.route(Disc{from, near_m}, Disc{to, near_m}, longest_way_m);
    way.insert(way.end(), between.begin(), between.end());
    way.push_back(to);
    found.ways.push_back(std::move(way));
  }
  return found;
}

EdgeWays stretched_ways(const EdgeProblem& problem,
                        const Samples& samples,
                        const EdgeSearchOptions& options) {
  EdgeWays found = driven_ways(problem, samples, options.longest_way_m);
  LaneBands bands(problem, options.merge_radius_m, options.steps, found);
  const std::vector<Lane> lanes = lanes_of(problem.nodes.size(), problem.edges);
  const auto part = [](const Lane& lane, std::size_t first, std::size_t most) {
    return std::span(lane).subspan(first, std::min(most, lane.size() - first));
  };
  for (const Lane& lane : lanes) {
    for (std::size_t i = 0; i < lane.size(); i += kLongestLane) {
      bands.stretch_lane(part(lane, i, kLongestLane));
    }
  }
  for (const Lane& lane : lanes) {
    for (std::size_t i = 0; i + 1 < lane.size(); i += kFour / 2) {
      bands.stretch_between(part(lane, i, kFour));
    }
  }
  return found;
}

}  // namespace

EdgePaths edge_paths(const EdgeProblem& problem,
                     const Samples& samples,
                     const EdgeSearchOptions& options) {
  EdgeWays ways = stretched_ways(problem, samples, options);
  EdgePaths found{std::move(ways.waypoints), {}};
  found.paths.resize(problem.edges.size());
  const SearchSpace& space = problem.space;
  for (std::size_t e = 0; e < problem.edges.size(); ++e) {
    const Edge& edge = problem.edges[e];
    Pose from = found.waypoints[edge.ends[0].node];
    Pose to = found.waypoints[edge.ends[1].node];
    if (distance(from.position, to.position) < kShortest) {
      continue;
    }
    from.yaw_rad = heading_of_leaving(from, edge.ends[0].side);
    to.yaw_rad = heading_of_entering(to, edge.ends[1].side);
    const Region start = Disc{from.position, 0.0};
    const Region goal = Disc{to.position, 0.0};
    // No path between two places is wider than those are.
    const double most_m =
        2.0 * (std::min(space.field.at(from.position), space.field.at(to.position)) -
               needed_clearance(problem.robot, 0.0));
    Found best;
    try_polygon(polygon_between(from, to, ways.ways[e]),
                {{most_m, most_m}, kLevels, options.steps},
                {space.field, start, goal, problem.robot, kHeld},
                space.checker,
                best);
    if (best.witness &&
        check_edge(space.checker, best.witness->path, edge, found.waypoints, problem.robot)
            .refused.empty()) {
      found.paths[e] = std::move(best.witness);
    }
  }
  return found;
}

}  // namespace tcert::witness
