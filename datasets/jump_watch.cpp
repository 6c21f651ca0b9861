#include "datasets/jump_watch.hpp"

#include <algorithm>
#include <utility>

namespace tcert {

JumpWatch::JumpWatch(std::size_t rays, double max_gap_s) : readings_(rays), max_gap_s_(max_gap_s) {
  usable_.reserve(2);
}

void JumpWatch::hold(const TickLine& line) {
  std::ranges::copy(line.tick.rays, readings_.begin());
  held_ = line;
  held_->tick.rays = readings_;
}

JumpWatch::Verdict JumpWatch::take(const TickLine& line) {
  usable_.clear();
  Verdict verdict;
  TickLine next = line;
  const bool confirms = held_ && line.tick.time_ns > held_->tick.time_ns;
  if (confirms) {
    const std::int64_t step_ns = line.tick.time_ns - held_->tick.time_ns;
    next.is_after_gap = static_cast<double>(step_ns) > max_gap_s_ * 1e9;
    next.tick.segment_start =
        next.starts_anyway || next.is_after_gap || (next.is_too_late && !held_->is_too_late);
    usable_.push_back(*held_);
  } else if (held_) {
    verdict.refused_ns = held_->tick.time_ns;
    next.starts_anyway = next.starts_anyway || held_->starts_anyway;  // a producer came back
    next.tick.segment_start = next.tick.segment_start || next.starts_anyway;
  }
  if (!confirms && next.is_after_gap) {
    hold(next);
    verdict.go_back_to_ns = last_ns_;
    return verdict;
  }
  usable_.push_back(next);
  held_.reset();
  last_ns_ = line.tick.time_ns;
  verdict.usable = usable_;
  return verdict;
}

std::optional<TickLine> JumpWatch::last() { return std::exchange(held_, std::nullopt); }

}  // namespace tcert
