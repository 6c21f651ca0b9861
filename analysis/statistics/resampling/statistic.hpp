#pragma once
/// \file
/// A statistic of a table whose rows have whole-number weights: what the bootstrap and the
/// jackknife work on.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <statistics/resampling/resampling_plan.hpp>
#include <vector>

namespace tcert::statistics {

/// Computes the values of a statistic when row i stands `multiplicity[i]` times; NaN where there is
/// none. It owns its scratch memory and is called from one thread.
using StatisticKernel =
    std::function<void(std::span<const std::uint32_t> multiplicity, std::span<double> values)>;

/// One or more numbers of the same rows: replicates of all of them come from the same resamples.
struct Statistic {
  std::size_t rows = 0;
  std::size_t values = 1;
  std::function<StatisticKernel()> make_kernel;  ///< One for each thread.

  /// Optional and faster than the kernel: fills out[value][unit] with the values when that unit is
  /// left out. `out` has its sizes.
  std::function<void(const ResamplingPlan& plan, std::span<std::vector<double>> out)> leave_one_out;
};

/// A statistic of one number from a maker of `double(std::span<const std::uint32_t>)`.
template <typename MakeKernel>
[[nodiscard]] Statistic scalar_statistic(std::size_t rows, MakeKernel make_kernel) {
  Statistic statistic;
  statistic.rows = rows;
  statistic.make_kernel = [make_kernel]() -> StatisticKernel {
    auto kernel = make_kernel();
    return [kernel](std::span<const std::uint32_t> multiplicity, std::span<double> values) mutable {
      values[0] = kernel(multiplicity);
    };
  };
  return statistic;
}

/// All values of all `parts`, in order. \throws std::invalid_argument if they are of different
/// numbers of rows or there is none.
[[nodiscard]] Statistic joined(std::vector<Statistic> parts);

}  // namespace tcert::statistics
