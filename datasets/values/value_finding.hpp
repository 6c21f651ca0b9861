#pragma once
/// \file
/// A sign that the values of a trial are not what their columns' names say.

#include <cstdint>
#include <string>
#include <table/diagnostic.hpp>
#include <utility>

namespace tcert {

enum class ValueKind : std::uint8_t {
  bend_unit,      ///< Bends outside the calibration: degrees?
  mount_unit,     ///< Rays mounted metres away from the body: millimetres?
  range_unit,     ///< Ranges far beyond the reach: millimetres, centimetres?
  bearing_unit,   ///< Bearings beyond a turn: degrees?
  force_unit,     ///< Forces that no tip takes: grams?
  yaw,            ///< Headings that do not follow the motion: degrees, another frame?
  speed,          ///< Poses too fast: millimetres, another unit of time?
  duration,       ///< A log much longer or shorter than its trial: another unit of time?
  start_outside,  ///< The first pose lies outside S.
  goal_missed,    ///< A success that never entered G.
  goal_at_start,  ///< The first pose lies in G.
  contact_stuck,  ///< A contact that outlives its wall.
  ray_stuck,      ///< A reading that never moves.
  ray_hung,       ///< A reading that ceases to move.
  ray_twin,       ///< Two rays that are one.
  ray_silent,     ///< A ray without readings beside others that have them.
  footing,        ///< Slopes, steps or slips that nothing stands on: degrees, millimetres?
};

/// A warning, with its kind: so that those of many trials can be said once.
struct ValueFinding {
  ValueKind kind = ValueKind::bend_unit;
  table::Diagnostic diagnostic;
};

/// A warning of a whole log; `file` is filled in by who knows it.
[[nodiscard]] inline ValueFinding value_finding(ValueKind kind,
                                                std::string column,
                                                std::string found,
                                                std::string expectation) {
  return {kind,
          {table::Severity::warning,
           "",
           0,
           std::move(column),
           std::move(found),
           std::move(expectation),
           1}};
}

}  // namespace tcert
