#include "datasets/clock_faults.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace tcert {
namespace {

constexpr std::array kWraps{kWrapOfMs, kWrapOfUs};

std::int64_t wrap_of(std::int64_t back_ns, std::int64_t max_gap_ns) noexcept {
  const auto* const found = std::ranges::find_if(kWraps, [=](std::int64_t wrap_ns) {
    return back_ns <= wrap_ns && wrap_ns - back_ns <= max_gap_ns;
  });
  return found != kWraps.end() ? *found : 0;
}

/// A clock is set back now and then. Times that step back at every tenth row, or between whose
/// steps most rows are late, are those of a file that is not in the order of time.
bool has_no_order(const ClockFaults& faults, std::size_t rows) noexcept {
  return !faults.steps.empty() && (10 * faults.steps.size() > rows || 2 * faults.late_rows > rows);
}

}  // namespace

ClockFaults find_clock_faults(std::span<const std::int64_t> time_ns, std::int64_t max_gap_ns) {
  ClockFaults faults;
  faults.any = std::ranges::adjacent_find(time_ns, std::greater_equal<>{}) != time_ns.end();
  if (!faults.any) {
    return faults;
  }
  std::int64_t latest = time_ns.front();
  for (std::size_t row = 1; row < time_ns.size(); ++row) {
    const std::int64_t back = latest - time_ns[row];
    if (back >= max_gap_ns) {
      faults.steps.push_back({row, latest, time_ns[row], wrap_of(back, max_gap_ns)});
      latest = time_ns[row];
      continue;
    }
    if (back > 0) {
      faults.first_late = faults.late_rows == 0 ? row : faults.first_late;
      ++faults.late_rows;
      faults.latest_ns = std::max(faults.latest_ns, back);
    }
    latest = std::max(latest, time_ns[row]);
  }
  faults.last_ns = latest;
  faults.is_without_order = has_no_order(faults, time_ns.size());
  return faults;
}

std::int64_t median_step_ns(std::span<const std::int64_t> time_ns) {
  std::vector<std::int64_t> steps;
  for (std::size_t row = 1; row < time_ns.size(); ++row) {
    if (time_ns[row] > time_ns[row - 1]) {
      steps.push_back(time_ns[row] - time_ns[row - 1]);
    }
  }
  if (steps.empty()) {
    return 0;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

}  // namespace tcert
