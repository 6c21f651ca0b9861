#pragma once
/// \file
/// A free space, made ready once for all the paths that are looked for in it.

#include <witness/checker.hpp>
#include <witness/distance_field.hpp>
#include <witness/free_cells.hpp>

namespace tcert::witness {

/// Of cells that outlive it.
struct SearchSpace {
  /// O(cells) time, 8 bytes a cell.
  explicit SearchSpace(const FreeCells& cells) : checker(cells), field(cells) {}
  explicit SearchSpace(FreeCells&&) = delete;

  Checker checker;
  DistanceField field;
};

}  // namespace tcert::witness
