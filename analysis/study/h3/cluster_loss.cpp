#include "analysis/study/h3/cluster_loss.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <map>
#include <statistics/basics/binomial_interval.hpp>
#include <stdexcept>

namespace tcert::study {
namespace {

struct CountOf {
  double ones = 0.0;
  double trials = 0.0;
};

std::map<std::uint32_t, CountOf> counts_by_cluster(std::span<const std::uint8_t> values,
                                                   std::span<const std::uint32_t> cluster) {
  std::map<std::uint32_t, CountOf> counts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    counts[cluster[i]].ones += values[i];
    counts[cluster[i]].trials += 1.0;
  }
  return counts;
}

/// Sum over clusters of n_g^2 / n: how many trials one shares its cluster with, and itself.
double shared_trials(const std::map<std::uint32_t, CountOf>& counts) {
  double squares = 0.0;
  double trials = 0.0;
  for (const auto& [code, count] : counts) {
    squares += count.trials * count.trials;
    trials += count.trials;
  }
  return squares / trials;
}

/// Pr(X <= ones) of trials with this share: also of numbers that are not whole.
double tail_at_most(double ones, double trials, double share) {
  return ones >= trials ? 1.0 : boost::math::ibetac(ones + 1.0, trials - ones, share);
}

/// Most losses with which the bound is still below the margin; -1 for none.
double most_losses(double trials, double margin, double level, double from) {
  double most = from;
  while (most + 1.0 < trials && *statistics::effective_upper(most + 1.0, trials, level) < margin) {
    most += 1.0;
  }
  return most;
}

}  // namespace

double binary_icc(std::span<const std::uint8_t> values, std::span<const std::uint32_t> cluster) {
  const auto counts = counts_by_cluster(values, cluster);
  const auto trials = static_cast<double>(values.size());
  const auto groups = static_cast<double>(counts.size());
  if (groups < 2.0 || trials <= groups) {
    return 0.0;
  }
  double ones = 0.0;
  for (const auto& [code, count] : counts) {
    ones += count.ones;
  }
  double between = 0.0;
  double within = 0.0;
  for (const auto& [code, count] : counts) {
    const double share = count.ones / count.trials;
    between += count.trials * std::pow(share - ones / trials, 2);
    within += count.ones * (1.0 - share);
  }
  between /= groups - 1.0;
  within /= trials - groups;
  const double size = (trials - shared_trials(counts)) / (groups - 1.0);
  const double whole = between + (size - 1.0) * within;
  return whole > 0.0 ? std::clamp((between - within) / whole, 0.0, 1.0) : 0.0;
}

ClusterLoss cluster_loss(std::span<const std::uint8_t> lost,
                         std::span<const std::uint8_t> failed,
                         std::span<const std::uint32_t> cluster,
                         double level,
                         double margin) {
  if (lost.size() != failed.size() || lost.size() != cluster.size()) {
    throw std::invalid_argument("a loss by clusters: lengths differ");
  }
  ClusterLoss loss;
  loss.trials = lost.size();
  loss.lost = static_cast<std::size_t>(std::count(lost.begin(), lost.end(), 1));
  if (lost.empty()) {
    return loss;
  }
  const double alike = std::max(binary_icc(lost, cluster), binary_icc(failed, cluster));
  loss.design_effect = 1.0 + (shared_trials(counts_by_cluster(lost, cluster)) - 1.0) * alike;
  const double trials = loss.effective_trials();
  const double losses = static_cast<double>(loss.lost) / loss.design_effect;
  loss.upper = statistics::effective_upper(losses, trials, level);
  loss.lower = 1.0 - *statistics::effective_upper(trials - losses, trials, level);
  loss.p = tail_at_most(losses, trials, margin);
  return loss;
}

std::optional<double> trials_for_power(double lost, double margin, double level, double power) {
  constexpr double kMostTrials = 1e5;
  if (!(lost >= 0.0 && lost < margin)) {
    return std::nullopt;
  }
  // Each number of losses that still do begins a tooth of the power, which falls until the next:
  // the number sought begins the first tooth whose end has the power.
  double most = -1.0;
  std::optional<double> begin;
  for (double trials = 1.0; trials <= kMostTrials; trials += 1.0) {
    const double now = most_losses(trials, margin, level, most);
    const bool enough = now >= 0.0 && tail_at_most(now, trials, lost) >= power;
    if (!enough) {
      begin.reset();
    } else if (!begin) {
      begin = trials;
    }
    if (begin && now >= most + 1.0 && trials > *begin) {
      return begin;  // A whole tooth had it.
    }
    most = now;
  }
  return std::nullopt;
}

}  // namespace tcert::study
