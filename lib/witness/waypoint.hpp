#pragma once
/// \file
/// Where the paths of edges pass the nodes of a corridor graph, and whether one does. Includes
/// nothing of the search.

#include <span>
#include <tcert/corridor_graph.hpp>
#include <tcert/region.hpp>
#include <tcert/robot.hpp>
#include <witness/checker.hpp>
#include <witness/path.hpp>

namespace tcert::witness {

/// Heading in rad of a path that leaves a waypoint by a side of its node, or enters by it. The yaw
/// of a waypoint is that of leaving by the front.
[[nodiscard]] double heading_of_leaving(const Pose& waypoint, Side side) noexcept;
[[nodiscard]] double heading_of_entering(const Pose& waypoint, Side side) noexcept;

/// Whether a place belongs to a node: within the merge radius, or, like the node, in S or in G.
[[nodiscard]] bool is_near(Point place,
                           const Node& node,
                           const Region& start,
                           const Region& goal,
                           double merge_radius_m) noexcept;

/// What the checker says of a path along an edge. Refused as well: one that does not begin exactly
/// at the waypoint of the edge's end 0, within 1e-7 rad of leaving it by its side, and does not end
/// so at that of its end 1.
[[nodiscard]] Checked check_edge(const Checker& checker,
                                 const Path& path,
                                 const Edge& edge,
                                 std::span<const Pose> waypoints,
                                 const Robot& robot);

}  // namespace tcert::witness
