#pragma once
/// \file
/// An upper bound of T(E; A) that knows the turning limit.

#include <tcert/robot.hpp>

#include "analysis/study/truth/slack.hpp"
#include "datasets/world.hpp"

namespace tcert::study {

/// A margin between `least_m` and `most_m` that no path from S to G has more of, to a millimetre of
/// what the cells can tell.
///
/// Whether a path of margin m may exist is asked of a graph in which every one would be found. Such
/// a path keeps the clearance c that m asks for and turns on no circle smaller than R = R_min + m.
/// So in each L = delta R of its length its heading changes by delta at most: of headings in n =
/// 2 pi / delta bins it stays in one or comes into the next, and is displaced by something within a
/// box that depends on which. Cells are joined that some points of are displaced so, and those are
/// left out of which no point has the clearance. A margin of which the graph has no way from S to G
/// is one that no path has. What is lost: R comes out too small, by an eighth in
/// cells of R / 35. Nothing is found out where c or R is below 2 cells.
///
/// O(log(range) cells n (L / cell)) time, n bytes a cell.
/// \throws std::invalid_argument without S or G, or if cells times bins are more than 2^26.
[[nodiscard]] double turning_upper(const World& world,
                                   const Robot& robot,
                                   SlackConvention convention,
                                   double least_m,
                                   double most_m,
                                   double cell_m);

}  // namespace tcert::study
