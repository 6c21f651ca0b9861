#pragma once
/// \file
/// The command nearest to a wanted one that keeps a barrier (paper 2.2, 3.5): a quadratic program
/// in two variables, solved exactly.

#include <cstddef>
#include <span>
#include <tcert/command.hpp>

namespace tcert {

/// a_v v + a_w w >= least.
struct BarrierRow {
  double speed = 0.0;
  double yaw_rate = 0.0;
  double least = 0.0;
};

/// What the body can do, and the units in which the distance of two commands is measured.
struct CommandBox {
  double min_speed_mps = 0.0;
  double max_speed_mps = 0.22;
  double max_yaw_rate_rps = 0.6;  ///< To either side.
  double speed_unit_mps = 0.22;   ///< > 0; W = diag(1/speed_unit^2, 1/yaw_unit^2).
  double yaw_unit_rps = 0.6;      ///< > 0.
};

/// Rows that are looked at beside the four of the box.
inline constexpr std::size_t kMostBarrierRows = 8;

struct FilteredCommand {
  Command command;
  bool feasible = true;  ///< False: no command keeps all rows, and the command is to halt.
};

/// Least (u - wanted)' W (u - wanted) / 2 over u = (v, w) within the box and on the right side of
/// each row. With two variables the optimum is `wanted` itself, its nearest point on one row, or
/// where two rows cross: 79 candidates at most, of which the best that keeps every row to within
/// rounding is taken, the first one on ties. No iteration and no slack; 0.8 us with eight rows.
/// \pre finite numbers; rows beyond kMostBarrierRows are not looked at.
[[nodiscard]] FilteredCommand nearest_command(const Command& wanted,
                                              std::span<const BarrierRow> rows,
                                              const CommandBox& box) noexcept;

}  // namespace tcert
