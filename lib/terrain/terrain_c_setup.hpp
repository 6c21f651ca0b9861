#pragma once
/// \file
/// The setup of the C interface as one of the library. Internal.

#include <terrain/terrain_c.h>
#include <cstdint>
#include <terrain/explore.hpp>

namespace tcert::terrain {

[[nodiscard]] tcert_terrain_setup default_setup_in_c() noexcept;

/// `blocked` has a byte a cell, or is null. \throws std::invalid_argument for words and sizes that
/// are none; what Session refuses is not looked at.
[[nodiscard]] ExploreSetup setup_of(const tcert_terrain_setup& setup, const std::uint8_t* blocked);

}  // namespace tcert::terrain
