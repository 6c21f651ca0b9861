#pragma once
/// \file
/// Maps that are in degrees though metres are meant.

#include "datasets/terrain_file.hpp"

namespace tcert::terrain_reading {

/// Whether the places on a declared map may be longitudes and latitudes: within +-360 and +-90, and
/// cells smaller than a hundredth, some 30 arc seconds or a centimetre.
[[nodiscard]] bool may_be_in_degrees(const TerrainGrid& terrain);

}  // namespace tcert::terrain_reading
