#pragma once
/// \file
/// What one trial tells other robots.

#include <federation/submap.hpp>
#include <span>
#include <string>
#include <tcert/parameters.hpp>

#include "analysis/study/trials/certify_trial.hpp"
#include "analysis/study/witness/prove_edges.hpp"

namespace tcert::study {

/// "<trial_id>/<first 12 digits of its log's SHA-256>": trials of other bundles may have the same
/// id, and are in another frame. What a name may not have becomes '_'.
[[nodiscard]] std::string source_name(const std::string& trial_id, const std::string& log_sha256);

/// Of a corridor graph's edges: with proofs of those, the margins and waypoints that are proved in
/// `course`, for the body of `robot`; else what the reading certifies. The name is left to the
/// caller, the error of the frame unknown.
[[nodiscard]] federation::Source source_of_trial(std::span<const Node> nodes,
                                                 std::span<const Edge> edges,
                                                 const EdgeProofs* proofs,
                                                 const Course& course,
                                                 const Robot& robot,
                                                 ClearanceReading clearance);

}  // namespace tcert::study
