#include <algorithm>
#include <tcert/fallback.hpp>

namespace tcert {
namespace {

BackOutLimits limits_of(const FallbackParameters& p, double min_turn_radius_m) {
  validate(p);
  return {p.stop_s,
          p.reverse_m,
          p.reverse_mps,
          p.reorient_rad,
          min_turn_radius_m > 0.0 ? std::min(p.turn_rate_rps, p.reverse_mps / min_turn_radius_m)
                                  : p.turn_rate_rps,
          min_turn_radius_m};
}

}  // namespace

void validate(const FallbackParameters& p) { require_fields(p); }

const char* fallback_word(FallbackState state) noexcept {
  constexpr std::array kWords{"normal", "stop", "reverse", "reorient", "halt"};
  return kWords[static_cast<std::size_t>(state)];
}

Fallback::Fallback(const FallbackParameters& parameters, double min_turn_radius_m)
    : parameters_(parameters),
      back_out_(limits_of(parameters, min_turn_radius_m)),
      began_s_(parameters.halt_after) {}

void Fallback::reset() noexcept {
  back_out_.reset();
  now_s_ = 0.0;
  manoeuvres_ = 0;
  halted_ = false;
}

// The oldest of the last halt_after manoeuvres began too lately: one more is one too many.
bool Fallback::may_begin() noexcept {
  double& slot = began_s_[manoeuvres_ % began_s_.size()];
  if (manoeuvres_ >= began_s_.size() && now_s_ - slot <= parameters_.within_s) {
    return false;
  }
  slot = now_s_;
  return true;
}

Command Fallback::step(
    const Command& wanted, bool alarm, const Pose& pose, int side, double seconds) noexcept {
  now_s_ += seconds;
  if (halted_) {
    return {};
  }
  if (!back_out_.is_over()) {
    back_out_.advance(pose, false, seconds);
  } else if (alarm && wanted.speed_mps > 0.0) {
    if (!may_begin()) {
      halted_ = true;
      return {};
    }
    ++manoeuvres_;
    back_out_.begin(pose, side);
  }
  return back_out_.is_over() ? wanted : back_out_.command();
}

FallbackState Fallback::state() const noexcept {
  if (halted_) {
    return FallbackState::halt;
  }
  switch (back_out_.phase()) {
    case BackOut::Phase::stopping:
      return FallbackState::stop;
    case BackOut::Phase::reversing:
      return FallbackState::reverse;
    case BackOut::Phase::turning:
      return FallbackState::reorient;
    case BackOut::Phase::none:
      break;
  }
  return FallbackState::normal;
}

}  // namespace tcert
