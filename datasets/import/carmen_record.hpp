#pragma once
/// \file
/// One line of a CARMEN log: a scan with its poses, or a pose of the odometry.

#include <optional>
#include <string_view>
#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/import/carmen_beams.hpp"
#include "datasets/import/carmen_words.hpp"

namespace tcert {

/// A scan. Texts lie in the line that was read.
struct CarmenScan {
  CarmenBeams beams;             ///< Of a FLASER record only their number is known.
  std::vector<double> ranges_m;  ///< From right to left; NaN: missing; infinite: no return.
  Pose laser;
  Pose robot;
  std::string_view ipc_timestamp;
  std::string_view logger_timestamp;  ///< Empty if the line ends before it.
};

/// Both read the rest of a line behind its first word, and say what is wrong with it, if anything.
/// The line must lie in a table::Bytes. Numbers are finite, ranges 0 or more; a range may also be
/// `inf` (no return), `-inf` (nearer than the laser can measure: 0) or `nan` (missing).
///
/// FLASER n r_1..r_n x y theta odom_x odom_y odom_theta ipc_timestamp host logger_timestamp:
/// metres and radians; x y theta is where the laser was, odom_* where the robot was.
[[nodiscard]] std::optional<CarmenFault> read_flaser(std::string_view rest, CarmenScan& scan);

/// ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range accuracy
/// remission_mode n r_1..r_n m e_1..e_m laser_x laser_y laser_theta robot_x robot_y robot_theta
/// laser_tv laser_rv forward_safety_dist side_safety_dist turn_axis ipc_timestamp host
/// logger_timestamp: beam i at start_angle + i angular_resolution, in radians.
/// http://carmen.sourceforge.net/logger_playback.html.
[[nodiscard]] std::optional<CarmenFault> read_robot_laser(std::string_view rest, CarmenScan& scan);

/// ODOM x y theta ...: empty if the three are no numbers.
[[nodiscard]] std::optional<Pose> read_odom(std::string_view rest);

}  // namespace tcert
