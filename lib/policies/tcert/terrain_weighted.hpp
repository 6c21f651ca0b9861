#pragma once
/// \file
/// M2: terrain-weighted, it shuns directions in which the way felt rough, and slows on them.

#include <tcert/bend_variance.hpp>
#include <tcert/pilot.hpp>

namespace tcert::policies {

/// M1's J + w_tau tau(theta), tau(theta) = sum_k variance_k K(theta - bearing_k) of the bend over
/// the last terrain_window_m; the speed is M1's times exp(-k_tau tau) of the heading taken.
class TerrainWeightedPolicy {
 public:
  /// \throws std::invalid_argument if the setup is out of range.
  explicit TerrainWeightedPolicy(const PolicySetup& setup);

  Command step(const Senses& senses) noexcept;
  void reset() noexcept;
  [[nodiscard]] Pilot& pilot() noexcept { return pilot_; }
  [[nodiscard]] const Pilot& pilot() const noexcept { return pilot_; }

 private:
  [[nodiscard]] double roughness(const Outlook& now, Point heading) const noexcept;
  Command take(const Outlook& now, double turn_rad) noexcept;

  Pilot pilot_;
  BendVariance variance_;
  double travel_m_ = 0.0;
};

}  // namespace tcert::policies
