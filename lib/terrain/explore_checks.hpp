#pragma once
/// \file
/// What an exploration asks of its terrain, before it begins and when it ended. Internal to
/// explore.cpp.

#include <terrain/explore.hpp>

namespace tcert::terrain {

/// \throws std::invalid_argument as explore() does.
void require_explorable(const Terrain& terrain, const ExploreSetup& setup);

/// What stands between start and goal, by the terrain itself. \pre there is a goal
[[nodiscard]] End what_forbids(const Terrain& terrain, const ExploreSetup& setup);

}  // namespace tcert::terrain
