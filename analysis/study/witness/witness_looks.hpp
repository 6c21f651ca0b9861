#pragma once
/// \file
/// The witnesses of one trial while it went on: what was proved by when.

#include <cstddef>
#include <span>
#include <tcert/certifier.hpp>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <vector>
#include <witness/found.hpp>
#include <witness/parameters.hpp>
#include <witness/samples.hpp>

#include "analysis/study/witness/prove_trial.hpp"

namespace tcert::study {

/// A witness in what was felt by a tick.
struct WitnessLook {
  std::size_t tick = 0;  ///< From 0.
  witness::Witness found;
};

/// True if a witness is looked for after the tick of this number (from 0): after every
/// `witness_every`-th; never if that is 0.
[[nodiscard]] bool is_look(std::size_t tick, const witness::WitnessParameters& parameters) noexcept;

/// The witness in what was felt by `time_ns`; `felt` are samples of which no glitch was taken.
[[nodiscard]] Proof prove_so_far(const witness::Samples& felt,
                                 std::int64_t time_ns,
                                 const Robot& robot,
                                 const Course& course,
                                 const witness::WitnessParameters& parameters,
                                 const CertificateParameters& certificate);

/// What the looks of a run found, but for its last tick, at which all is known. Each costs what a
/// proof of the run up to there does.
[[nodiscard]] std::vector<WitnessLook> witness_looks(const witness::Samples& felt,
                                                     std::span<const CertifiedTick> series,
                                                     const Robot& robot,
                                                     const Course& course,
                                                     const witness::WitnessParameters& parameters,
                                                     const CertificateParameters& certificate);

/// Makes the best of the looks the witness of the trial, as all that was felt measures it, if that
/// is more than what was found at its end. Looks that claim more than the witness that the trial
/// then has go: where the box of the whole run has no room, all of them.
void keep_best(std::vector<WitnessLook>& looks,
               const Robot& robot,
               const Course& course,
               Proof& proof);

}  // namespace tcert::study
