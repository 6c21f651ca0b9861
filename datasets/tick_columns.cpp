#include "datasets/tick_columns.hpp"

#include <cmath>

namespace tcert {

namespace {

constexpr std::size_t kPoseColumns = 3;
constexpr std::size_t kColumnsPerRay = 2;

void add_ray_columns(const Robot& robot, table::NumberOptions& options) {
  for (const Ray& ray : robot.rays) {
    options.columns.push_back({value_column(ray), true, true});
    options.columns.push_back({force_column(ray), false, true});
  }
}

/// False if the value is neither 0 nor 1; a missing one stands for 0.
bool interpret_flag(double value, bool& flag) noexcept {
  flag = value == 1.0;
  return flag || value == 0.0 || std::isnan(value);
}

}  // namespace

std::string value_column(const Ray& ray) {
  return ray.name + (ray.kind == RayKind::bend ? "_bend_rad" : "_range_m");
}

std::string force_column(const Ray& ray) { return ray.name + "_fsr_n"; }

table::NumberOptions tactile_columns(const Robot& robot) {
  table::NumberOptions options;
  add_ray_columns(robot, options);
  return options;
}

table::NumberOptions tick_columns(const Robot& robot) {
  table::NumberOptions options;
  options.columns = {{"x_m"}, {"y_m"}, {"yaw_rad"}};
  add_ray_columns(robot, options);
  for (const char* name : {"speed_cmd_mps", "yaw_rate_cmd_rps"}) {
    options.columns.push_back({name, false, true});
  }
  for (const char* name : {"stale", "segment_start"}) {
    options.columns.push_back({name, false, true, true});
  }
  return options;
}

const char* interpret_tick(std::span<const double> row,
                           std::span<RayReading> readings,
                           TickRow& tick) noexcept {
  tick.pose = {{row[0], row[1]}, row[2]};
  const double* cell = row.data() + kPoseColumns;
  for (RayReading& reading : readings) {
    reading = {cell[0], cell[1]};
    cell += kColumnsPerRay;
  }
  tick.speed_cmd_mps = cell[0];
  tick.yaw_rate_cmd_rps = cell[1];
  if (!interpret_flag(cell[2], tick.stale)) {
    return "stale";
  }
  return interpret_flag(cell[3], tick.segment_start) ? nullptr : "segment_start";
}

}  // namespace tcert
