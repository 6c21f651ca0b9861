#pragma once
/// \file
/// How the robot gets from one place to the next. Internal to the exploration.

#include <terrain/explore.hpp>
#include <vector>

namespace tcert::terrain {

struct Way {
  std::vector<Position> points;      ///< From the first after the start to the end.
  std::vector<Cell> cells;           ///< Stepped onto in between; the end only if it is a goal.
  double length = 0.0;               ///< Cells.
  double by_controller = 0.0;        ///< Of it, gone by the controller; the rest by a route.
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
