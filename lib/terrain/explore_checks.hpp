#pragma once
/// \file
/// What an exploration asks of its terrain, before it begins and when it ended. Internal.

#include <terrain/explore.hpp>

namespace tcert::terrain {

/// \throws std::invalid_argument as Explorer does.
void require_valid(const Grid& grid, const ExploreSetup& setup);

/// \throws std::invalid_argument as explore() does.
void require_explorable(const Terrain& terrain, const ExploreSetup& setup);

/// What stands between two places, by the terrain itself.
[[nodiscard]] End what_forbids(const Terrain& terrain,
                               const ExploreSetup& setup,
                               Cell from,
                               Cell goal);

}  // namespace tcert::terrain
