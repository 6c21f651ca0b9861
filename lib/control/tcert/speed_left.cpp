#include <algorithm>
#include <tcert/speed_left.hpp>
#include <tcert/tick.hpp>

namespace tcert {

void SpeedLeft::command(double speed_mps, double hold_s, std::int64_t time_ns) noexcept {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    if (elapsed_s(entries_[i].left_ns, time_ns) <= entries_[i].hold_s) {
      entries_[kept++] = entries_[i];
    }
  }
  if (count_ > 0) {
    entries_[kept] = entries_[count_ - 1];
    entries_[kept++].left_ns = time_ns;
  }
  while (kept > 0 && entries_[kept - 1].speed_mps <= speed_mps) {
    --kept;
  }
  if (kept == kMost) {
    Entry& last = entries_[kMost - 1];
    last.hold_s = std::max(last.hold_s, hold_s);
    last.left_ns = time_ns;
  } else {
    entries_[kept++] = {speed_mps, hold_s, time_ns};
  }
  count_ = kept;
}

double SpeedLeft::at(std::int64_t time_ns) const noexcept {
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    if (elapsed_s(entries_[i].left_ns, time_ns) <= entries_[i].hold_s) {
      return entries_[i].speed_mps;  // they fall, so that the first that counts is the largest
    }
  }
  return count_ > 0 ? entries_[count_ - 1].speed_mps : 0.0;
}

}  // namespace tcert
