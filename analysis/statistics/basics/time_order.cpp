#include <statistics/basics/time_order.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <statistics/basics/sort_order.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

void check(const SurvivalOutcome& outcome,
           std::span<const std::uint32_t> group,
           std::size_t groups) {
  const std::size_t n = outcome.rows();
  const auto finite = [](double time) { return std::isfinite(time); };
  if (outcome.event.size() != n || (outcome.left_truncated() && outcome.start.size() != n) ||
      (!group.empty() && group.size() != n)) {
    throw std::invalid_argument("survival: columns of different length");
  }
  if (std::any_of(group.begin(), group.end(), [&](std::uint32_t g) { return g >= groups; })) {
    throw std::invalid_argument("survival: a group or stratum is missing or out of range");
  }
  if (!std::all_of(outcome.stop.begin(), outcome.stop.end(), finite) ||
      !std::all_of(outcome.start.begin(), outcome.start.end(), finite)) {
    throw std::invalid_argument("survival: a time is not finite");
  }
  if (std::any_of(outcome.event.begin(), outcome.event.end(), [](auto e) { return e > 1; })) {
    throw std::invalid_argument("survival: an event is neither 0 nor 1");
  }
  for (std::size_t row = 0; row < outcome.start.size(); ++row) {
    if (outcome.start[row] >= outcome.stop[row]) {
      throw std::invalid_argument("survival: a start is not before its stop");
    }
  }
}

std::span<const std::uint32_t> part(const std::vector<std::uint32_t>& rows,
                                    const std::vector<std::size_t>& first,
                                    std::size_t group) {
  return std::span(rows).subspan(first[group], first[group + 1] - first[group]);
}

/// Events before censored among equal stops.
void put_events_first(const SurvivalOutcome& outcome, std::vector<std::uint32_t>& order) {
  for (auto first = order.begin(); first != order.end();) {
    const double stop = outcome.stop[*first];
    auto last = first + 1;
    while (last != order.end() && outcome.stop[*last] == stop) {
      ++last;
    }
    if (last - first > 1) {
      std::stable_partition(
          first, last, [&](std::uint32_t row) { return outcome.event[row] != 0; });
    }
    first = last;
  }
}

}  // namespace

std::span<const std::uint32_t> TimeOrder::stops_of(std::size_t group) const {
  return part(by_stop, first, group);
}

std::span<const std::uint32_t> TimeOrder::starts_of(std::size_t group) const {
  return by_start.empty() ? std::span<const std::uint32_t>{} : part(by_start, first, group);
}

std::vector<std::uint32_t> group_order(std::vector<std::uint32_t> order,
                                       std::span<const std::uint32_t> group,
                                       std::span<const std::size_t> first) {
  if (group.empty() || first.size() <= 2) {
    return order;
  }
  std::vector<std::size_t> next(first.begin(), first.end());
  std::vector<std::uint32_t> sorted(order.size());
  for (const std::uint32_t row : order) {
    sorted[next[group[row]]++] = row;
  }
  return sorted;
}

TimeOrder time_order(const SurvivalOutcome& outcome,
                     std::span<const std::uint32_t> group,
                     std::size_t groups) {
  check(outcome, group, groups);
  TimeOrder result;
  result.first.assign(groups + 1, 0);
  if (group.empty()) {
    result.first.back() = outcome.rows();
  }
  for (const std::uint32_t g : group) {
    ++result.first[g + 1];
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());

  std::vector<std::uint32_t> order = sort_order(outcome.stop);
  put_events_first(outcome, order);
  result.by_stop = group_order(std::move(order), group, result.first);
  if (outcome.left_truncated()) {
    result.by_start = group_order(sort_order(outcome.start), group, result.first);
  }
  return result;
}

}  // namespace tcert::statistics
