#include "datasets/import/carmen_bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tcert {
namespace {

constexpr double kLongestStop = 60.0;
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string ray_name(std::size_t beam) { return fmt::format("b{:03}", beam); }

double reach_of(const CarmenLog& log, const CarmenImportOptions& options) noexcept {
  return std::min(options.reach_m, log.beams.furthest_m);
}

std::string words_on_poses(const CarmenLog& log) {
  const std::size_t odometry = log.odometry_records;
  switch (log.origin) {
    case CarmenPoses::odometry:
      return fmt::format(
          " scans with the poses of the odometry, which drifts: they were not scan-matched (they "
          "lie on the way of its {} odometry records)",
          odometry);
    case CarmenPoses::unknown:
      return " scans with the poses that it gives; whether they were scan-matched cannot be told, "
             "for it has no odometry records";
    case CarmenPoses::corrected:
      break;
  }
  return fmt::format(
      " scans with corrected poses; its {} odometry records are in another frame and are not used",
      odometry);
}

std::string words_on_laser(const CarmenLog& log, const CarmenReading& reading) {
  std::string text;
  if (reading.fov_rad) {
    text += fmt::format(" Its {} beams were spread over {:g} degrees (--fov).",
                        log.beams.count,
                        *reading.fov_rad * kDegrees);
  }
  const Pose mount = log.mount.value_or(Pose{});
  if (mount.position != Point{} || mount.yaw_rad != 0.0) {
    text +=
        fmt::format(" The laser is at ({:.3f}, {:.3f}) m on the robot, turned by {:.2f} degrees.",
                    mount.position.x_m,
                    mount.position.y_m,
                    mount.yaw_rad * kDegrees);
  }
  return text;
}

std::string words_on_clock(const CarmenReading& reading) {
  switch (reading.clock) {
    case CarmenClock::order:
      return fmt::format(
          " Times are made from the order of its records, {:g} a second: speeds and gaps mean "
          "nothing.",
          reading.rate_hz);
    case CarmenClock::logger:
      return " Times are those of the logger.";
    case CarmenClock::ipc:
      break;
  }
  return "";
}

}  // namespace

CarmenSummary summarise(const CarmenLog& log, const CarmenImportOptions& options) {
  CarmenSummary summary;
  summary.scans = log.scans();
  summary.beams = log.beams.count;
  summary.odometry_records = log.odometry_records;
  summary.reach_m = reach_of(log, options);
  summary.duration_s = static_cast<double>(log.time_ns.back() - log.time_ns.front()) * 1e-9;
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.scans(); ++i) {
    const double step = distance(log.poses[i - 1].position, log.poses[i].position);
    const double silence = static_cast<double>(log.time_ns[i] - log.time_ns[i - 1]) * 1e-9;
    summary.distance_m += step;
    summary.longest_step_m = std::max(summary.longest_step_m, step);
    summary.longest_silence_s = std::max(summary.longest_silence_s, silence);
    steps.push_back(step);
  }
  if (!steps.empty()) {
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    summary.median_step_m = *middle;
  }
  return summary;
}

BundleInfo carmen_bundle_info(const CarmenLog& log,
                              const std::string& source,
                              const CarmenImportOptions& options) {
  const Pose mount = log.mount.value_or(Pose{});
  BundleInfo info;
  info.provenance = fmt::format(
      "Imported from the CARMEN log {}: {}{}.{}{} The parameters suit scans up to about a metre "
      "apart (the median of all steps is {:.2f} m here): edges of 1 m hold two or three, steps up "
      "to 1.5 m do not break the path, sides look 46 degrees off square and back over the last "
      "scan, laps merge within 0.75 m; the robot turns on the spot, and a beam's return is not a "
      "contact.",
      source,
      log.scans(),
      words_on_poses(log),
      words_on_laser(log, options.reading),
      words_on_clock(options.reading),
      summarise(log, options).median_step_m);
  info.robot.body_width_m = options.body_width_m;
  info.robot.min_turn_radius_m = 0.0;
  for (std::size_t beam = 0; beam < log.beams.count; ++beam) {
    info.robot.rays.push_back({ray_name(beam),
                               mount.position,
                               log.beams.bearing_rad(beam) + mount.yaw_rad,
                               reach_of(log, options),
                               RayKind::range,
                               {}});
  }
  info.course.start = Disc{log.poses.front().position, options.start_radius_m};
  if (options.goal) {
    info.course.goal = *options.goal;
  }
  info.max_gap_s = kLongestStop;
  info.parameters = {{"curvature", "none"},
                     {"edge_length_m", "1.0"},
                     {"max_step_m", "1.5"},
                     {"memory_weight_m", "0.0"},
                     {"merge_radius_m", "0.75"},
                     {"reversal_m", "0.3"},
                     {"side_angle_rad", "0.8"},
                     {"side_window_m", "0.7"},
                     {"travel_deadband_m", "0.02"}};
  return info;
}

}  // namespace tcert
