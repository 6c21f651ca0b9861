#pragma once
/// \file
/// Largest less smallest estimate of groups is above 0 even where they are all equal. How far, the
/// permutation of the group labels within clusters tells.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tcert::statistics {

/// The largest less the smallest estimate for these labels, one a row; NaN where there is none. It
/// owns its scratch memory and is called from one thread.
using RangeKernel = std::function<double(std::span<const std::uint32_t> labels)>;

struct PermutationOptions {
  std::size_t permutations = 2000;
  std::uint64_t seed = 1;
  std::uint32_t analysis = 0;  ///< Which stream of the seed.
  /// Called after each permutation, as BootstrapOptions::advance is after each replicate.
  std::function<void()> advance{};
};

struct RangeUnderEquality {
  std::size_t permutations = 0;    ///< That gave a range.
  std::size_t failed = 0;          ///< That did not.
  std::optional<double> observed;  ///< Of the labels as they are.
  std::optional<double> expected;  ///< Mean over permutations.
  std::optional<double> upper;     ///< Their 95 % quantile, type 7.
  std::optional<double> p_value;   ///< (1 + those at least as large) / (1 + permutations).
};

/// Labels keep their numbers within each cluster; permutation r shuffles them by
/// RandomStream(seed, analysis, r), cluster by cluster: the same for any number of threads.
/// \throws std::invalid_argument if lengths differ or there is no permutation.
[[nodiscard]] RangeUnderEquality range_under_equality(
    std::span<const std::uint32_t> labels,
    std::span<const std::uint32_t> cluster,
    const std::function<RangeKernel()>& make_kernel,
    const PermutationOptions& options = {});

}  // namespace tcert::statistics
