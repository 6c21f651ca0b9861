#pragma once
/// \file
/// What a foreign column may be to a bundle, and its unit, by its name and its values.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tcert::recording {

enum class ColumnRole : std::uint8_t {
  other,
  x,
  y,
  yaw,
  quaternion_x,
  quaternion_y,
  quaternion_z,
  quaternion_w,
  speed,
  yaw_rate,
  bend,
  range,
  force,
};

struct ColumnGuess {
  ColumnRole role = ColumnRole::other;
  std::string unit;  ///< "deg", "mm", ...: as a map takes it; empty: ours, or not known.
};

/// By the words of the name ("pose.position.x", "tx", "x [mm]", "left_bend_deg", "qw"), whose last
/// may be a unit, and where it has none by the largest magnitude of its values: a yaw beyond 7, a
/// bend beyond 3.5 are degrees, a range beyond 100 is in millimetres, a force beyond 50 in grams.
[[nodiscard]] ColumnGuess guess_column(std::string_view name,
                                       std::optional<double> least,
                                       std::optional<double> largest);

/// "x", "yaw", "range", ...; empty of other.
[[nodiscard]] std::string_view to_string(ColumnRole role) noexcept;

}  // namespace tcert::recording
