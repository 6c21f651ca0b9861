#pragma once
/// \file
/// The reactive controller: in the mapped plane straight to the projected goal, pulled back.

#include <terrain/obstacle_map.hpp>
#include <vector>

namespace tcert::terrain {

struct ControllerOptions {
  double robot_radius = 2.0;
  double simplification = 4.0;         ///< Tolerance of outlines.
  double gain = 0.2;                   ///< Of a frame.
  double longest_step = 2.5;           ///< Cells a frame.
  double standstill = 0.1;             ///< |u| below this is an equilibrium.
  std::size_t standstill_frames = 20;  ///< So is coming no further than a cell in so many frames.
  int most_frames = 2000;
};

struct ReactiveWay {
  std::vector<Position> path;        ///< From the start; ends where the controller stood still.
  std::vector<Position> free_space;  ///< Local free space at the start of the way.
  bool arrived = false;              ///< Within one cell of the target.
  std::size_t triangles = 0;
};

/// Moves from one position to another within one part of the ground. Every point of the way rounds
/// to a cell of the ground: a step that would not is shortened, and the way ends where none is
/// left. Outlines keep their holes and are simplified towards the ground only.
[[nodiscard]] ReactiveWay reactive_way(const Grid& grid,
                                       const CellSet& ground,
                                       const Position& from,
                                       const Position& to,
                                       const ControllerOptions& options);

}  // namespace tcert::terrain
