#pragma once
/// \file
/// One function per family of random worlds. Internal to random_world.cpp.

#include "datasets/random_worlds/random_world.hpp"

namespace tcert {

inline constexpr double kRandomRegionRadius = 0.35;  // of S and of G
inline constexpr double kIntoGoal = 0.15;            // driven beyond G's middle

[[nodiscard]] RandomWorld draw_gates(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_bends(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_discs(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_figure_eight(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_loop(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_u_turn(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_tight_ends(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_slanted_gates(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_staggered(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_posts(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_dead_ends(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_kinks(table::RandomStream& random);
[[nodiscard]] RandomWorld draw_s_bends(table::RandomStream& random);

/// Width of a gate: the body's plus -0.02 to 0.25 m, most of them passable.
[[nodiscard]] double draw_gate_width(table::RandomStream& random);

}  // namespace tcert
