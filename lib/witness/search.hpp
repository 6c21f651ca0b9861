#pragma once
/// \file
/// The search for a path from S to G that proves a large margin.

#include <optional>
#include <string>
#include <tcert/robot.hpp>
#include <witness/checker.hpp>
#include <witness/free_cells.hpp>
#include <witness/path.hpp>
#include <witness/samples.hpp>

namespace tcert::witness {

/// A path and what the checker says of it.
struct Witness {
  Path path;
  Checked checked;
};

struct Found {
  std::optional<Witness> witness;  ///< Not refused; its margin may be below 0.
  std::string reason;              ///< Why there is none.
};

/// The best path that was found, by what check() says of it. The work is bounded by `iterations`
/// steps of the band, never by a time, so that the same inputs give the same bits.
///
/// The widest path over every third vertex of the cells says how wide a path may be; the shortest
/// of those nearly as wide, then the driven one without its loops, are stretched as elastic bands,
/// coarse to fine, towards margins found by bisection. Whatever the search misses only makes the
/// margin smaller.
[[nodiscard]] Found search(const FreeCells& cells,
                           const Region& start,
                           const Region& goal,
                           const Robot& robot,
                           const Samples& samples,
                           int iterations);

}  // namespace tcert::witness
