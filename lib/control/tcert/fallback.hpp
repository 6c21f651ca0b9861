#pragma once
/// \file
/// What a robot does when a rule alarms: it backs out, and after too many alarms it halts (paper 5,
/// section 8).

#include <array>
#include <cstdint>
#include <numbers>
#include <tcert/back_out.hpp>
#include <tcert/command.hpp>
#include <tcert/parameter_fields.hpp>
#include <vector>

namespace tcert {

/// See parameters/fallback.def.
struct FallbackParameters {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/fallback.def>
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const FallbackParameters& /*list*/, Visit&& visit) {
  using Group = FallbackParameters;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/fallback.def>
}

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const FallbackParameters& parameters);

enum class FallbackState : std::uint8_t { normal, stop, reverse, reorient, halt };

/// "normal", "stop", "reverse", "reorient", "halt".
[[nodiscard]] const char* fallback_word(FallbackState state) noexcept;

/// normal -> stop -> reverse -> re-orient -> normal; halt, for good, at the alarm that would begin
/// one manoeuvre more than halt_after within within_s. An alarm counts while the robot is normal
/// and is told to drive forward: in a manoeuvre it changes nothing, and reversing is never refused.
///
/// The constructor takes all memory; every other member is noexcept.
class Fallback {
 public:
  /// \throws std::invalid_argument if the parameters are out of range.
  Fallback(const FallbackParameters& parameters, double min_turn_radius_m);

  void reset() noexcept;

  /// The next `seconds` of the run, before `pose`: what to command in the place of `wanted`. `side`
  /// is the wider one, +1 left, -1 right.
  Command step(
      const Command& wanted, bool alarm, const Pose& pose, int side, double seconds) noexcept;

  [[nodiscard]] FallbackState state() const noexcept;
  /// Manoeuvres so far.
  [[nodiscard]] std::uint32_t manoeuvres() const noexcept { return manoeuvres_; }

 private:
  [[nodiscard]] bool may_begin() noexcept;

  FallbackParameters parameters_;
  BackOut back_out_;
  double now_s_ = 0.0;
  std::vector<double> began_s_;  // of the last halt_after manoeuvres, a ring
  std::uint32_t manoeuvres_ = 0;
  bool halted_ = false;
};

}  // namespace tcert
