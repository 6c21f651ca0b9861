#include "analysis/study/witness/prove_trial.hpp"

#include <stdexcept>
#include <utility>

#include "analysis/study/witness/felt_samples.hpp"

namespace tcert::study {

CertificateParameters parameters_of_ticks(CertificateParameters certificate) noexcept {
  if (certificate.clearance == ClearanceReading::witness) {
    certificate.clearance = ClearanceReading::width;
  }
  return certificate;
}

witness::Samples witness_samples(const TrialLog& log,
                                 const Robot& robot,
                                 const witness::WitnessParameters& parameters,
                                 const CertificateParameters& certificate) {
  witness::Samples samples = felt_samples(log, robot, parameters.pose_bridge_s);
  witness::drop_glitches(
      samples, robot, witness::free_space_options(parameters, certificate).strips.lost_share);
  return samples;
}

Proof prove(const witness::Samples& samples,
            const Robot& robot,
            const Course& course,
            const witness::WitnessParameters& parameters,
            const CertificateParameters& certificate,
            const TrialSeries* series) {
  Proof proof;
  if (!course.goal) {
    proof.reason = "the course has no goal";
    return proof;
  }
  if (samples.size() == 0) {
    proof.reason = "no touch has a pose";
    return proof;
  }
  proof.start = witness::start_of(robot, course, samples);
  try {
    proof.cells = witness::free_space(
        robot, course, samples, witness::free_space_options(parameters, certificate));
  } catch (const std::length_error& error) {
    proof.reason = error.what();
    return proof;
  }
  const witness::SearchSpace space(proof.cells);
  witness::Found found = witness::search(
      space, proof.start, *course.goal, robot, samples, static_cast<int>(parameters.witness_steps));
  proof.witness = std::move(found.witness);
  proof.reason = proof.witness ? std::string() : std::move(found.reason);
  if (series != nullptr) {
    proof.edges = prove_edges(
        space, *series, samples, robot, {proof.start, course.goal}, parameters, certificate);
  }
  return proof;
}

}  // namespace tcert::study
