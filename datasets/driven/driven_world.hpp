#pragma once
/// \file
/// A world to be driven: its walls, where the robot starts, and the lanes that lead through it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/corpus/wall_index.hpp"
#include "datasets/driven/drive_parameters.hpp"
#include "datasets/driven/relief.hpp"
#include "datasets/random_worlds/random_world.hpp"

namespace tcert {

struct DrivenWorld {
  World world;
  std::vector<Region> edge_walls;  ///< Stand for the bounds where the robot can feel them.
  Pose start;                      ///< In S, in free space.
  /// Way-points: lobes in the order of the way, of each the lanes to choose from, of each lane its
  /// points from S's side to G's, at least two. They lie on centre lines and say nothing of gates.
  std::vector<std::vector<std::vector<Point>>> lobes;
  /// Width less body width of the narrowest passage on the widest way, where it is known: of a
  /// figure-8 by the lanes' least gates.
  std::optional<double> margin_m;
  std::vector<ReliefPatch> relief;     ///< Ramps and steps; none on level ground.
  std::vector<double> gate_margins_m;  ///< Of a figure-8, lane by lane; about -0.4 in blocked ones.
  std::uint32_t redraws = 0;           ///< Worlds that were drawn before it and not passable.
  std::uint64_t day = 0;
  double calibration_bias_m = 0.0;  ///< Added on that day to what every tentacle reads.
};

/// World k of a seed, a figure-8 of the corpus: its radii, places of gates and days (30 worlds
/// each, which shift lanes and gates), but one distribution of margins that no outcome and no
/// policy has a part in. The margins of a world's gates are gate_margin_m + gate_sd_m (sqrt(c) z +
/// sqrt(1 - c) e_i), z shared, c = gate_correlation; each lane is blocked at blocked_share. With
/// WorldChoice::passable margins and blocks are drawn until each lobe has a lane of margin > 0,
/// which leaves another distribution: `redraws` says how often. Ramps and steps: draw_relief(); no
/// world is drawn again for them, and `margin_m` is of the plane.
///
/// It depends on (seed, k) and the parameters alone. The robot stands behind the first post and
/// faces the lane that `lobes` lists first; which one this is, is drawn.
/// \throws std::invalid_argument if 10,000 draws in a row are not passable.
[[nodiscard]] DrivenWorld draw_gated_world(const DriveParameters& parameters,
                                           std::uint64_t seed,
                                           std::uint64_t index);

/// A random world to be driven: it starts as its run does, and has one lane, the run's way without
/// its turns back, until G.
[[nodiscard]] DrivenWorld driven_world(const RandomWorld& drawn);

/// The world seen in a mirror along the x axis: y and yaw change their sign, and whatever is a list
/// keeps its order.
[[nodiscard]] DrivenWorld mirrored(const DrivenWorld& driven);

/// Of a disc its centre, of a polygon the mean of its vertices.
[[nodiscard]] Point middle_of(const Region& region);

/// All that the robot can feel or see, known within `range_m`.
[[nodiscard]] WallIndex walls_of(const DrivenWorld& driven, double range_m);

}  // namespace tcert
