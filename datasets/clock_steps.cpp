#include "datasets/clock_steps.hpp"

#include <algorithm>
#include <vector>

namespace tcert {

std::optional<ClockSteps> clock_steps(std::span<const std::int64_t> time_ns) {
  std::vector<std::int64_t> steps;
  std::size_t not_increasing = 0;
  for (std::size_t i = 1; i < time_ns.size(); ++i) {
    if (time_ns[i] > time_ns[i - 1]) {
      steps.push_back(time_ns[i] - time_ns[i - 1]);
    } else {
      ++not_increasing;
    }
  }
  if (steps.empty()) {
    return std::nullopt;
  }
  std::ranges::sort(steps);
  const auto at = [&steps](std::size_t percent) {
    return static_cast<double>(steps[(steps.size() - 1) * percent / 100]) * 1e-9;
  };
  return ClockSteps{at(0), at(5), at(50), at(95), at(100), not_increasing};
}

}  // namespace tcert
