#pragma once
/// \file
/// Whether the file of a witness is true of a log: without the search that found it.

#include <string>

#include "analysis/study/trials/parameters.hpp"
#include "datasets/bundle.hpp"
#include "datasets/trial_reader.hpp"
#include "reports/witness_json.hpp"

namespace tcert {

/// What does not hold, in words; empty if the witness stands. The robot, the rays, the course, the
/// rule and the label must be those of a run of the bundle under `parameters`, the digest that of
/// the log; F_t is built from the log and must be the one stated; the checker must measure the
/// margin, the clearance, the radius and the bottleneck that are stated of the path, and of that of
/// every edge, whose graph must be that of the log's ticks. \throws std::length_error
/// if the box of the run holds more cells than the document may.
[[nodiscard]] std::string fault_of_witness(const WitnessDocument& document,
                                           const BundleInfo& info,
                                           const study::ParameterSet& parameters,
                                           const TrialLog& log,
                                           const std::string& log_sha256);

}  // namespace tcert
