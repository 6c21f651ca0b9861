#pragma once
/// \file
/// Random worlds of discs for tests.

#include <cstdint>
#include <string>
#include <table/random.hpp>

#include "datasets/world.hpp"

namespace tcert::test_support {

/// Up to 60 discs of equal or unequal radii in 4 m x 3 m; S and G are discs free of obstacles,
/// small or so large that the tightest place may lie in them.
[[nodiscard]] inline World random_disc_world(std::uint64_t index, bool equal_radii) {
  table::RandomStream random(7, 0x7465'7374, index);
  World world;
  world.name = "random " + std::to_string(index);
  world.bounds = {{0.0, 0.0}, {4.0, 3.0}};
  const double region_radius = random.uniform(0.05, 0.6);
  const Disc start{{0.7, random.uniform(0.7, 2.3)}, region_radius};
  const Disc goal{{3.3, random.uniform(0.7, 2.3)}, random.uniform(0.05, 0.6)};
  world.start = start;
  world.goal = goal;
  const std::uint32_t count = random.below(60);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Disc disc{{random.uniform(0.0, 4.0), random.uniform(0.0, 3.0)},
                    equal_radii ? 0.1 : random.uniform(0.02, 0.4)};
    if (distance(disc.centre, start.centre) > disc.radius_m + start.radius_m + 1e-3 &&
        distance(disc.centre, goal.centre) > disc.radius_m + goal.radius_m + 1e-3) {
      world.obstacles.emplace_back(disc);
    }
  }
  return world;
}

}  // namespace tcert::test_support
