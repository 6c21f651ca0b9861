#include "analysis/study/coverage/ray_study.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/calibration/conformal.hpp>
#include <table/random.hpp>

#include "analysis/study/rays/ray_calibration.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert::study::coverage {
namespace {

constexpr double kDayBiasMetres = 0.004;
constexpr double kTickNoiseMetres = 0.006;
constexpr std::uint32_t kLeastTicks = 20;
constexpr std::uint32_t kMoreTicks = 41;
constexpr std::size_t kFeelers = 2;

/// Appends what both rays feel on one day.
void append_day(table::RandomStream random,
                std::uint32_t day,
                double glitches,
                std::vector<RayPair>& pairs) {
  const Ray& ray = corpus_robot().rays.front();
  const double most_bend = ray.calibration.bend_rad.back();
  const double bias = kDayBiasMetres * random.normal();
  const std::uint32_t ticks = kLeastTicks + random.below(kMoreTicks);
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    for (std::uint32_t feeler = 0; feeler < kFeelers; ++feeler) {
      const double clearance = random.uniform(0.0, ray.reach_m);
      const double felt =
          std::clamp(clearance + bias + kTickNoiseMetres * random.normal(), 0.0, ray.reach_m);
      const bool glitch = random.uniform() < glitches;
      const double drawn = random.uniform(0.0, most_bend);
      pairs.push_back(
          {feeler, day, glitch ? drawn : calibrated_bend(ray.calibration, felt), clearance});
    }
  }
}

std::uint64_t day_index(std::size_t calibration, std::size_t day) {
  return (static_cast<std::uint64_t>(calibration) << 20U) + day;
}

RayPairs days_of(std::size_t calibration,
                 std::size_t first,
                 std::size_t count,
                 double glitches,
                 std::uint64_t seed,
                 std::uint32_t stream) {
  RayPairs made;
  made.rays = {"left", "right"};
  for (std::size_t day = 0; day < count; ++day) {
    made.days.push_back(std::to_string(first + day));
    append_day(table::RandomStream(seed, stream, day_index(calibration, first + day)),
               static_cast<std::uint32_t>(day),
               glitches,
               made.pairs);
  }
  made.runs = count;
  return made;
}

/// How many days the bound holds on, at each of their ticks and rays.
std::size_t covered_days(const RayPairs& pairs, const std::vector<Calibration>& bounds) {
  std::vector<char> holds(pairs.days.size(), 1);
  for (const RayPair& pair : pairs.pairs) {
    if (calibrated_clearance(bounds[pair.ray], pair.bend_rad) > pair.clearance_m) {
      holds[pair.day] = 0;
    }
  }
  return static_cast<std::size_t>(std::ranges::count(holds, 1));
}

/// Pr(count <= j) of a beta-binomial law, for all j.
std::vector<double> beta_binomial(std::size_t trials, double a, double b) {
  const auto log_beta = [](double p, double q) {
    return std::lgamma(p) + std::lgamma(q) - std::lgamma(p + q);
  };
  const auto n = static_cast<double>(trials);
  std::vector<double> below;
  double sum = 0.0;
  for (std::size_t j = 0; j <= trials; ++j) {
    const auto k = static_cast<double>(j);
    const double log_choose =
        std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
    sum += std::exp(log_choose + log_beta(k + a, n - k + b) - log_beta(a, b));
    below.push_back(sum);
  }
  return below;
}

double distance_to_law(const std::vector<std::size_t>& covered, const RayCoverage& row) {
  const auto a = static_cast<double>(row.rank);
  const auto b = static_cast<double>(row.bound_days + 1 - row.rank);
  const std::vector<double> law = beta_binomial(row.new_days, a, b);
  std::vector<double> counts(row.new_days + 1, 0.0);
  for (const std::size_t count : covered) {
    counts[count] += 1.0;
  }
  const auto n = static_cast<double>(covered.size());
  double sum = 0.0;
  double most = 0.0;
  for (std::size_t j = 0; j < counts.size(); ++j) {
    sum += counts[j];
    most = std::max(most, std::abs(sum / n - law[j]));
  }
  return std::sqrt(n) * most;
}

}  // namespace

RayPairs simulate_ray_days(std::size_t first,
                           std::size_t count,
                           std::uint64_t seed,
                           std::uint32_t stream) {
  return days_of(0, first, count, 0.0, seed, stream);
}

std::vector<RayScenario> ray_scenarios() {
  return {{"22 days, 0.05", 22, 0.05, 0.0},
          {"the same, glitches", 22, 0.05, 0.005},
          {"60 days, 0.1", 60, 0.1, 0.0},
          {"100 days, 0.05", 100, 0.05, 0.0}};
}

RayCalibrated calibrate_one(const RayScenario& scenario,
                            std::uint32_t stream,
                            std::size_t new_days,
                            std::uint64_t seed,
                            std::uint64_t index) {
  RayCalibrationOptions options;
  options.alpha = scenario.alpha;
  options.seed = index + 1;
  const RayCalibrationResult made =
      calibrate_rays(days_of(index, 0, scenario.days, scenario.glitches, seed, stream), options);
  return {made.calibration->bound->quantile_m,
          covered_days(days_of(index, scenario.days, new_days, scenario.glitches, seed, stream),
                       made.calibration->usable)};
}

RayCoverage summarise(const RayScenario& scenario,
                      std::size_t new_days,
                      const std::vector<RayCalibrated>& calibrations) {
  RayCoverage row;
  row.scenario = scenario.name;
  row.days = scenario.days;
  row.alpha = scenario.alpha;
  row.promised = 1.0 - scenario.alpha;
  row.bound_days = days_of_bound(scenario.days, scenario.alpha);
  row.rank = statistics::conformal_rank(row.bound_days, scenario.alpha).value();
  row.calibrations = calibrations.size();
  row.new_days = new_days;
  row.expected = static_cast<double>(row.rank) / static_cast<double>(row.bound_days + 1);
  row.expected_low = statistics::conformal_coverage_quantile(row.bound_days, row.rank, 0.05);
  const auto n = static_cast<double>(calibrations.size());
  std::vector<std::size_t> covered;
  double sum = 0.0;
  double squares = 0.0;
  for (const RayCalibrated& one : calibrations) {
    const double share = static_cast<double>(one.covered_days) / static_cast<double>(new_days);
    sum += share;
    squares += share * share;
    row.mean_quantile_m += one.quantile_m / n;
    covered.push_back(one.covered_days);
  }
  row.covered = sum / n;
  row.monte_carlo_se = std::sqrt(std::max(0.0, squares / n - row.covered * row.covered) / n);
  row.distance = distance_to_law(covered, row);
  std::ranges::sort(covered);
  row.low = static_cast<double>(covered[covered.size() / 20]) / static_cast<double>(new_days);
  return row;
}

}  // namespace tcert::study::coverage
