#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/elementary.hpp>
#include <tcert/risk_intensity.hpp>

namespace tcert {
namespace {

constexpr double kNormal95 = 1.96;

/// ln(1 + taken/free) / e.
double through_logarithm(double taken, double free, double error_m2) noexcept {
  if (!(taken > 0.0)) {
    return 0.0;
  }
  return free > 0.0 ? elementary::log(1.0 + taken / free) / error_m2
                    : std::numeric_limits<double>::infinity();
}

}  // namespace

double lambda_intensity(const CellCounts& counts) noexcept {
  return through_logarithm(counts.hits, counts.misses, counts.error_m2);
}

IntensityRange lambda_interval(const CellCounts& counts,
                               double hit_rate,
                               double miss_rate) noexcept {
  const double all = counts.hits + counts.misses;
  const double mean = counts.hits * hit_rate + counts.misses * (1.0 - miss_rate);
  const double variance =
      counts.hits * hit_rate * (1.0 - hit_rate) + counts.misses * miss_rate * (1.0 - miss_rate);
  const double away = kNormal95 * std::sqrt(variance);
  const auto at = [&](double taken) noexcept {
    const double within = std::clamp(taken, 0.0, all);
    return through_logarithm(within, all - within, counts.error_m2);
  };
  return {at(mean - away), at(mean + away)};
}

double gamma_intensity(const CellCounts& counts,
                       double prior_per_m2,
                       double prior_weight) noexcept {
  const double shape = prior_per_m2 * counts.error_m2 * prior_weight + counts.hits;
  return shape / (counts.error_m2 * (prior_weight + counts.hits + counts.misses));
}

}  // namespace tcert
