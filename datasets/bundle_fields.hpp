#pragma once
/// \file
/// Every column and key of the files of a log bundle.

#include <span>
#include <string_view>

#include "datasets/file_field.hpp"

namespace tcert {

/// Columns that stand once for each ray, "<ray>" being its name.
inline constexpr std::string_view kRayMark = "<ray>";
inline constexpr std::string_view kBendColumn = "<ray>_bend_rad";
inline constexpr std::string_view kRangeColumn = "<ray>_range_m";
inline constexpr std::string_view kForceColumn = "<ray>_fsr_n";
inline constexpr std::string_view kBearingColumn = "<ray>_bearing_rad";

/// Of the streams, never of ticks.csv: ticks are what was there already.
inline constexpr std::string_view kArrivalColumn = "arrival_s";

/// The places are the files "trials.csv", "pose.csv", "tactile.csv", "control.csv" and "ticks.csv",
/// which has the columns of pose.csv and tactile.csv, arrival_s left out, before its own, and
/// "bundle.json" with its objects "robot", "ray", "calibration", "course", "region" and "disc".
[[nodiscard]] std::span<const FileField> bundle_fields() noexcept;

}  // namespace tcert
