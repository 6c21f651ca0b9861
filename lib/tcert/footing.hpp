#pragma once
/// \file
/// Margins of slope, step and slip, in metres (paper 2.1, Remark 1: "the minimum composition").

#include <tcert/parameters.hpp>
#include <tcert/tick.hpp>

namespace tcert {

/// tan theta of ground that is pitched and rolled: tan^2 p + tan^2 r + tan^2 p tan^2 r. Of one
/// angle alone where the other is missing; NaN where both are; infinite from a right angle on.
[[nodiscard]] double slope_of(const Footing& footing) noexcept;

/// The smallest of s (1 - x / x_crit) over what was measured, s = `scale_m`: slope against
/// min(friction, track / (2 height)), step against largest_step_m, slip against largest_slip. Of
/// level ground s, below 0 beyond what the robot can do, +infinity if nothing was measured.
[[nodiscard]] double footing_slack(const Footing& footing,
                                   const CertificateParameters& parameters,
                                   double scale_m) noexcept;

[[nodiscard]] bool is_measured(const Footing& footing) noexcept;

/// Takes the larger of each, in size: of several samples the worst.
void keep_worst(const Footing& now, Footing& worst) noexcept;

/// What a tick does not measure is as it was last: `last` takes what `now` has.
void keep_known(const Footing& now, Footing& last) noexcept;

}  // namespace tcert
