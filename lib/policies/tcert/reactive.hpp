#pragma once
/// \file
/// M1: reactive, it goes by what it feels now.

#include <tcert/pilot.hpp>

namespace tcert::policies {

/// Takes the heading of the least J(theta) = w_g |theta - theta_G|/pi + w_c sum_k depth_k
/// K(theta - bearing_k) at v_cruise (1 - caution max_k depth_k). O(24 rays) a step.
class ReactivePolicy {
 public:
  /// \throws std::invalid_argument if the setup is out of range.
  explicit ReactivePolicy(const PolicySetup& setup) : pilot_(setup) {}

  Command step(const Senses& senses) noexcept;
  void reset() noexcept { pilot_.reset(); }
  [[nodiscard]] Pilot& pilot() noexcept { return pilot_; }
  [[nodiscard]] const Pilot& pilot() const noexcept { return pilot_; }

 private:
  Pilot pilot_;
};

}  // namespace tcert::policies
