#include "datasets/clock_steps.hpp"

#include <algorithm>
#include <table/decimal.hpp>

namespace tcert {
namespace {

constexpr std::int64_t kLatestNs = table::kLongestTimeS * 1'000'000'000;

struct Extremes {
  std::int64_t least = INT64_MAX;
  std::int64_t most = INT64_MIN;

  void add(std::int64_t value) noexcept {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  [[nodiscard]] bool lie_within(std::int64_t width) const noexcept { return least >= most - width; }
};

/// Latest time of the stretch after step `k`.
std::int64_t last_after(const ClockFaults& faults, std::size_t k) noexcept {
  return k + 1 < faults.steps.size() ? faults.steps[k + 1].last_ns : faults.last_ns;
}

/// What the rows after step `k` are later than they say; none if the streams disagree.
std::optional<std::int64_t> ahead_ns(std::span<const StreamSteps> streams,
                                     std::size_t k,
                                     std::int64_t max_gap_ns) {
  Extremes last;
  Extremes back;
  Extremes wrap;
  std::int64_t ahead = 0;
  for (const StreamSteps& stream : streams) {
    const ClockStep& step = stream.faults->steps[k];
    if (step.back_ns() > kLatestNs) {
      return std::nullopt;
    }
    last.add(step.last_ns);
    back.add(step.back_ns());
    wrap.add(step.wrap_ns);
    ahead = std::max(
        ahead, step.back_ns() + std::clamp<std::int64_t>(stream.median_step_ns, 1, kLatestNs));
  }
  if (!last.lie_within(max_gap_ns) || !back.lie_within(max_gap_ns) || wrap.least != wrap.most) {
    return std::nullopt;
  }
  return wrap.most > 0 ? wrap.most : ahead;
}

}  // namespace

std::optional<std::vector<std::int64_t>> shifts_after_steps(std::span<const StreamSteps> streams,
                                                            std::int64_t max_gap_ns) {
  const std::size_t steps = streams.front().faults->steps.size();
  const bool alike = std::ranges::all_of(streams, [steps](const StreamSteps& stream) {
    return stream.faults->steps.size() == steps && !stream.faults->is_without_order;
  });
  if (!alike) {
    return std::nullopt;
  }
  std::vector<std::int64_t> shifts;
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < steps; ++k) {
    const auto ahead = ahead_ns(streams, k, max_gap_ns);
    if (!ahead || *ahead > kLatestNs - sum) {
      return std::nullopt;
    }
    sum += *ahead;
    const bool in_range = std::ranges::all_of(streams, [&](const StreamSteps& stream) {
      return last_after(*stream.faults, k) <= kLatestNs - sum;
    });
    if (!in_range) {
      return std::nullopt;
    }
    shifts.push_back(sum);
  }
  return shifts;
}

}  // namespace tcert
