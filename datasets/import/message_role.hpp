#pragma once
/// \file
/// What messages of the usual types are to a bundle, without a word in the map.

#include <cstdint>
#include <string_view>
#include <vector>

#include "datasets/import/log_map.hpp"

namespace tcert::recording {

enum class StreamRole : std::uint8_t { none, pose, scan, range, control, transforms };

/// By the canonical name of the type: Odometry, Pose(WithCovariance)(Stamped) and TransformStamped
/// are poses; LaserScan a scan; Range one ray; Twist(Stamped) control; TFMessage transforms.
[[nodiscard]] StreamRole role_of(std::string_view type) noexcept;

/// Fields of the columns of pose.csv or control.csv in a message of that type; empty if it has
/// none.
[[nodiscard]] std::vector<ValueSource> fields_of(std::string_view type);

}  // namespace tcert::recording
