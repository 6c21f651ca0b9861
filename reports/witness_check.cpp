#include "reports/witness_check.hpp"

#include <algorithm>
#include <optional>
#include <tcert/certifier.hpp>
#include <witness/waypoint.hpp>

#include "analysis/study/trials/certify_trial.hpp"
#include "analysis/study/witness/prove_trial.hpp"
#include "reports/features_table.hpp"

namespace tcert {
namespace {

/// All that a document states before its path and its cells.
std::string head_of(WitnessDocument document) {
  document.path.clear();
  document.edges = std::nullopt;
  document.cells = {};
  return to_json(document);
}

/// What a path is refused for, or that it measures otherwise than stated.
std::string fault_of_path(const witness::Checked& checked, const witness::Checked& stated) {
  if (!checked.refused.empty()) {
    return "the checker refuses it: " + checked.refused;
  }
  const bool is_as_stated =
      checked.margin_m == stated.margin_m && checked.clearance_m == stated.clearance_m &&
      checked.turn_radius_m == stated.turn_radius_m && checked.bottleneck == stated.bottleneck;
  return is_as_stated ? "" : "the checker measures another margin";
}

/// Whether the graph is that of the run.
std::string fault_of_graph(const WitnessedEdges& stated,
                           const BundleInfo& info,
                           const Robot& robot,
                           const study::ParameterSet& parameters,
                           const TrialLog& log) {
  const CertificateParameters certificate = study::parameters_of_ticks(parameters.certificate);
  Certifier certifier(robot, info.course, certificate);
  const study::TrialSeries series =
      study::certify_trial(certifier, resample(log, parameters.resample));
  const auto same_node = [](const Node& a, const Node& b) {
    return a.pose.position == b.pose.position && a.pose.yaw_rad == b.pose.yaw_rad;
  };
  const auto same_edge = [](const Edge& a, const Edge& b) { return a.ends == b.ends; };
  const bool is_same = stated.merge_radius_m == certificate.merge_radius_m &&
                       std::ranges::equal(stated.nodes, series.nodes, same_node) &&
                       std::ranges::equal(stated.edges, series.edges, same_edge);
  return is_same ? "" : "its edges are those of another run";
}

/// Whether waypoints lie where they may, and every path is as stated.
std::string fault_of_edges(const WitnessDocument& document, const witness::Checker& checker) {
  const WitnessedEdges& edges = *document.edges;
  for (std::size_t n = 0; n < edges.nodes.size(); ++n) {
    if (!witness::is_near(edges.found.waypoints[n].position,
                          edges.nodes[n],
                          document.start,
                          document.goal,
                          edges.merge_radius_m)) {
      return "a waypoint lies too far from its node";
    }
  }
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    if (!edges.found.paths[e]) {
      continue;
    }
    const auto& [path, stated] = *edges.found.paths[e];
    const std::string fault = fault_of_path(
        witness::check_edge(checker, path, edges.edges[e], edges.found.waypoints, document.robot),
        stated);
    if (!fault.empty()) {
      return "edge " + std::to_string(e) + ": " + fault;
    }
  }
  return "";
}

}  // namespace

std::string fault_of_witness(const WitnessDocument& document,
                             const BundleInfo& info,
                             const study::ParameterSet& parameters,
                             const TrialLog& log,
                             const std::string& log_sha256) {
  if (!info.course.goal) {
    return "the bundle has no goal";
  }
  if (document.log_sha256 != log_sha256) {
    return "it is of another log";
  }
  const Robot robot = study::with_overrides(info.robot, parameters.robot);
  const witness::Samples samples =
      study::witness_samples(log, robot, parameters.witness, parameters.certificate);
  if (samples.size() == 0) {
    return "its log holds no touch with a pose";
  }
  WitnessDocument of_run = document;
  of_run.synthetic = synthetic_label(info);
  of_run.robot = robot;
  of_run.rule = witness::free_space_options(parameters.witness, parameters.certificate);
  of_run.pose_bridge_s = parameters.witness.pose_bridge_s;
  of_run.start = witness::start_of(robot, info.course, samples);
  of_run.goal = *info.course.goal;
  if (head_of(of_run) != head_of(document)) {
    return "it states another robot, course, rule or label than the run";
  }
  const witness::FreeCells cells =
      witness::free_space(robot, {of_run.start, of_run.goal}, samples, document.rule);
  if (!(cells == document.cells)) {
    return "the free space built from the log is another";
  }
  const witness::Checker checker(cells);
  if (!document.path.empty()) {
    std::string fault = fault_of_path(
        checker.check(document.path, of_run.start, of_run.goal, robot), document.stated);
    if (!fault.empty()) {
      return fault;
    }
  }
  if (!document.edges) {
    return document.path.empty() ? "it has no path" : "";
  }
  const std::string fault = fault_of_graph(*document.edges, info, robot, parameters, log);
  return fault.empty() ? fault_of_edges(document, checker) : fault;
}

}  // namespace tcert
