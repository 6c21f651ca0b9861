#pragma once
/// \file
/// One function per family of random worlds. Internal to random_world.cpp.

#include "datasets/random_worlds/random_world.hpp"

namespace tcert {

inline constexpr double kRandomRegionRadius = 0.35;  // of S and of G

[[nodiscard]] RandomWorld draw_gates(RandomStream& random);
[[nodiscard]] RandomWorld draw_bends(RandomStream& random);
[[nodiscard]] RandomWorld draw_discs(RandomStream& random);
[[nodiscard]] RandomWorld draw_figure_eight(RandomStream& random);
[[nodiscard]] RandomWorld draw_loop(RandomStream& random);
[[nodiscard]] RandomWorld draw_u_turn(RandomStream& random);

/// Width of a gate: the body's plus -0.02 to 0.25 m, most of them passable.
[[nodiscard]] double draw_gate_width(RandomStream& random);

}  // namespace tcert
