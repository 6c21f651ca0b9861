#pragma once
/// \file
/// Speed gated by a margin: the two laws of the paper and two that look further, by name.

#include <cstdint>
#include <tcert/parameter_fields.hpp>

namespace tcert {

enum class SpeedLawKind : std::uint8_t {
  squash,   ///< Paper 3.5: 0 without margin, else squashed by z / (1 + z).
  clip,     ///< Paper 4.4 and guard G1: piecewise linear, clipped to [v_min, v_max]; never 0.
  barrier,  ///< v_max, filtered by what was felt: see barrier_law.hpp.
  profile,  ///< As clip by the tick margin, within what the body can brake and gain.
};

/// v_max >= v_min. See parameters/speed_law.def.
struct SpeedLaw {
#define TCERT_WORD TCERT_MEMBER_WORD
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/speed_law.def>
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const SpeedLaw& /*list*/, Visit&& visit) {
  using Group = SpeedLaw;
#define TCERT_WORD TCERT_VISIT_WORD
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/speed_law.def>
}

/// With s = beta * margin:
/// - squash: 0 for margin <= 0, else v_min + (v_max - v_min) s/(1 + s);
/// - clip: clip(v_min, v_max, v_min + (v_max - v_min) s), which rises as fast from margin 0 and is
///   v_max from margin 1/beta on. It never halts: that is left to the guards.
/// - barrier: v_max, whatever the margin: the filter of barrier_law.hpp is what holds it back;
/// - profile: as clip, before speed_profile.hpp holds it back.
/// All give 0 for NaN. Forward speed only; a retreat runs at v_min.
[[nodiscard]] double gated_speed(const SpeedLaw& law, double margin_m) noexcept;

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const SpeedLaw& law);

}  // namespace tcert
