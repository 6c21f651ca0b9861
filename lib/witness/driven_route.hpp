#pragma once
/// \file
/// The path that was driven, without its loops.

#include <tcert/region.hpp>
#include <vector>
#include <witness/samples.hpp>

namespace tcert::witness {

/// The shortest way from S to G over the positions of the run, 5 cm apart, from each to the one
/// driven before or after it and to those within 8 cm. Empty if the run does not join S and G.
/// O(n log n) of n positions.
[[nodiscard]] std::vector<Point> driven_route(const Samples& samples,
                                              const Region& start,
                                              const Region& goal);

}  // namespace tcert::witness
