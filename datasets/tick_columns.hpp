#pragma once
/// \file
/// The columns of the logs of a given robot, and how a row of numbers becomes a tick.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <table/csv.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>

#include "datasets/range_rule.hpp"
#include "datasets/ticks.hpp"

namespace tcert {

/// "<ray>_bend_rad" or "<ray>_range_m", by the ray's kind.
[[nodiscard]] std::string value_column(const Ray& ray);

/// "<ray>_fsr_n".
[[nodiscard]] std::string force_column(const Ray& ray);

/// "<ray>_bearing_rad".
[[nodiscard]] std::string bearing_column(const Ray& ray);

/// Of a pose, after its own three: pitch_rad, roll_rad, step_m and slip.
inline constexpr std::size_t kFootingColumns = 4;

/// Of a ray: its value, its force and its bearing.
inline constexpr std::size_t kColumnsPerRay = 3;

/// pose.csv or control.csv: its columns but the time, arrival_s the last.
[[nodiscard]] table::NumberOptions stream_columns(const std::string& file);

/// tactile.csv: per ray its value, required, its force and its bearing, optional; each may be
/// empty. Then arrival_s.
[[nodiscard]] table::NumberOptions tactile_columns(const Robot& robot);

/// ticks.csv: pose, then as tactile.csv, then the optional speed_cmd_mps, yaw_rate_cmd_rps, stale
/// and segment_start.
[[nodiscard]] table::NumberOptions tick_columns(const Robot& robot);

/// What one row of ticks.csv says besides its time and readings.
struct TickRow {
  Pose pose;
  Footing footing;
  double speed_cmd_mps = kMissing;
  double yaw_rate_cmd_rps = kMissing;
  bool stale = false;
  bool segment_start = false;
};

/// Interprets a row that was read with tick_columns(): its readings go to `readings`, one per ray,
/// as `rules` understand them, and are counted in `counts`. A tick at which no ray reads anything
/// is stale: the touch was silent. Returns the name of a column whose value is neither 0 nor 1 nor
/// missing, or null. \pre as many readings and counts as `rules` has rays.
[[nodiscard]] const char* interpret_tick(std::span<const double> row,
                                         const RangeRules& rules,
                                         std::span<RayReading> readings,
                                         std::span<RangeCount> counts,
                                         TickRow& tick) noexcept;

}  // namespace tcert
