#pragma once
// How often the bound of a calibration of rays covers all of a new day, over simulated
// calibrations.

#include <cstddef>
#include <cstdint>
#include <string>
#include <table/row_text.hpp>
#include <vector>

#include "datasets/ray_pairs.hpp"

namespace tcert::study::coverage {

/// Days of two tentacles whose true curve is that of the synthetic corpus. A day has a bias of 4 mm
/// that both share, 20 to 60 ticks and noise of 6 mm on each. A glitch is a bend drawn from the
/// whole range; ticks have none, for they are medians of three samples.
struct RayScenario {
  std::string name;
  std::size_t days = 22;
  double alpha = 0.05;
  double glitches = 0.0;  ///< Of a tick.
};

/// The days `first` to `first` + `count` of a robot without glitches; each day is the same
/// whichever are asked for. Named by their number.
[[nodiscard]] RayPairs simulate_ray_days(std::size_t first,
                                         std::size_t count,
                                         std::uint64_t seed,
                                         std::uint32_t stream);

/// How one calibration fares on new days.
struct RayCalibrated {
  double quantile_m = 0.0;
  std::uint64_t covered_days = 0;
};

void row_cells(auto& row, table::Is<RayCalibrated> auto& one) {
  row(one.quantile_m, one.covered_days);
}

/// Calibration number `index`: calibrate_rays() of its own days, asked of `new_days` others.
/// `stream` must differ between scenarios.
[[nodiscard]] RayCalibrated calibrate_one(const RayScenario& scenario,
                                          std::uint32_t stream,
                                          std::size_t new_days,
                                          std::uint64_t seed,
                                          std::uint64_t index);

struct RayCoverage {
  std::string scenario;
  std::size_t days = 0;
  double alpha = 0.0;
  std::size_t bound_days = 0;
  std::size_t rank = 0;
  std::size_t calibrations = 0;
  std::size_t new_days = 0;  ///< Of each calibration.
  double promised = 0.0;     ///< 1 - alpha.
  double expected = 0.0;     ///< rank / (n + 1).
  double covered = 0.0;      ///< Share of all new days whose ticks and rays the bound holds at.
  double monte_carlo_se = 0.0;
  double low = 0.0;           ///< 5 % quantile of the coverage of a calibration.
  double expected_low = 0.0;  ///< The same of Beta(rank, n + 1 - rank).
  double mean_quantile_m = 0.0;
  /// Largest distance of the distribution of covered days to the beta-binomial law, which is exact,
  /// times the root of the calibrations: 1.63 is passed in 1 of 100 studies (Kolmogorov).
  double distance = 0.0;
};

/// 22 days at 0.05 (19 of them bound), with and without one glitch in 200 ticks; 60 at 0.1 (30),
/// 100 at 0.05 (50).
[[nodiscard]] std::vector<RayScenario> ray_scenarios();

/// What the calibrations of a scenario come to.
[[nodiscard]] RayCoverage summarise(const RayScenario& scenario,
                                    std::size_t new_days,
                                    const std::vector<RayCalibrated>& calibrations);

}  // namespace tcert::study::coverage
