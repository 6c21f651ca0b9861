#pragma once
/// \file
/// The 24 headings among which M1, M2, M3 and CB-V choose, and the two terms of J that they share.

#include <array>
#include <span>
#include <tcert/felt_rays.hpp>

namespace tcert::policies {

/// J of the headings that lie k * 15 degrees to the left of the robot's own, k = -11, ..., 12.
class HeadingCosts {
 public:
  static constexpr int kLowest = -11;
  static constexpr int kHighest = 12;

  /// Radians to the left.
  [[nodiscard]] static double turn_rad(int k) noexcept;
  /// Unit vector in the body frame.
  [[nodiscard]] static Point heading(int k) noexcept;

  [[nodiscard]] double operator[](int k) const noexcept { return cost_[index(k)]; }
  void add(int k, double cost) noexcept { cost_[index(k)] += cost; }

  /// The k of the least J. Ties: the least turn; of two that mirror each other, that towards `side`
  /// (+1 left, -1 right).
  [[nodiscard]] int cheapest(int side) const noexcept;

 private:
  [[nodiscard]] static std::size_t index(int k) noexcept {
    return static_cast<std::size_t>(k - kLowest);
  }
  std::array<double, kHighest - kLowest + 1> cost_{};
};

/// Adds weight * |theta_k - bearing| / pi to each.
void add_goal_cost(HeadingCosts& costs, double bearing_rad, double weight) noexcept;

/// Adds weight * sum over the rays of depth * K(theta_k - bearing of the ray).
void add_clearance_cost(HeadingCosts& costs, std::span<const FeltRay> rays, double weight) noexcept;

/// How far to turn for heading k: a heading stands for the sector of 15 degrees about it, so that
/// within the one that holds `bearing_rad` the robot turns to just there.
[[nodiscard]] double turn_into(int k, double bearing_rad) noexcept;

}  // namespace tcert::policies
