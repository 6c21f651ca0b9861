#include "analysis/study/h1/h1_score.hpp"

#include <cmath>
#include <statistics/clusters/cluster_inference.hpp>
#include <utility>

namespace tcert::study {

void take_score(const statistics::BootstrapResult& result,
                std::size_t value,
                const H1Options& options,
                const std::string& quantity,
                H1Score& score,
                statistics::Conditions& conditions,
                std::optional<std::size_t> units) {
  const statistics::BootstrapEstimate estimate =
      statistics::bootstrap_estimate(result, value, options.level, options.interval, units);
  if (!score.value && !std::isnan(estimate.observed)) {
    score.value = estimate.observed;
  }
  score.intervals = statistics::bootstrap_intervals(result, value, options.level, units);
  score.interval = estimate.interval;
  score.p_value =
      statistics::jackknife_estimate(estimate.observed, result.left_out[value], options.level)
          .p_value;
  for (statistics::Condition condition : estimate.conditions) {
    condition.detail = quantity + (condition.detail.empty() ? "" : ": " + condition.detail);
    conditions.push_back(std::move(condition));
  }
}

}  // namespace tcert::study
