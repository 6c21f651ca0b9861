#include "datasets/tick_columns.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "datasets/bundle_fields.hpp"

namespace tcert {

namespace {

constexpr std::size_t kPoseColumns = 3;

std::string_view value_name(const Ray& ray) {
  return ray.kind == RayKind::bend ? kBendColumn : kRangeColumn;
}

/// Without its time, and without when it arrived.
void append_fields(const std::string& file, table::NumberOptions& options) {
  for (const FileField& field : fields_at(file, bundle_fields())) {
    if (field.name != options.time_column && !field.is_time) {
      options.columns.push_back(number_column(field, std::string(field.name)));
    }
  }
}

/// "<ray>_fsr_n" of a ray.
std::string ray_column(const Ray& ray, std::string_view name) {
  return ray.name + std::string(name.substr(kRayMark.size()));
}

void add_ray_columns(const Robot& robot, table::NumberOptions& options) {
  const std::vector<FileField> fields = fields_at("tactile.csv", bundle_fields());
  for (const Ray& ray : robot.rays) {
    for (const std::string_view name : {value_name(ray), kForceColumn, kBearingColumn}) {
      const auto field = std::ranges::find(fields, name, &FileField::name);
      options.columns.push_back(number_column(*field, ray_column(ray, name)));
    }
  }
}

/// Always the last column of a stream.
void add_arrival(const std::string& file, table::NumberOptions& options) {
  const std::vector<FileField> fields = fields_at(file, bundle_fields());
  const auto field = std::ranges::find(fields, true, &FileField::is_time);
  options.columns.push_back(number_column(*field, std::string(field->name)));
}

/// False if the value is neither 0 nor 1; a missing one stands for 0.
bool interpret_flag(double value, bool& flag) noexcept {
  flag = value == 1.0;
  return flag || value == 0.0 || std::isnan(value);
}

}  // namespace

std::string value_column(const Ray& ray) { return ray_column(ray, value_name(ray)); }

std::string force_column(const Ray& ray) { return ray_column(ray, kForceColumn); }

std::string bearing_column(const Ray& ray) { return ray_column(ray, kBearingColumn); }

table::NumberOptions stream_columns(const std::string& file) {
  table::NumberOptions options;
  append_fields(file, options);
  add_arrival(file, options);
  return options;
}

table::NumberOptions tactile_columns(const Robot& robot) {
  table::NumberOptions options;
  add_ray_columns(robot, options);
  add_arrival("tactile.csv", options);
  return options;
}

table::NumberOptions tick_columns(const Robot& robot) {
  table::NumberOptions options;
  append_fields("pose.csv", options);
  add_ray_columns(robot, options);
  append_fields("ticks.csv", options);
  return options;
}

const char* interpret_tick(std::span<const double> row,
                           const RangeRules& rules,
                           std::span<RayReading> readings,
                           std::span<RangeCount> counts,
                           TickRow& tick) noexcept {
  tick.pose = {{row[0], row[1]}, row[2]};
  tick.footing = {row[3], row[4], row[5], row[6]};
  const double* cell = row.data() + kPoseColumns + kFootingColumns;
  bool silent = true;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    readings[k] = {rules.resolve(k, cell[0], counts[k]), cell[1], cell[2]};
    silent = silent && std::isnan(readings[k].value) && std::isnan(readings[k].fsr_n);
    cell += kColumnsPerRay;
  }
  tick.speed_cmd_mps = cell[0];
  tick.yaw_rate_cmd_rps = cell[1];
  if (!interpret_flag(cell[2], tick.stale)) {
    return "stale";
  }
  tick.stale = tick.stale || (silent && !readings.empty());
  return interpret_flag(cell[3], tick.segment_start) ? nullptr : "segment_start";
}

}  // namespace tcert
