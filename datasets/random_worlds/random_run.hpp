#pragma once
/// \file
/// The run through a random world, and what the robot feels of it: without noise, or as the corpus'
/// robot logs it.

#include "datasets/corpus/drive.hpp"
#include "datasets/corpus/wall_index.hpp"
#include "datasets/random_worlds/random_world.hpp"
#include "datasets/ticks.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

/// The walls of a random world, those that stand for its bounds included.
[[nodiscard]] WallIndex feelable_walls(const RandomWorld& drawn);

/// Follows the legs exactly, at the drawn speed, heading along the way (backing: against it) and
/// straying by smooth waves. A run that would touch a wall is driven again with a quarter of the
/// waves, then with none; one that does not fit even so backs off 0.4 m from there and ends. The
/// body is never nearer than w_B/2 + 0.5 mm to a wall.
[[nodiscard]] Drive follow_legs(const RandomWorld& drawn,
                                const WallIndex& walls,
                                std::uint64_t seed,
                                std::uint64_t index);

/// Ticks at 10 Hz whose pose and readings are true and belong to the same instant.
[[nodiscard]] TickTable true_ticks(const Drive& drive, const WallIndex& walls);

/// Streams at native rates: the poses at 20 Hz, touches at 83 Hz. Without noise they are true and
/// without silences, the pose between two samples on the straight between them; with it as
/// logged_ticks() has them.
[[nodiscard]] TrialLog native_log(const Drive& drive,
                                  const WallIndex& walls,
                                  bool noise,
                                  std::uint64_t seed,
                                  std::uint64_t index);

/// Ticks resampled from streams with the corpus' noise, jitter, glitches and a calibration bias of
/// 4 mm (one standard deviation) per run.
[[nodiscard]] TickTable logged_ticks(const Drive& drive,
                                     const WallIndex& walls,
                                     std::uint64_t seed,
                                     std::uint64_t index);

}  // namespace tcert
