#include <statistics/resampling/bootstrap_interval.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/student_t.hpp>
#include <stdexcept>
#include <string>
#include <table/not_a_number.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

struct Endpoint {
  double value = 0.0;
  double rank = 0.0;
};

/// Quantile `alpha` of the rising, non-empty `sorted`.
Endpoint endpoint(std::span<const double> sorted, double alpha) {
  const auto count = static_cast<double>(sorted.size());
  const double rank = (count + 1.0) * alpha;
  const double whole = std::trunc(rank);
  if (whole < 1.0) {
    return {sorted.front(), rank};
  }
  if (whole >= count) {
    return {sorted.back(), rank};
  }
  const auto k = static_cast<std::size_t>(whole);
  const double below = sorted[k - 1];
  if (whole == rank) {
    return {below, rank};
  }
  const double z_below = normal_quantile(whole / (count + 1.0));
  const double z_above = normal_quantile((whole + 1.0) / (count + 1.0));
  const double part = (normal_quantile(alpha) - z_below) / (z_above - z_below);
  return {below + part * (sorted[k] - below), rank};
}

void add(Conditions& conditions,
         ConditionKind kind,
         ConditionSeverity severity,
         std::string detail = "") {
  conditions.push_back({kind, severity, "", std::move(detail)});
}

/// Which limits are the extreme replicate; the basic interval exchanges them.
std::string ends_in_words(bool below, bool above, bool exchanged, std::size_t count) {
  const std::string of = " of " + std::to_string(count) + " replicates";
  std::string text;
  if (below) {
    text = std::string("the ") + (exchanged ? "upper" : "lower") +
           " limit lies beyond the smallest" + of;
  }
  if (above) {
    text += std::string(below ? ", the " : "the ") + (exchanged ? "lower" : "upper") +
            " limit beyond the largest" + of;
  }
  return text;
}

/// Conditions of the replicates; true if an interval can be made of them.
bool usable(const BootstrapDistribution& distribution, Conditions& conditions) {
  const std::size_t finite = distribution.sorted.size();
  if (std::isnan(distribution.observed)) {
    add(conditions,
        ConditionKind::failed_replicates,
        ConditionSeverity::error,
        "the data themselves give no value");
    return false;
  }
  if (distribution.failed > 0) {
    add(conditions,
        ConditionKind::failed_replicates,
        finite == 0 ? ConditionSeverity::warning : ConditionSeverity::note,
        std::to_string(distribution.failed) + " of " +
            std::to_string(distribution.failed + finite));
  }
  if (finite == 0) {
    return false;
  }
  if (distribution.sorted.front() == distribution.sorted.back()) {
    add(conditions, ConditionKind::constant_replicates, ConditionSeverity::warning);
    return false;
  }
  return true;
}

/// The two levels of the BCa interval; conditions say why there are none.
std::optional<std::pair<double, double>> bca_levels(const BootstrapDistribution& distribution,
                                                    std::optional<double> acceleration,
                                                    double level,
                                                    Conditions& conditions) {
  const double w = normal_quantile(static_cast<double>(distribution.below) /
                                   static_cast<double>(distribution.sorted.size()));
  if (!std::isfinite(w)) {
    add(conditions, ConditionKind::infinite_bias, ConditionSeverity::warning);
    return std::nullopt;
  }
  if (!acceleration) {
    add(conditions, ConditionKind::no_acceleration, ConditionSeverity::warning);
    return std::nullopt;
  }
  const auto adjusted = [&](double alpha) {
    const double z = w + normal_quantile(alpha);
    const double scale = 1.0 - *acceleration * z;
    return scale > 0.0 ? normal_cdf(w + z / scale) : table::kNaN;
  };
  const double low = adjusted((1.0 - level) / 2.0);
  const double high = adjusted((1.0 + level) / 2.0);
  if (std::isnan(low) || std::isnan(high)) {
    add(conditions,
        ConditionKind::no_acceleration,
        ConditionSeverity::warning,
        "it is too large for this level");
    return std::nullopt;
  }
  return std::pair(low, high);
}

}  // namespace

BootstrapDistribution bootstrap_distribution(std::span<const double> replicates, double observed) {
  BootstrapDistribution result;
  result.observed = observed;
  result.sorted.reserve(replicates.size());
  for (const double t : replicates) {
    if (std::isfinite(t)) {
      result.sorted.push_back(t);
      result.below += t < observed ? 1 : 0;
      result.equal += t == observed ? 1 : 0;
    }
  }
  result.failed = replicates.size() - result.sorted.size();
  const auto count = static_cast<double>(result.sorted.size());
  result.mean = std::accumulate(result.sorted.begin(), result.sorted.end(), 0.0) / count;
  double squares = 0.0;
  for (const double t : result.sorted) {
    squares += (t - result.mean) * (t - result.mean);
  }
  result.standard_deviation = std::sqrt(squares / (count - 1.0));
  std::sort(result.sorted.begin(), result.sorted.end());
  return result;
}

BootstrapInterval bootstrap_interval(const BootstrapDistribution& distribution,
                                     BootstrapMethod method,
                                     std::optional<double> acceleration,
                                     double level,
                                     std::size_t units) {
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("bootstrap: level must be in (0, 1)");
  }
  BootstrapInterval result;
  result.low_rank = result.high_rank = table::kNaN;
  if (!usable(distribution, result.conditions)) {
    return result;
  }
  const double t0 = distribution.observed;
  if (method == BootstrapMethod::normal) {
    const double centre = t0 - (distribution.mean - t0);
    const double half = normal_factor(level) * distribution.standard_deviation;
    result.interval = Interval{centre - half, centre + half, level};
    return result;
  }
  std::pair<double, double> levels{(1.0 - level) / 2.0, (1.0 + level) / 2.0};
  if (method == BootstrapMethod::bca) {
    const auto adjusted = bca_levels(distribution, acceleration, level, result.conditions);
    if (!adjusted) {
      return result;
    }
    levels = *adjusted;
  } else if (method == BootstrapMethod::expanded) {
    if (units < 2) {
      throw std::invalid_argument("bootstrap: expanded percentiles need two units");
    }
    const double tail = expanded_tail(level, units);
    levels = {tail, 1.0 - tail};
  }
  const Endpoint low = endpoint(distribution.sorted, levels.first);
  const Endpoint high = endpoint(distribution.sorted, levels.second);
  result.low_rank = low.rank;
  result.high_rank = high.rank;
  const auto count = static_cast<double>(distribution.sorted.size());
  if (std::min(low.rank, high.rank) < 1.0 || std::max(low.rank, high.rank) > count) {
    add(result.conditions,
        ConditionKind::endpoint_out_of_range,
        ConditionSeverity::note,
        ends_in_words(low.rank < 1.0 || high.rank<1.0, low.rank> count || high.rank > count,
                      method == BootstrapMethod::basic,
                      distribution.sorted.size()));
  }
  result.interval = method == BootstrapMethod::basic
                        ? Interval{2.0 * t0 - high.value, 2.0 * t0 - low.value, level}
                        : Interval{low.value, high.value, level};
  return result;
}

double expanded_tail(double level, std::size_t units) {
  const auto count = static_cast<double>(units);
  return normal_cdf(-std::sqrt(count / (count - 1.0)) * t_factor(level, count - 1.0));
}

std::string_view to_string(BootstrapMethod method) noexcept {
  switch (method) {
    case BootstrapMethod::normal:
      return "normal";
    case BootstrapMethod::basic:
      return "basic";
    case BootstrapMethod::percentile:
      return "percentile";
    case BootstrapMethod::expanded:
      return "expanded";
    case BootstrapMethod::bca:
      return "BCa";
  }
  return "";
}

}  // namespace tcert::statistics
