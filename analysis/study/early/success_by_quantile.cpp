#include "analysis/study/early/success_by_quantile.hpp"

#include <algorithm>
#include <statistics/basics/binomial_interval.hpp>
#include <statistics/basics/quantile.hpp>
#include <stdexcept>

namespace tcert::study {

std::size_t quantile_groups(std::size_t trials) noexcept {
  constexpr std::size_t kFine = 10;
  constexpr std::size_t kCoarse = 5;
  constexpr std::size_t kFewest = 20;
  return trials >= kFine * kFewest ? kFine : kCoarse;
}

std::vector<QuantileGroup> success_by_quantile(const EarlyTrials& trials, std::size_t groups) {
  if (groups == 0) {
    throw std::invalid_argument("trials cannot be cut into no groups");
  }
  std::vector<double> cuts;
  for (std::size_t k = 1; k < groups; ++k) {
    const double p = static_cast<double>(k) / static_cast<double>(groups);
    if (const auto cut = statistics::quantile(trials.tc_early_m, p)) {
      cuts.push_back(*cut);
    }
  }
  std::vector<QuantileGroup> found(cuts.size() + 1);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const double value = trials.tc_early_m[i];
    const auto at = std::lower_bound(cuts.begin(), cuts.end(), value) - cuts.begin();
    QuantileGroup& group = found[static_cast<std::size_t>(at)];
    group.low_m = group.trials == 0 ? value : std::min(group.low_m, value);
    group.high_m = group.trials == 0 ? value : std::max(group.high_m, value);
    ++group.trials;
    group.successes += trials.success[i];
  }
  std::erase_if(found, [](const QuantileGroup& group) { return group.trials == 0; });
  for (QuantileGroup& group : found) {
    group.share = static_cast<double>(group.successes) / static_cast<double>(group.trials);
    group.interval = *statistics::wilson(group.successes, group.trials);
  }
  return found;
}

}  // namespace tcert::study
