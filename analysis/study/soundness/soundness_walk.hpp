#pragma once
/// \file
/// A run through a world whose truth is known: what soundness is studied on.

#include <cstdint>
#include <tcert/robot.hpp>

#include "datasets/corpus/drive.hpp"
#include "datasets/corpus/wall_index.hpp"
#include "datasets/random_worlds/random_world.hpp"

namespace tcert::study {

struct SoundnessWalk {
  WorldFamily family = WorldFamily::gates;
  double truth_m = 0.0;  ///< T_upper by clearance; of a U-turn the exact T.
  double clearance_truth_m = 0.0;
  unsigned lanes = 1;
  unsigned explored = 1;
  Course course;
  WallIndex walls;
  Drive drive;
};

/// The run of a random world along its legs.
[[nodiscard]] SoundnessWalk random_walk(WorldFamily family,
                                        std::uint64_t seed,
                                        std::uint64_t index);

/// What one of the six policies, by `index` in turn, drives in closed loop through gated world
/// `index`, which need not be passable: it wanders, turns back, slides along walls. T_upper is the
/// margin of the widest way.
[[nodiscard]] SoundnessWalk driven_walk(std::uint64_t seed, std::uint64_t index);

}  // namespace tcert::study
