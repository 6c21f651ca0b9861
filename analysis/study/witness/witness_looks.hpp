#pragma once
/// \file
/// The witness of one trial from tick to tick: what was proved by when.

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// What was looked for at a tick.
struct WitnessLook {
  std::size_t tick = 0;
  std::optional<witness::Witness> found;  ///< In what was felt by then.
};

/// The ticks at which a witness is looked for: every n-th from the first in G on, without the last,
/// which has all that was felt. None if n is 0. O(ticks).
[[nodiscard]] std::vector<std::size_t> ticks_to_look_at(std::span<const CertifiedTick> series,
                                                        std::uint32_t every);

/// Samples ready for F_t that were known at `time_ns`. Of each ray the last reading is left out: what
/// it felt next may show it to be a glitch, and what it would have proved comes with the next one.
/// So of two times the later one has every cell that the earlier has. `felt` as felt_samples() has
/// it. O(samples x rays).
[[nodiscard]] witness::Samples known_samples(const witness::Samples& felt,
                                             std::int64_t time_ns,
                                             const Robot& robot,
                                             double lost_share);

/// Makes the best of the looks the witness of the trial if it proves more in all that was felt than
/// what was found there.
void keep_best(const std::vector<WitnessLook>& looks,
               const Robot& robot,
               const Region& goal,
               Proof& proof);

}  // namespace tcert::study
