#pragma once
/// \file
/// The values of a stream of ours from the cells or fields of a foreign row.

#include <cstddef>
#include <span>
#include <vector>

#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// Yaw of a quaternion in radians, -pi to pi; NaN unless its length is 1 to 1 %.
[[nodiscard]] double yaw_of(double x, double y, double z, double w) noexcept;

/// The value of `source` from those of its columns: scaled and shifted, or the yaw of a quaternion.
/// \pre `columns` has as many as the source.
[[nodiscard]] double value_of(const ValueSource& source, std::span<const double> columns) noexcept;

/// How often readings of ranges were none.
struct RangeUse {
  std::size_t readings = 0;    ///< Cells that are not empty.
  std::size_t no_return = 0;   ///< Nothing in reach, as the map says.
  std::size_t not_ranges = 0;  ///< Missing: NaN, 0 or less, too short, too long.
};

/// What a reading in metres, which value_of() made by `source`, says: `reach_m` if nothing
/// returned, 0 for -inf (nearer than the shortest range, REP 117), NaN if it is none. The values of
/// the rule are as the file has them. NaN is not counted: an empty cell.
[[nodiscard]] double range_of(
    double reading, const ValueSource& source, const NoReturn& rule, double reach_m, RangeUse& use);

}  // namespace tcert::recording
