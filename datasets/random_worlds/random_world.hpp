#pragma once
/// \file
/// Random worlds whose widest path is known by how they are built, and a run through each.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <table/random.hpp>
#include <vector>

#include "datasets/corpus/route.hpp"
#include "datasets/world.hpp"

namespace tcert {

enum class WorldFamily : std::uint8_t {
  gates,          ///< A straight corridor with up to three gates; some runs creep to and fro.
  bends,          ///< A corridor of arcs, with gates.
  discs,          ///< A field of discs of equal or unequal radii.
  figure_eight,   ///< The corpus' course: four lanes, one to five times from S to G or back.
  loop,           ///< A ring lane; most runs lap it at least twice.
  u_turn,         ///< Round the end of a thin wall between two corridors.
  tight_ends,     ///< Small S and G just before the caps of a lane, gates beside them.
  slanted_gates,  ///< Gates askew to the lane.
  staggered,      ///< Two jaws, one behind the other.
  posts,          ///< Posts in the lane, at least 0.11 m thick.
  dead_ends,      ///< A bay beside the lane, into which the run looks.
  kinks,          ///< Straights that meet in corners.
  s_bends,        ///< Two tight bends, one after the other.
};

inline constexpr std::size_t kWorldFamilies = 13;
constexpr WorldFamily row_last(WorldFamily /*any*/) noexcept { return WorldFamily::s_bends; }

inline constexpr std::array kMixedFamilies{WorldFamily::gates,
                                           WorldFamily::bends,
                                           WorldFamily::discs,
                                           WorldFamily::figure_eight,
                                           WorldFamily::loop};

/// What the mixed worlds have not: their ends are roomy and their gates face each other squarely.
inline constexpr std::array kHardFamilies{WorldFamily::tight_ends,
                                          WorldFamily::slanted_gates,
                                          WorldFamily::staggered,
                                          WorldFamily::posts,
                                          WorldFamily::dead_ends,
                                          WorldFamily::kinks,
                                          WorldFamily::s_bends};

[[nodiscard]] std::string_view name_of(WorldFamily family) noexcept;

struct RandomWorld {
  WorldFamily family = WorldFamily::gates;
  World world;
  std::vector<Region> edge_walls;  ///< Stand for the bounds where the robot can feel them.
  /// Width of the narrowest passage on the widest way from S to G, its ends included: no wider disc
  /// gets through.
  /// Empty for a field of discs, whose exact value is computed.
  std::optional<double> passage_m;
  double corridor_m = 0.0;  ///< u_turn: width of the two corridors,
  double wall_m = 0.0;      ///< and thickness of the wall between them.
  unsigned lanes = 1;       ///< Ways that the world has,
  unsigned explored = 1;    ///< and how many of them the run is to drive.
  std::vector<Leg> legs;
  double speed_mps = 0.17;
  double wobble_m = 0.0;  ///< How far the run strays to either side.
};

/// Shares of the mixed families: gates 6, bends 5, discs 7, figure_eight 1, loop 1 in twenty.
[[nodiscard]] WorldFamily mixed_family(std::uint64_t index) noexcept;

/// Shares of the hard families: one in seven each.
[[nodiscard]] WorldFamily hard_family(std::uint64_t index) noexcept;
[[nodiscard]] WorldFamily u_turn_family(std::uint64_t index) noexcept;

/// The same (family, seed, index) gives the same world. Obstacles are at least 0.1 m wide.
/// \throws std::logic_error if S or G is not free of obstacles, or another assumption fails.
[[nodiscard]] RandomWorld draw_random_world(WorldFamily family,
                                            std::uint64_t seed,
                                            std::uint64_t index);

}  // namespace tcert
