#include "datasets/driven/wedge_watch.hpp"

namespace tcert {

void WedgeWatch::watch(double seconds,
                       double speed_cmd_mps,
                       bool touches,
                       Point position) noexcept {
  if (place_ && distance(position, *place_) > parameters_.wedge_place_m) {
    place_.reset();
    failed_ = 0;
    hopeless_s_ = 0.0;
  }
  if (speed_cmd_mps < 0.0) {
    if (touched_) {
      ++recoveries_;
      be_stopped(position);
    }
    touched_ = false;
    restart(position);
    return;
  }
  touched_ = touched_ || touches;
  if (distance(position, from_) > parameters_.stall_travel_m) {
    restart(position);
  }
  if (speed_cmd_mps > 0.0) {
    forward_s_ += seconds;
    if (failed_ >= parameters_.wedge_recoveries && place_) {
      hopeless_s_ += seconds;
    }
  }
  if (forward_s_ >= parameters_.stall_s) {
    ++stalls_;
    be_stopped(position);
    restart(position);
  }
}

void WedgeWatch::be_stopped(Point position) noexcept {
  if (!place_) {
    place_ = position;
    return;
  }
  wedged_ =
      wedged_ || (failed_ >= parameters_.wedge_recoveries && hopeless_s_ >= parameters_.stall_s);
  ++failed_;
}

void WedgeWatch::restart(Point position) noexcept {
  from_ = position;
  forward_s_ = 0.0;
}

}  // namespace tcert
