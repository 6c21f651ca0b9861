#pragma once
/// \file
/// A world as SVG: obstacles, S and G, its widest path, its path with a turning limit, bottleneck.

#include <string>
#include <tcert/geometry.hpp>
#include <vector>

#include "analysis/study/truth/truth.hpp"
#include "datasets/world.hpp"

namespace tcert {

/// The whole document. `widest` is a widest path, perhaps empty; the circle is the largest disc at
/// the bottleneck.
[[nodiscard]] std::string world_picture(const World& world,
                                        const study::Truth& truth,
                                        const std::vector<Point>& widest);

}  // namespace tcert
