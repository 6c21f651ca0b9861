#include "cli/runs/live/live_witness.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <utility>

#include "analysis/study/witness/witness_looks.hpp"
#include "cli/runs/errors.hpp"

namespace tcert::cli {

LiveWitness::LiveWitness(const Robot& robot,
                         const Course& course,
                         const study::ParameterSet& parameters,
                         WhenLate when_late)
    : robot_(robot), course_(course), parameters_(parameters), when_late_(when_late), felt_(robot) {
  if (parameters.witness.witness_every == 0) {
    throw UsageError(
        "clearance=witness: say how many ticks lie between two searches, as in "
        "--set witness_every=50");
  }
  if (!course.goal) {
    throw UsageError("clearance=witness needs a course with a goal");
  }
}

void LiveWitness::take(const Tick& tick, CertifiedTick& certified) {
  const bool is_evidence = (certified.flags & (flag_bad_input | flag_stale)) == 0;
  if (is_evidence || tick.segment_start) {
    const bool has_room = felt_.samples().size() < kMostSamples;
    left_out_ += is_evidence && !has_room ? 1 : 0;
    Tick taken = tick;
    taken.stale = !is_evidence || !has_room;
    felt_.add(taken);
  }
  if (study::is_look(ticks_++, parameters_.witness)) {
    look(tick.time_ns);
  }
  certified.certificate_m = certificate_m_;
  certified.issued = certificate_m_ > 0.0;
}

void LiveWitness::look(std::int64_t time_ns) {
  if (search_.valid()) {
    const bool is_done = search_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!is_done && when_late_ == WhenLate::skip) {
      ++late_;
      return;
    }
    collect();
  }
  search_ = std::async(std::launch::async, [this, time_ns, felt = felt_.samples()] {
    return study::prove_so_far(felt,
                               time_ns,
                               robot_,
                               course_,
                               parameters_.witness,
                               study::parameters_of_ticks(parameters_.certificate));
  });
}

void LiveWitness::collect() {
  certificate_m_ = std::max(certificate_m_, search_.get().certificate_m().value_or(certificate_m_));
}

std::string LiveWitness::conclude() {
  if (search_.valid()) {
    collect();
  }
  witness::Samples felt = felt_.samples();
  const CertificateParameters certificate = study::parameters_of_ticks(parameters_.certificate);
  witness::drop_glitches(
      felt,
      robot_,
      witness::free_space_options(parameters_.witness, certificate).strips.lost_share);
  const study::Proof last = study::prove(felt, robot_, course_, parameters_.witness, certificate);
  certificate_m_ = std::max(certificate_m_, last.certificate_m().value_or(certificate_m_));
  std::string words = certificate_m_ > -std::numeric_limits<double>::infinity()
                          ? fmt::format("a witness proves a margin of {:.3f} m", certificate_m_)
                          : "no witness: " + last.reason;
  if (late_ > 0) {
    words += fmt::format("; {} searches took longer than {} ticks, raise 'witness_every'",
                         late_,
                         parameters_.witness.witness_every);
  }
  if (left_out_ > 0) {
    words += fmt::format("; of the last {} ticks nothing was kept", left_out_);
  }
  return words + ".";
}

}  // namespace tcert::cli
