#pragma once
/// \file
/// From hits and misses of a cell to the intensity of obstacles there: the Lambda-Field of Laconte
/// et al. (arXiv 1903.02285; Sensors 2021, 21, 7562).

namespace tcert {

/// How often a cell was found taken and free, and the area e in which a hit's obstacle may lie.
struct CellCounts {
  double hits = 0.0;    ///< h >= 0.
  double misses = 0.0;  ///< m >= 0.
  double error_m2 = 0.0025;
};

/// lambda = ln(1 + h/m) / e, in 1/m^2: 1 - exp(-e lambda) = h/(h + m). Infinite of hits without a
/// miss. \pre h + m > 0.
[[nodiscard]] double lambda_intensity(const CellCounts& counts) noexcept;

struct IntensityRange {
  double low = 0.0;
  double high = 0.0;
};

/// The published 95 % interval, from the normal approximation of how many of the h + m observations
/// were of an obstacle: mu = h p_h + m (1 - p_m), s^2 = h p_h (1 - p_h) + m p_m (1 - p_m),
/// K = mu -+ 1.96 s within [0, h + m], lambda = ln(1 + K/(h + m - K)) / e. It accounts for false
/// readings alone, not for how few there were: at h = 0 it hardly covers. What does cover is an
/// exact interval of h/(h + m) through the same logarithm.
[[nodiscard]] IntensityRange lambda_interval(const CellCounts& counts,
                                             double hit_rate,
                                             double miss_rate) noexcept;

/// Posterior mean a/b of a Gamma prior with mean `prior_per_m2` that is worth `prior_weight`
/// observations: a = prior e w + h, b = e (w + h + m). At most 1/e beyond the prior.
[[nodiscard]] double gamma_intensity(const CellCounts& counts,
                                     double prior_per_m2,
                                     double prior_weight) noexcept;

}  // namespace tcert
