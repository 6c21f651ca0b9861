#include "analysis/survival/survival_outcome.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tcert {
namespace {

void snap(std::vector<double>& times, const std::vector<double>& cuts) {
  for (double& time : times) {
    time = *(std::upper_bound(cuts.begin(), cuts.end(), time) - 1);
  }
}

}  // namespace

void snap_times(SurvivalOutcome& outcome) {
  std::vector<double> distinct = outcome.stop;
  distinct.insert(distinct.end(), outcome.start.begin(), outcome.start.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2) {
    return;
  }
  const double mean =
      std::accumulate(distinct.begin(),
                      distinct.end(),
                      0.0,
                      [](double sum, double time) { return sum + std::abs(time); }) /
      static_cast<double>(distinct.size());
  const double tolerance = std::sqrt(std::numeric_limits<double>::epsilon());

  // R compares neighbours, so a chain of near times becomes its first.
  std::vector<double> cuts{distinct.front()};
  for (std::size_t i = 1; i < distinct.size(); ++i) {
    const double step = distinct[i] - distinct[i - 1];
    if (step > tolerance && step / mean > tolerance) {
      cuts.push_back(distinct[i]);
    }
  }
  if (cuts.size() == distinct.size()) {
    return;
  }
  snap(outcome.stop, cuts);
  snap(outcome.start, cuts);
}

}  // namespace tcert
