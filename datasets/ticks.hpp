#pragma once
/// \file
/// Ticks of one trial on the 10 Hz grid, and how the raw streams become ticks (paper 3.1).

#include <cstddef>
#include <cstdint>
#include <tcert/command.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert {

/// Ticks of one trial; `readings` is row-major, ticks x rays.
struct TickTable {
  std::size_t rays = 0;
  std::vector<std::int64_t> time_ns;  ///< Strictly increasing; the bundle's own clock.
  std::vector<Pose> poses;
  std::vector<RayReading> readings;
  std::vector<std::uint8_t> stale;
  std::vector<std::uint8_t> segment_start;
  std::vector<double> speed_cmd_mps;  ///< Zero-order hold; NaN where there is none.
  std::vector<double> yaw_rate_cmd_rps;
  std::vector<Footing> footing{};  ///< By tick; empty if nothing of it is measured.

  [[nodiscard]] std::size_t size() const noexcept { return time_ns.size(); }

  /// View of tick `i`; valid while the table is not changed. \pre i < size().
  [[nodiscard]] Tick operator[](std::size_t i) const noexcept {
    return {time_ns[i],
            poses[i],
            std::span<const RayReading>(readings).subspan(i * rays, rays),
            stale[i] != 0,
            segment_start[i] != 0,
            footing.empty() ? Footing{} : footing[i]};
  }
  /// What the robot was told to drive at tick `i`; NaN where it is not known.
  [[nodiscard]] Command commanded(std::size_t i) const noexcept {
    return {speed_cmd_mps.empty() ? kMissing : speed_cmd_mps[i],
            yaw_rate_cmd_rps.empty() ? kMissing : yaw_rate_cmd_rps[i]};
  }
};

}  // namespace tcert
