#pragma once
/// \file
/// CB-V: a camera baseline, it goes by what it sees and not by what it feels.

#include <array>
#include <tcert/headings.hpp>
#include <tcert/pilot.hpp>

namespace tcert::policies {

/// M1's J and speed on what is seen: in each sector of 15 degrees the nearest sighting is a ray
/// from the body's centre whose reach is camera_near_m. It still recovers where it presses.
/// O(sightings + 24^2) a step.
class CameraPolicy {
 public:
  /// \throws std::invalid_argument if the setup is out of range.
  explicit CameraPolicy(const PolicySetup& setup) : pilot_(setup) {}

  Command step(const Senses& senses) noexcept;
  void reset() noexcept { pilot_.reset(); }
  [[nodiscard]] Pilot& pilot() noexcept { return pilot_; }
  [[nodiscard]] const Pilot& pilot() const noexcept { return pilot_; }

 private:
  Pilot pilot_;
};

/// What is seen, by heading: entry k - HeadingCosts::kLowest. A depth of NaN is nothing seen.
using SeenRays = std::array<FeltRay, HeadingCosts::kHighest - HeadingCosts::kLowest + 1>;

/// The nearest sighting of each sector, whatever their order; those without a finite bearing or
/// range, or beyond `near_m`, are none.
[[nodiscard]] SeenRays seen_rays(std::span<const Sighting> sightings, double near_m) noexcept;

}  // namespace tcert::policies
