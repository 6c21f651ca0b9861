#include "reports/witness_edges_json.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "reports/witness_json.hpp"
#include "reports/witness_path_json.hpp"

namespace tcert {
namespace {

using nlohmann::ordered_json;

ordered_json pose_json(const Pose& pose) {
  return {pose.position.x_m, pose.position.y_m, pose.yaw_rad};
}

Pose pose_from(const ordered_json& json) {
  if (!json.is_array() || json.size() != 3) {
    throw WitnessFormatError("a pose is not [x, y, yaw]");
  }
  const Pose pose{{json[0].get<double>(), json[1].get<double>()}, json[2].get<double>()};
  if (!std::isfinite(pose.position.x_m + pose.position.y_m + pose.yaw_rad)) {
    throw WitnessFormatError("a pose is not finite");
  }
  return pose;
}

ordered_json end_json(const EdgeEnd& end) {
  return {{"node", end.node}, {"side", end.side == Side::front ? "front" : "back"}};
}

EdgeEnd end_from(const ordered_json& json, std::size_t nodes) {
  const ordered_json& node = json.at("node");
  const std::string side = json.at("side");
  if (!node.is_number_unsigned() || node.get<std::uint64_t>() >= nodes ||
      (side != "front" && side != "back")) {
    throw WitnessFormatError("the end of an edge is not a side of a node");
  }
  return {node.get<std::uint32_t>(), side == "front" ? Side::front : Side::back};
}

}  // namespace

ordered_json edges_json(const WitnessedEdges& edges) {
  ordered_json json = {{"merge_radius_m", edges.merge_radius_m},
                       {"nodes", ordered_json::array()},
                       {"paths", ordered_json::array()}};
  for (std::size_t n = 0; n < edges.nodes.size(); ++n) {
    json["nodes"].push_back({{"pose", pose_json(edges.nodes[n].pose)},
                             {"waypoint", pose_json(edges.found.waypoints[n])}});
  }
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const std::optional<witness::Witness>& one = edges.found.paths[e];
    ordered_json edge = {{"from", end_json(edges.edges[e].ends[0])},
                         {"to", end_json(edges.edges[e].ends[1])}};
    add_measured(one ? one->checked : witness::Checked{}, one.has_value(), edge);
    edge["path"] = path_json(one ? one->path : witness::Path{});
    json["paths"].push_back(std::move(edge));
  }
  return json;
}

WitnessedEdges edges_from(const ordered_json& json, const witness::Lattice& lattice) {
  WitnessedEdges edges;
  edges.merge_radius_m = json.at("merge_radius_m");
  for (const ordered_json& node : json.at("nodes")) {
    const Pose pose = pose_from(node.at("pose"));
    edges.nodes.push_back({pose, direction(pose.yaw_rad), false, false});
    edges.found.waypoints.push_back(pose_from(node.at("waypoint")));
  }
  for (const ordered_json& one : json.at("paths")) {
    Edge edge;
    edge.ends = {end_from(one.at("from"), edges.nodes.size()),
                 end_from(one.at("to"), edges.nodes.size())};
    edges.edges.push_back(edge);
    witness::Path path = path_from(one.at("path"), lattice);
    const witness::Checked checked = measured_from(one, !path.empty());
    edges.found.paths.push_back(
        path.empty() ? std::nullopt : std::optional(witness::Witness{std::move(path), checked}));
  }
  return edges;
}

}  // namespace tcert
