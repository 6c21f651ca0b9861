#pragma once
/// \file
/// The witnesses of the edges of one trial's corridor graph.

#include <optional>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <witness/edge_paths.hpp>
#include <witness/parameters.hpp>

#include "analysis/study/trials/certify_trial.hpp"

namespace tcert::study {

/// What the edges of a trial prove.
struct EdgeProofs {
  witness::EdgePaths found;
  /// What the widest chain of them from S to G proves, as the checker measures it; empty if there
  /// is none.
  std::optional<double> chain_m;
  /// By node: a lower bound of the distance of its waypoint to what is not free, in m.
  std::vector<double> waypoint_clearance_m;

  /// Edges whose path has a margin above 0.
  [[nodiscard]] std::size_t proven() const noexcept;
};

/// \pre `course` has both regions; `series` and `samples` are of the same trial.
[[nodiscard]] EdgeProofs prove_edges(const witness::SearchSpace& space,
                                     const TrialSeries& series,
                                     const witness::Samples& samples,
                                     const Robot& robot,
                                     const Course& course,
                                     const witness::WitnessParameters& parameters,
                                     const CertificateParameters& certificate);

}  // namespace tcert::study
