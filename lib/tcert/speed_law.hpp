#pragma once
/// \file
/// Speed gated by the margin (paper 3.5).

namespace tcert {

struct SpeedLaw {
  double min_speed_mps = 0.08;  ///< v_min > 0.
  double max_speed_mps = 0.22;  ///< v_max >= v_min.
  double beta_per_m = 10.0;     ///< Sensitivity; > 0.
};

/// v = 0 for margin <= 0 (or NaN), else v_min + (v_max - v_min) s/(1 + s) with s = beta * margin.
/// Forward speed only; a retreat runs at v_min.
[[nodiscard]] double gated_speed(const SpeedLaw& law, double margin_m) noexcept;

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const SpeedLaw& law);

}  // namespace tcert
