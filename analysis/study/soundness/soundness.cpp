#include "analysis/study/soundness/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tcert/certifier.hpp>

#include "analysis/study/soundness/soundness_walk.hpp"
#include "analysis/study/truth/slack.hpp"
#include "analysis/study/witness/felt_samples.hpp"
#include "analysis/study/witness/prove_trial.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_run.hpp"

namespace tcert::study {
namespace {

constexpr double kNoPath = ClearanceValue::kNoPath;

// Enough for the longest run; a certifier is built for every world, since its course differs. The
// contact memory, which T_t does not use, is kept as small as can be.
CertificateParameters small(ClearanceReading clearance) {
  CertificateParameters parameters;
  parameters.clearance = clearance;
  parameters.max_nodes = 400;
  parameters.max_edges = 600;
  parameters.memory_sigma_m = 0.01;
  parameters.max_memory_cells = 1024;
  parameters.max_swept_cells = 1U << 18U;
  return parameters;
}

void add_with_and_without_noise(std::vector<SoundnessMethod>& methods,
                                const std::string& name,
                                const CertificateParameters& parameters) {
  methods.push_back({name, parameters, false});
  methods.push_back({name, parameters, true});
}

SoundnessOutcome prove_at_end(const witness::Samples& samples,
                              const Course& course,
                              const SoundnessMethod& method,
                              double truth_m) {
  const Proof proof = prove(samples, corpus_robot(), course, method.witness, method.parameters);
  SoundnessOutcome outcome;
  if (proof.witness) {
    outcome.certificate_m = proof.witness->checked.margin_m;
    outcome.issued = outcome.certificate_m > 0.0;
    outcome.excess_m = outcome.certificate_m - truth_m;
    outcome.violating_ticks = outcome.excess_m > 0.0 ? 1U : 0U;
  }
  return outcome;
}

SoundnessOutcome certify(const TickTable& ticks,
                         const Course& course,
                         const SoundnessMethod& method,
                         double truth_m) {
  Certifier certifier(corpus_robot(), course, method.parameters);
  SoundnessOutcome outcome;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const CertifiedTick now = certifier.update(ticks[k]);
    outcome.certificate_m = now.certificate_m;
    outcome.issued = now.issued;
    if (now.certificate_m > kNoPath) {
      outcome.excess_m = std::max(outcome.excess_m, now.certificate_m - truth_m);
      outcome.violating_ticks += now.certificate_m > truth_m ? 1U : 0U;
    }
  }
  return outcome;
}

}  // namespace

std::vector<SoundnessMethod> mixed_methods() {
  std::vector<SoundnessMethod> methods;
  add_with_and_without_noise(methods, "radial", small(ClearanceReading::radial));
  add_with_and_without_noise(methods, "width", small(ClearanceReading::width));
  add_with_and_without_noise(methods, "swept", small(ClearanceReading::swept));
  CertificateParameters optimistic = small(ClearanceReading::width);
  optimistic.unknown = UnknownSpace::free;
  add_with_and_without_noise(methods, "A2 (unknown=free)", optimistic);
  return methods;
}

std::vector<SoundnessMethod> u_turn_methods() {
  std::vector<SoundnessMethod> methods;
  for (const auto& [name, clearance] : {std::pair{"radial", ClearanceReading::radial},
                                        std::pair{"width", ClearanceReading::width},
                                        std::pair{"swept", ClearanceReading::swept}}) {
    CertificateParameters parameters = small(clearance);
    add_with_and_without_noise(methods, name, parameters);
    parameters.curvature = CurvatureReading::none;
    add_with_and_without_noise(methods, std::string("A3, ") + name, parameters);
  }
  return methods;
}

std::vector<SoundnessMethod> witness_methods(double reading_bound_m) {
  const std::string off = fmt::format("{:g} mm off", 1e3 * reading_bound_m);
  std::vector<SoundnessMethod> methods;
  const CertificateParameters parameters = small(ClearanceReading::witness);
  add_with_and_without_noise(methods, "witness", parameters);
  methods.push_back({"witness, " + off, parameters, true});
  methods.back().witness.reading_bound_m = reading_bound_m;
  methods.push_back({"witness, native rates", parameters, false, {}, true});
  methods.push_back({"witness, native rates, " + off, parameters, true, {}, true});
  methods.back().witness.reading_bound_m = reading_bound_m;
  return methods;
}

// The first term rises with d, the second falls: they meet, or the middle of the corridor is best.
double u_turn_value(double corridor_m, double wall_m, const Robot& robot) noexcept {
  const double room_m = corridor_m + 0.5 * wall_m - robot.min_turn_radius_m;
  const double meet_m = (room_m + robot.body_width_m) / 3.0;
  const double d = std::min(meet_m, 0.5 * corridor_m);
  return std::min(2.0 * d - robot.body_width_m, room_m - d);
}

double upper_value(const RandomWorld& drawn, const Robot& robot) {
  if (drawn.passage_m) {
    return *drawn.passage_m - robot.body_width_m;
  }
  return clearance_slack(
      exact_disc_clearance(drawn.world).upper_m, robot.body_width_m, SlackConvention::width);
}

WorldOutcome study_world(const std::vector<SoundnessMethod>& methods,
                         const SoundnessOptions& options,
                         std::uint64_t index) {
  const SoundnessWalk walk = options.driven
                                 ? driven_walk(options.seed, index)
                                 : random_walk(options.family(index), options.seed, index);
  WorldOutcome world;
  world.family = walk.family;
  world.truth_m = walk.truth_m;
  world.clearance_truth_m = walk.clearance_truth_m;
  world.lanes = walk.lanes;
  world.explored = walk.explored;
  world.reached = walk.drive.end_reason == EndReason::goal;
  const TickTable felt = true_ticks(walk.drive, walk.walls);
  const TickTable logged = std::ranges::any_of(methods, &SoundnessMethod::noise)
                               ? logged_ticks(walk.drive, walk.walls, options.seed, index)
                               : TickTable{};
  world.ticks = static_cast<std::uint32_t>(felt.size());
  for (const SoundnessMethod& method : methods) {
    const TickTable& ticks = method.noise ? logged : felt;
    if (method.parameters.clearance == ClearanceReading::witness) {
      const witness::Samples samples =
          method.native_rates
              ? witness_samples(
                    native_log(walk.drive, walk.walls, method.noise, options.seed, index),
                    corpus_robot(),
                    method.witness,
                    method.parameters)
              : felt_samples(ticks, corpus_robot());
      world.outcomes.push_back(prove_at_end(samples, walk.course, method, walk.truth_m));
    } else {
      world.outcomes.push_back(certify(ticks, walk.course, method, walk.truth_m));
    }
  }
  return world;
}

}  // namespace tcert::study
