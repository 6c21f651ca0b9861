#pragma once
/// \file
/// How the robot gets from one place to the next. Internal to the exploration.

#include <terrain/explore.hpp>
#include <vector>

namespace tcert::terrain {

struct Way {
  std::vector<Position> points;      ///< From the first after the start to the end.
  std::vector<Cell> cells;           ///< Stepped onto in between; the end only if it is a goal.
  std::vector<double> driven;        ///< Lengths of the controller's steps, cells.
  double walked = 0.0;               ///< Length of the rest, on routes and in line of sight.
  bool fell_back = false;            ///< The controller did not come to within a cell of its end.
  std::vector<Position> free_space;  ///< Of the controller as it set out.
};

/// By setup.motion over `ground`; straight, whatever lies between, if there is no way over it.
/// `is_goal`: nothing is measured at the end.
[[nodiscard]] Way way_to(const Grid& grid,
                         const CellSet& ground,
                         const Position& from,
                         Cell to,
                         bool is_goal,
                         const ExploreSetup& setup);

}  // namespace tcert::terrain
