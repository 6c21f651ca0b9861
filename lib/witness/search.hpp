#pragma once
/// \file
/// The search for a path from S to G that proves a large margin.

#include <tcert/robot.hpp>
#include <witness/found.hpp>
#include <witness/samples.hpp>
#include <witness/search_space.hpp>

namespace tcert::witness {

/// The best path that was found, by what the checker says of it. The work is bounded by
/// `iterations` steps of the band, never by a time, so that the same inputs give the same bits.
///
/// The widest path over every third vertex of the cells says how wide a path may be; the shortest
/// of those nearly as wide, then the driven one without its loops, are stretched as elastic bands,
/// coarse to fine, towards margins found by bisection. Whatever the search misses only makes the
/// margin smaller.
[[nodiscard]] Found search(const SearchSpace& space,
                           const Region& start,
                           const Region& goal,
                           const Robot& robot,
                           const Samples& samples,
                           int iterations);

}  // namespace tcert::witness
