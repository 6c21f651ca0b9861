#pragma once
/// \file
/// T-VFH: the vector field histogram of Borenstein and Koren (1991) on a grid of touches.

#include <tcert/certainty_grid.hpp>
#include <tcert/pilot.hpp>
#include <tcert/polar_histogram.hpp>

namespace tcert::policies {

/// Steers into the valley of the smoothed polar density that lies nearest to the carrot. Its speed
/// is V = V_max (1 - min(h'_c, h_m)/h_m) (1 - |Omega|/Omega_max) + V_min, h'_c the density straight
/// ahead, Omega the yaw rate, V_max + V_min the cruise. O((d_max / cell)^2) a step.
class HistogramPolicy {
 public:
  /// \throws std::invalid_argument if the setup is out of range, or the course too large for
  /// max_policy_cells.
  explicit HistogramPolicy(const PolicySetup& setup) : pilot_(setup), grid_(setup) {}

  Command step(const Senses& senses) noexcept;
  void reset() noexcept;
  [[nodiscard]] Pilot& pilot() noexcept { return pilot_; }
  [[nodiscard]] const Pilot& pilot() const noexcept { return pilot_; }

 private:
  [[nodiscard]] double turn(const Outlook& now, const Densities& density) const noexcept;

  Pilot pilot_;
  CertaintyGrid grid_;
};

}  // namespace tcert::policies
