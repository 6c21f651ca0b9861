#pragma once
/// \file
/// Whether a world is one whose truth can be asked for.

#include <string>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

/// What is wrong, each fit to follow "world 'name': expected ..."; empty if nothing is. There must
/// be S, G and an obstacle; S and G lie inside the bounds, apart from each other and free of
/// obstacles; polygons do not cross or touch themselves. O(vertices^2 of each polygon + obstacles).
[[nodiscard]] std::vector<std::string> world_problems(const World& world);

}  // namespace tcert
