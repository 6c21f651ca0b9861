#include "analysis/study/trials/motion.hpp"

#include <cstddef>

namespace tcert::study {

std::vector<Motion> trailing_motion(std::span<const TimedPosition> path, std::int64_t window_ns) {
  std::vector<Motion> motion(path.size());
  std::size_t from = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const TimedPosition& now = path[k];
    if (k == 0 || now.after_break) {
      from = k;
      continue;
    }
    motion[k].step_ns = now.time_ns - path[k - 1].time_ns;
    while (from + 1 < k && now.time_ns - path[from + 1].time_ns >= window_ns) {
      ++from;
    }
    const std::int64_t elapsed_ns = now.time_ns - path[from].time_ns;
    if (elapsed_ns >= window_ns) {
      motion[k].speed_mps =
          distance(path[from].position, now.position) / (static_cast<double>(elapsed_ns) * 1e-9);
    }
  }
  return motion;
}

}  // namespace tcert::study
