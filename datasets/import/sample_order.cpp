#include "datasets/import/sample_order.hpp"

#include <algorithm>
#include <utility>

namespace tcert::recording {

SampleOrder::SampleOrder(std::int64_t window_ns, Sink sink)
    : window_ns_(window_ns), sink_(std::move(sink)) {}

void SampleOrder::add(std::int64_t time_ns, std::span<const double> values, std::size_t place) {
  ++use_.rows;
  const bool is_first = use_.rows == use_.unreadable + 1 && waiting_.empty() && use_.used == 0;
  if (!is_first && time_ns < newest_ns_) {
    if (newest_ns_ - time_ns >= window_ns_) {
      if (use_.set_back++ == 0) {
        use_.first_set_back = place;
        use_.set_back_by_ns = newest_ns_ - time_ns;
      }
      return;
    }
    ++use_.moved;
  }
  newest_ns_ = is_first ? time_ns : std::max(newest_ns_, time_ns);
  waiting_.push({{time_ns, {values.begin(), values.end()}}, use_.rows});
  pass_until(newest_ns_ - window_ns_);
}

void SampleOrder::pass_until(std::int64_t time_ns) {
  while (!waiting_.empty() && waiting_.top().sample.time_ns <= time_ns) {
    const Sample& next = waiting_.top().sample;
    if (use_.used > 0 && next.time_ns == use_.last_ns) {
      ++use_.same_time;
    } else {
      sink_(next);
      use_.first_ns = std::min(use_.first_ns, next.time_ns);
      use_.last_ns = next.time_ns;
      ++use_.used;
    }
    waiting_.pop();
  }
}

StreamUse SampleOrder::finish() {
  pass_until(std::numeric_limits<std::int64_t>::max());
  return use_;
}

}  // namespace tcert::recording
