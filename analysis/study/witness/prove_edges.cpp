#include "analysis/study/witness/prove_edges.hpp"

#include <algorithm>
#include <vector>
#include <witness/chain.hpp>

namespace tcert::study {
namespace {

/// No pass of an edge is longer, but for its last step and where positions are joined.
double longest_way_m(const CertificateParameters& certificate) noexcept {
  return 2.0 * certificate.edge_length_m + 0.5;
}

/// Cells by which a bilinear value may be above a function that changes by at most 1 a metre: the
/// mean distance to the four vertices is at most 1 / sqrt(2); then the rounding to float.
constexpr double kInterpolation = 0.7072;

}  // namespace

std::size_t EdgeProofs::proven() const noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(
      found.paths, [](const auto& path) { return path && path->checked.margin_m > 0.0; }));
}

EdgeProofs prove_edges(const witness::SearchSpace& space,
                       const TrialSeries& series,
                       const witness::Samples& samples,
                       const Robot& robot,
                       const Course& course,
                       const witness::WitnessParameters& parameters,
                       const CertificateParameters& certificate) {
  const witness::EdgeProblem problem{
      space, series.nodes, series.edges, *course.start, *course.goal, robot};
  EdgeProofs proofs{witness::edge_paths(problem,
                                        samples,
                                        {certificate.merge_radius_m,
                                         longest_way_m(certificate),
                                         static_cast<int>(parameters.witness_edge_steps)}),
                    {},
                    {}};
  for (const Pose& waypoint : proofs.found.waypoints) {
    proofs.waypoint_clearance_m.push_back(space.field.at(waypoint.position) -
                                          kInterpolation * space.field.cell_m());
  }
  const std::vector<witness::EdgeStep> chain =
      witness::widest_chain(proofs.found, series.edges, *course.start, *course.goal);
  if (!chain.empty()) {
    const witness::Checked checked = space.checker.check(
        witness::chained(proofs.found, chain), *course.start, *course.goal, robot);
    proofs.chain_m = checked.refused.empty() ? std::optional(checked.margin_m) : std::nullopt;
  }
  return proofs;
}

}  // namespace tcert::study
