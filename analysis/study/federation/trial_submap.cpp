#include "analysis/study/federation/trial_submap.hpp"

#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>
#include <witness/path.hpp>

namespace tcert::study {
namespace {

federation::MarginKind kind_of(ClearanceReading clearance) noexcept {
  switch (clearance) {
    case ClearanceReading::swept:
      return federation::MarginKind::swept;
    case ClearanceReading::radial:
      return federation::MarginKind::radial;
    case ClearanceReading::width:
    case ClearanceReading::witness:
      break;
  }
  return federation::MarginKind::width;
}

/// How far a path leaves the straight line between its ends, at most: somewhere abreast of every
/// place of the line there is one of the path, for it leads from the one end to the other.
double spread_of(const witness::Path& path) noexcept {
  const Point from = path.front().from;
  const Point way = path.back().to - from;
  const double length_m = norm(way);
  double spread_m = 0.0;
  for (const witness::Piece& piece : path) {
    const double aside_m =
        std::max(std::abs(cross(way, piece.from - from)), std::abs(cross(way, piece.to - from))) /
        length_m;
    // An arc leaves its chord by its sagitta.
    const double sagitta_m =
        0.5 * witness::chord(piece) * std::abs(elementary::tan(0.25 * piece.turn_rad));
    spread_m = std::max(spread_m, aside_m + sagitta_m);
  }
  return spread_m;
}

bool lies_in(const std::optional<Region>& region, Point p) noexcept {
  return region.has_value() && contains(*region, p);
}

}  // namespace

std::string source_name(const std::string& trial_id, const std::string& log_sha256) {
  constexpr std::size_t kDigits = 12;
  std::string name = trial_id.substr(0, federation::kLongestName - kDigits - 1) + '/' +
                     log_sha256.substr(0, kDigits);
  for (char& c : name) {
    c = federation::is_name({&c, 1}) ? c : '_';
  }
  return name;
}

federation::Source source_of_trial(std::span<const Node> nodes,
                                   std::span<const Edge> edges,
                                   const EdgeProofs* proofs,
                                   const Course& course,
                                   const Robot& robot,
                                   ClearanceReading clearance) {
  if (proofs == nullptr) {
    federation::Source source = federation::source_of(nodes, edges);
    source.margins = kind_of(clearance);
    return source;
  }
  std::vector<federation::SubmapNode> waypoints;
  for (std::size_t n = 0; n < proofs->found.waypoints.size(); ++n) {
    const Pose& pose = proofs->found.waypoints[n];
    waypoints.push_back(
        {pose,
         lies_in(course.start, pose.position),
         lies_in(course.goal, pose.position),
         2.0 * (proofs->waypoint_clearance_m[n] - robot.tracking_buffer_m) - robot.body_width_m});
  }
  std::vector<std::optional<federation::EdgeMargin>> margins;
  for (const auto& path : proofs->found.paths) {
    margins.push_back(
        path ? std::optional(federation::EdgeMargin{path->checked.margin_m, spread_of(path->path)})
             : std::nullopt);
  }
  federation::Source source = federation::source_of(nodes, edges, margins, waypoints);
  source.margins = federation::MarginKind::witness;
  return source;
}

}  // namespace tcert::study
