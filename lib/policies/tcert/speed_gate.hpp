#pragma once
/// \file
/// A policy's command at the speed that a law grants.

#include <tcert/policy_parameters.hpp>
#include <tcert/senses.hpp>
#include <tcert/speed_law.hpp>

namespace tcert::policies {

/// The law's speed takes the place of the policy's cruise, its caution stays a factor: the margin
/// is blind ahead. The margin changes with travel alone, so a law that halts without margin would
/// halt for good; in the loop it leaves at least creep_mps, where 0 is the law as printed.
///
/// The path keeps its curvature: the yaw rate is scaled alike and, where that is more than
/// max_yaw_rate_rps, both are lowered. Reversing and turning on the spot are left as they are.
/// Speed is at most the larger of granted and creep_mps. A granted speed of NaN is none: it creeps.
[[nodiscard]] Command at_granted_speed(const Command& wanted,
                                       double granted_mps,
                                       const PolicyParameters& parameters) noexcept;

/// At the speed that a law grants at the margin m_t of the tick.
[[nodiscard]] inline Command gated(const Command& wanted,
                                   const SpeedLaw& law,
                                   double margin_m,
                                   const PolicyParameters& parameters) noexcept {
  return at_granted_speed(wanted, gated_speed(law, margin_m), parameters);
}

}  // namespace tcert::policies
