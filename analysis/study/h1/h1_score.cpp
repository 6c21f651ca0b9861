#include "analysis/study/h1/h1_score.hpp"

#include <cmath>
#include <utility>

namespace tcert {

void take_score(const BootstrapResult& result,
                std::size_t value,
                const H1Options& options,
                const std::string& quantity,
                H1Score& score,
                Conditions& conditions,
                std::optional<std::size_t> units) {
  const BootstrapEstimate estimate =
      bootstrap_estimate(result, value, options.level, options.interval, units);
  if (!score.value && !std::isnan(estimate.observed)) {
    score.value = estimate.observed;
  }
  score.intervals = bootstrap_intervals(result, value, options.level, units);
  score.interval = estimate.interval;
  for (Condition condition : estimate.conditions) {
    condition.detail = quantity + (condition.detail.empty() ? "" : ": " + condition.detail);
    conditions.push_back(std::move(condition));
  }
}

}  // namespace tcert
