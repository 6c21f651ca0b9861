#pragma once
/// \file
/// A path through a known world by the search of the witness.

#include <tcert/robot.hpp>
#include <vector>

#include "analysis/study/truth/arc.hpp"
#include "datasets/world.hpp"

namespace tcert::study {

/// A path from S to G that was stretched as an elastic band in the cells that no obstacle touches:
/// from the widest route, and from `first`, which may be empty. Empty if none was found, or the
/// world has more than 2^24 cells. What it is worth is for the caller to measure. O(cells).
[[nodiscard]] std::vector<Arc> stretched_path(const World& world,
                                              const Robot& robot,
                                              double cell_m,
                                              const std::vector<Arc>& first);

}  // namespace tcert::study
