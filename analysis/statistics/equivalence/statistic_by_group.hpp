#pragma once
/// \file
/// A statistic of each group of rows by itself, and how far apart they lie.

#include <optional>
#include <span>
#include <statistics/equivalence/equivalence.hpp>
#include <statistics/equivalence/range_permutation.hpp>
#include <statistics/resampling/statistic.hpp>
#include <table/factor.hpp>

namespace tcert::statistics {

/// All values of `whole` on the rows of the first group, then of the second, ...: value v of group
/// g is number g * whole.values + v. \throws std::invalid_argument if the rows differ.
[[nodiscard]] Statistic by_group(const Statistic& whole, const table::Factor& group);

/// Makes kernels of the largest less the smallest of value `value` of `whole` over `groups` groups
/// of rows; NaN if a group has none.
[[nodiscard]] std::function<RangeKernel()> range_of(const Statistic& whole,
                                                    std::size_t value,
                                                    std::size_t groups);

/// Value `value` of `whole` in every group, with the covariance of the jackknife of whole clusters;
/// empty where a group has none, with all clusters or without one of them. `clusters` are those of
/// the group that lies on the fewest, for a covariance is no better known than its worst part. G
/// kernels.
[[nodiscard]] std::optional<GroupEstimates> jackknife_by_group(
    const Statistic& whole,
    std::size_t value,
    const table::Factor& group,
    std::span<const std::uint32_t> cluster);

}  // namespace tcert::statistics
