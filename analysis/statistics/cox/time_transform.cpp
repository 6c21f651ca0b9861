#include <statistics/cox/time_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tcert::statistics {
namespace {

std::vector<std::size_t> order_of(const std::vector<double>& times) {
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return times[a] < times[b];
  });
  return order;
}

/// Tied values share the mean of their ranks, counted from 1.
std::vector<double> mean_ranks(const std::vector<double>& times) {
  const std::vector<std::size_t> order = order_of(times);
  std::vector<double> ranks(times.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && times[order[end]] == times[order[begin]]) {
      ++end;
    }
    for (std::size_t k = begin; k < end; ++k) {
      ranks[order[k]] = 0.5 * static_cast<double>(begin + 1 + end);
    }
    begin = end;
  }
  return ranks;
}

/// 1 - S(t-) with the product-limit estimate over all rows, unweighted.
std::vector<double> failed_before(const SurvivalOutcome& outcome) {
  const std::size_t n = outcome.rows();
  const std::vector<std::size_t> order = order_of(outcome.stop);
  std::vector<double> starts = outcome.start;
  std::sort(starts.begin(), starts.end());
  std::vector<double> failed(n);
  double survival = 1.0;
  for (std::size_t begin = 0; begin < n;) {
    const double time = outcome.stop[order[begin]];
    std::size_t end = begin;
    std::size_t events = 0;
    while (end < n && outcome.stop[order[end]] == time) {
      failed[order[end]] = 1.0 - survival;
      events += outcome.event[order[end]];
      ++end;
    }
    // Who has not yet started is not at risk.
    const auto waiting = static_cast<std::size_t>(
        starts.end() - std::lower_bound(starts.begin(), starts.end(), time));
    const auto at_risk = static_cast<double>(n - begin - waiting);
    survival *= 1.0 - static_cast<double>(events) / at_risk;
    begin = end;
  }
  return failed;
}

}  // namespace

std::vector<double> transformed_times(const SurvivalOutcome& outcome, TimeTransform transform) {
  std::vector<double> times = outcome.stop;
  switch (transform) {
    case TimeTransform::km:
      times = failed_before(outcome);
      break;
    case TimeTransform::rank:
      times = mean_ranks(outcome.stop);
      break;
    case TimeTransform::identity:
      break;
    case TimeTransform::log:
      std::transform(
          times.begin(), times.end(), times.begin(), [](double time) { return std::log(time); });
      break;
  }
  double sum = 0.0;
  double events = 0.0;
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (outcome.event[row] != 0) {
      sum += times[row];
      events += 1.0;
    }
  }
  for (double& time : times) {
    time -= sum / events;
  }
  return times;
}

}  // namespace tcert::statistics
