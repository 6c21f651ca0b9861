#pragma once
/// \file
/// Speed gated by a margin: the two laws of the paper, by name.

#include <cstdint>

namespace tcert {

enum class SpeedLawKind : std::uint8_t {
  squash,  ///< Paper 3.5: 0 without margin, else squashed by z / (1 + z).
  clip,    ///< Paper 4.4 and guard G1: piecewise linear, clipped to [v_min, v_max]; never 0.
};

struct SpeedLaw {
  double min_speed_mps = 0.08;  ///< v_min > 0.
  double max_speed_mps = 0.22;  ///< v_max >= v_min.
  double beta_per_m = 10.0;     ///< Sensitivity; > 0.
  SpeedLawKind kind = SpeedLawKind::squash;
};

/// With s = beta * margin:
/// - squash: 0 for margin <= 0, else v_min + (v_max - v_min) s/(1 + s);
/// - clip: clip(v_min, v_max, v_min + (v_max - v_min) s), which rises as fast from margin 0 and is
///   v_max from margin 1/beta on. It never halts: that is left to the guards.
/// Both give 0 for NaN. Forward speed only; a retreat runs at v_min.
[[nodiscard]] double gated_speed(const SpeedLaw& law, double margin_m) noexcept;

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const SpeedLaw& law);

}  // namespace tcert
