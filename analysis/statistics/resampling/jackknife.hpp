#pragma once
/// \file
/// The jackknife: a statistic with one unit left out, its influence values and the acceleration
/// of BCa intervals.

#include <optional>
#include <span>
#include <statistics/resampling/resampling_plan.hpp>
#include <statistics/resampling/statistic.hpp>
#include <vector>

namespace tcert::statistics {

/// out[value][unit]: the statistic without the unit; NaN where it has no value then. By the
/// statistic's own method, else units times its kernel, on all cores, the same for any number.
/// \throws std::invalid_argument if the rows of both differ.
[[nodiscard]] std::vector<std::vector<double>> leave_one_out(const Statistic& statistic,
                                                             const ResamplingPlan& plan);

/// The same into memory that is there: `out` has a vector of plan.units() for each value.
void leave_one_out(const Statistic& statistic,
                   const ResamplingPlan& plan,
                   std::span<std::vector<double>> out);

/// L_i = (n_s - 1) (t0 - t_(-i)), n_s the units in the stratum of i: `empinf(type = "jack")` of R's
/// boot. Not centred; `centred` subtracts the stratum's mean, as Efron's and scipy's formula does.
[[nodiscard]] std::vector<double> jackknife_influence(const ResamplingPlan& plan,
                                                      double observed,
                                                      std::span<const double> left_out,
                                                      bool centred = false);

/// a = sum L^3 / (6 (sum L^2)^1.5). Empty if an influence is NaN or all are 0.
[[nodiscard]] std::optional<double> acceleration(std::span<const double> influence);

}  // namespace tcert::statistics
