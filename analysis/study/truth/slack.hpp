#pragma once
/// \file
/// From the clearance of a disc to the clearance slack of a body, in either convention.

namespace tcert::study {

/// What a clearance is counted as. Truth and certificate are compared in the same convention.
enum class SlackConvention {
  width,   ///< 2 (clearance - r_B): how much wider the corridor is than the body.
  radial,  ///< clearance - r_B: how far the body stays from the walls.
};

/// Metres; minus infinity stays minus infinity. \pre body_width_m > 0.
[[nodiscard]] constexpr double clearance_slack(double clearance_m,
                                               double body_width_m,
                                               SlackConvention convention) noexcept {
  return convention == SlackConvention::width ? 2.0 * clearance_m - body_width_m
                                              : clearance_m - 0.5 * body_width_m;
}

}  // namespace tcert::study
