#include "datasets/import/carmen_record.hpp"

#include <cmath>
#include <numbers>
#include <table/csv_write.hpp>

namespace tcert {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

void read_stamps(CarmenWords& words, CarmenScan& scan) {
  scan.ipc_timestamp = words.text();
  words.require(!scan.ipc_timestamp.empty(), "ipc_timestamp", "a time in seconds");
  words.text();  // the host
  scan.logger_timestamp = words.text();
}

void read_ranges(CarmenWords& words, CarmenScan& scan) {
  scan.beams.count = words.count("number of beams", 1.0, "a whole number, 1 to 4096");
  scan.ranges_m.assign(scan.beams.count, 0.0);
  for (double& range : scan.ranges_m) {
    words.range(range);
  }
}

}  // namespace

std::optional<CarmenFault> read_flaser(std::string_view rest, CarmenScan& scan) {
  CarmenWords words(rest);
  scan.beams = {};
  read_ranges(words, scan);
  words.pose("x", "y", "theta", scan.laser);
  words.pose("odom_x", "odom_y", "odom_theta", scan.robot);
  read_stamps(words, scan);
  return words.fault();
}

std::optional<CarmenFault> read_robot_laser(std::string_view rest, CarmenScan& scan) {
  CarmenWords words(rest);
  scan.beams = {};
  double ignored = 0.0;
  double first_rad = 0.0;
  double step_rad = 0.0;
  double furthest_m = 0.0;
  words.number("laser_type", ignored);
  words.number(
      "start_angle",
      first_rad,
      [](double v) { return std::abs(v) <= kFullTurn; },
      "an angle in radians, -6.28 to 6.28");
  words.number("field_of_view", ignored);
  words.number(
      "angular_resolution",
      step_rad,
      [](double v) { return v > 0.0 && v <= kFullTurn; },
      "an angle in radians between two beams, above 0");
  words.number(
      "maximum_range", furthest_m, [](double v) { return v > 0.0; }, "metres, above 0");
  words.number("accuracy", ignored);
  words.number("remission_mode", ignored);
  read_ranges(words, scan);
  words.require(step_rad * (static_cast<double>(scan.beams.count) - 1.0) <= 1.001 * kFullTurn,
                "angular_resolution",
                "an angle in radians with which all beams lie within one turn",
                table::number_text(step_rad));
  const std::size_t remissions =
      words.count("number of remissions", 0.0, "a whole number, 0 to 4096");
  for (std::size_t i = 0; i < remissions; ++i) {
    words.text();
  }
  words.pose("laser_pose_x", "laser_pose_y", "laser_pose_theta", scan.laser);
  words.pose("robot_pose_x", "robot_pose_y", "robot_pose_theta", scan.robot);
  for (const char* const field :
       {"laser_tv", "laser_rv", "forward_safety_dist", "side_safety_dist", "turn_axis"}) {
    words.number(field, ignored);
  }
  read_stamps(words, scan);
  scan.beams.step_rad = step_rad;
  scan.beams.straight_ahead = step_rad > 0.0 ? -first_rad / step_rad : 0.0;
  scan.beams.furthest_m = furthest_m;
  return words.fault();
}

std::optional<Pose> read_odom(std::string_view rest) {
  CarmenWords words(rest);
  Pose pose;
  words.pose("x", "y", "theta", pose);
  return words.fault() ? std::nullopt : std::optional(pose);
}

}  // namespace tcert
