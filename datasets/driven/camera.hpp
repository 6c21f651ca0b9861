#pragma once
/// \file
/// The monocular camera of CB-V: what it sees of the walls ahead.

#include <cstdint>
#include <span>
#include <table/random.hpp>
#include <tcert/senses.hpp>
#include <vector>

#include "datasets/corpus/design.hpp"
#include "datasets/corpus/wall_index.hpp"
#include "datasets/driven/drive_parameters.hpp"

namespace tcert {

/// A fan of directions from the body's middle, from left to right. In each an obstacle within
/// camera_range_m is seen with the probability that the lighting leaves, on its own; the noise of a
/// frame's heading turns all of its bearings alike. Ranges are true: what a camera does not know is
/// whether there is something, and where ahead is.
class Camera {
 public:
  /// `walls` know of walls within camera_range_m. A mirrored camera draws, and lists, from right
  /// to left.
  Camera(const DriveParameters& parameters,
         WallIndex walls,
         Lighting lighting,
         bool mirrored,
         table::RandomStream random);

  /// What is seen at `now_ns` from `pose`: a new frame if the last is old enough, else that one.
  [[nodiscard]] std::span<const policies::Sighting> look(std::int64_t now_ns, const Pose& pose);

 private:
  DriveParameters parameters_;
  WallIndex walls_;
  double seen_;
  double heading_sd_rad_;
  bool mirrored_;
  table::RandomStream random_;
  std::int64_t next_frame_ns_ = 0;
  std::vector<policies::Sighting> sightings_;
};

}  // namespace tcert
