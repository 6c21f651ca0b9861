#pragma once
/// \file
/// What of a setup the first measurements decide.

#include <span>
#include <terrain/explore.hpp>

namespace tcert::terrain {

/// What is not decided because it was told.
struct Told {
  /// rules.lipschitz, unless `first` contradicts it; else it is bounded at setup.confidence.
  bool lipschitz = false;
  bool variance = false;  ///< prior.variance (`certified`).
  bool mean = false;      ///< prior.mean (`certified`).
};

/// `certified` with a noise_sd and no noise bound: the bound that all measurements of a run keep at
/// setup.confidence, `first` of them and max_steps. \throws std::invalid_argument without a
/// confidence: nothing would allow for the noise.
void settle_noise(ExploreSetup& setup, std::size_t first);

/// `certified`: settle_noise(); the Lipschitz constant if it was not told, or is contradicted by
/// `first` and there is a confidence, which is 0 afterwards if nothing is to be bounded; the
/// prior's variance from it, its mean from the last measurement, that of the start. `band`: a field
/// of unit variance with an unknown mean, the length scale as it is. Nothing under other rules.
/// \throws std::invalid_argument if `first` bounds no Lipschitz constant, or one below its Limit,
/// or (`band`) no variance: too few, or all equal.
void settle(ExploreSetup& setup,
            const Grid& grid,
            std::span<const Measurement> first,
            const Told& told);

/// The bound that FieldScale has of `first`, as the exploration begins with it.
[[nodiscard]] FieldScale first_scale(const ExploreSetup& setup, std::span<const Measurement> first);

/// What no error of so many measurements exceeds, each being Gaussian, at `confidence` for all.
[[nodiscard]] double gaussian_noise_bound(double sd, double confidence, std::size_t measurements);

}  // namespace tcert::terrain
