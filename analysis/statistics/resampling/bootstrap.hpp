#pragma once
/// \file
/// The nonparametric bootstrap of rows or of whole clusters.
/// Checked against R's `boot::boot` and `boot.ci`.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <statistics/resampling/bootstrap_interval.hpp>
#include <statistics/resampling/resampling_plan.hpp>
#include <statistics/resampling/statistic.hpp>
#include <vector>

namespace tcert::statistics {

struct BootstrapOptions {
  std::size_t replicates = 9999;  ///< Up to 10^6 or so: they are kept, 8 bytes each and value.
  std::uint64_t seed = 1;
  std::uint32_t analysis = 0;  ///< Which stream of the seed: analyses must not share draws.
  /// Called after each replicate, by whichever thread made it, several at a time; it may not throw.
  std::function<void()> advance{};
};

/// Values of a statistic on the data, on every resample and without every unit. Index 0 is the
/// statistic's first value.
struct BootstrapResult {
  std::size_t units = 0;  ///< Rows or clusters of a replicate.
  std::vector<double> observed;
  std::vector<std::vector<double>> replicates;      ///< [value][replicate]; NaN where it failed.
  std::vector<std::vector<double>> left_out;        ///< [value][unit].
  std::vector<std::optional<double>> acceleration;  ///< From the jackknife, not centred.
};

/// Replicate r is the statistic on draw (seed, analysis, r) of `plan`, so results are the same
/// bytes for any number of threads, and those of fewer replicates are the beginning of those of
/// more. All values come from the same resamples: a difference of two of them is paired.
/// \throws std::invalid_argument if the rows differ or there are no replicates.
[[nodiscard]] BootstrapResult bootstrap(const Statistic& statistic,
                                        const ResamplingPlan& plan,
                                        const BootstrapOptions& options = {});

/// What a table prints of one value.
struct BootstrapEstimate {
  double observed = 0.0;  ///< NaN if the data give none.
  double bias = 0.0;      ///< Mean of the replicates minus observed.
  double standard_error = 0.0;
  std::optional<Interval> interval;
  Conditions conditions;
};

/// Value number `value` with its interval. `units` is of how many drawn units the value is made,
/// where that is not all of them: the clusters of one group; expanded percentiles make up for so
/// many. Of fewer than two they have no interval. \throws std::invalid_argument if there is no such
/// value or `level` is not in (0, 1).
[[nodiscard]] BootstrapEstimate bootstrap_estimate(const BootstrapResult& result,
                                                   std::size_t value,
                                                   double level = 0.95,
                                                   BootstrapMethod method = BootstrapMethod::bca,
                                                   std::optional<std::size_t> units = {});

/// The intervals that a hypothesis keeps of a value: one to be read, all to be compared.
struct BootstrapIntervals {
  std::optional<Interval> expanded;
  std::optional<Interval> percentile;
  std::optional<Interval> bca;
  std::optional<Condition> no_bca;  ///< Why, where the others have an interval and BCa has none.

  /// \throws std::invalid_argument for another method.
  [[nodiscard]] const std::optional<Interval>& of(BootstrapMethod method) const;
};

/// All of value number `value`, with `units` and \throws as `bootstrap_estimate`.
[[nodiscard]] BootstrapIntervals bootstrap_intervals(const BootstrapResult& result,
                                                     std::size_t value,
                                                     double level = 0.95,
                                                     std::optional<std::size_t> units = {});

}  // namespace tcert::statistics
