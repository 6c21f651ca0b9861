#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <terrain/limits.hpp>
#include <terrain/lipschitz.hpp>
#include <terrain/settle.hpp>

namespace tcert::terrain {
namespace {

[[nodiscard]] double bounded_lipschitz(const ExploreSetup& setup,
                                       const Grid& grid,
                                       std::span<const Measurement> first) {
  const double bound = std::max(first_scale(setup, first).lipschitz_bound(grid),
                                steepest_measured(first, setup.rules.noise_bound));
  if (!std::isfinite(bound) || !(bound > 0.0)) {
    throw std::invalid_argument("the Lipschitz constant cannot be bounded from " +
                                std::to_string(first.size()) +
                                " measurements: give it, or measure more round the start");
  }
  if (const double least = limit_of("lipschitz").low; bound < least) {
    std::array<char, 160> text{};
    std::snprintf(text.data(),
                  text.size(),
                  "the slopes of the terrain are too small to reckon with: %.3g per cell, at least "
                  "%g is needed; multiply its values",
                  bound,
                  least);
    throw std::invalid_argument(text.data());
  }
  return bound;
}

}  // namespace

FieldScale first_scale(const ExploreSetup& setup, std::span<const Measurement> first) {
  FieldScale scale({setup.prior.length_scale, setup.noise_sd, setup.confidence, setup.gradient});
  for (const Measurement& m : first) {
    scale.add(m);
  }
  (void)scale.renew();
  return scale;
}

double gaussian_noise_bound(double sd, double confidence, std::size_t measurements) {
  const double tail =
      (1.0 - confidence) / static_cast<double>(std::max<std::size_t>(measurements, 1));
  double low = 0.0;
  double high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::sqrt(2.0)) > tail ? low : high) = middle;
  }
  return sd * high;
}

void settle_noise(ExploreSetup& setup, std::size_t first) {
  if (setup.rules.kind != RuleSet::certified || !(setup.noise_sd > 0.0) ||
      setup.rules.noise_bound > 0.0) {
    return;
  }
  if (!(setup.confidence > 0.0)) {
    throw std::invalid_argument(
        "noise-sd: without a noise bound, or a confidence to derive it at, nothing allows for the "
        "noise");
  }
  setup.rules.noise_bound =
      gaussian_noise_bound(setup.noise_sd,
                           setup.confidence,
                           static_cast<std::size_t>(std::max(setup.max_steps, 0)) + first);
}

void settle(ExploreSetup& setup,
            const Grid& grid,
            std::span<const Measurement> first,
            const Told& told) {
  if (setup.rules.kind == RuleSet::band) {
    if (first_scale(setup, first).variance_bound() == kUnbounded) {
      throw std::invalid_argument("the variance of the terrain cannot be bounded from " +
                                  std::to_string(first.size()) +
                                  " measurements that are too few, equal, or within their noise: "
                                  "measure more round the start, or tell of earlier ground");
    }
    setup.prior = {
        first.empty() ? 0.0 : first.back().value, 1.0, setup.prior.length_scale, kBandNugget, true};
    return;
  }
  if (setup.rules.kind != RuleSet::certified) {
    return;
  }
  settle_noise(setup, first.size());
  const bool is_contradicted =
      setup.confidence > 0.0 && steepest_measured(first, setup.rules.noise_bound) >
                                    setup.rules.lipschitz * (1.0 + kSlopeSlack);
  const bool is_told = told.lipschitz && !is_contradicted;
  if (is_told) {
    setup.confidence = 0.0;
  } else {
    setup.rules.lipschitz = bounded_lipschitz(setup, grid, first);
  }
  // The prior's scale is that of the data: a field whose steepest gradient is the constant.
  if (!told.variance) {
    setup.prior.variance = variance_of(grid, setup.rules.lipschitz, setup.prior.length_scale);
    setup.prior_follows_lipschitz = !is_told;
  }
  if (!told.mean && !first.empty()) {
    setup.prior.mean = first.back().value;
  }
}

}  // namespace tcert::terrain
