#include <statistics/equivalence/range_permutation.hpp>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/quantile.hpp>
#include <stdexcept>
#include <table/random.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

/// Rows by cluster, rising within each.
std::vector<std::vector<std::uint32_t>> rows_by_cluster(std::span<const std::uint32_t> cluster) {
  const CompactCodes compact = compact_codes(cluster);
  std::vector<std::vector<std::uint32_t>> rows(compact.count);
  for (std::size_t row = 0; row < cluster.size(); ++row) {
    rows[compact.codes[row]].push_back(static_cast<std::uint32_t>(row));
  }
  return rows;
}

void shuffle_within(const std::vector<std::vector<std::uint32_t>>& clusters,
                    table::RandomStream random,
                    std::vector<std::uint32_t>& labels) {
  for (const std::vector<std::uint32_t>& rows : clusters) {
    for (std::size_t left = rows.size(); left > 1; --left) {
      const std::uint32_t chosen = random.below(static_cast<std::uint32_t>(left));
      std::swap(labels[rows[left - 1]], labels[rows[chosen]]);
    }
  }
}

}  // namespace

RangeUnderEquality range_under_equality(std::span<const std::uint32_t> labels,
                                        std::span<const std::uint32_t> cluster,
                                        const std::function<RangeKernel()>& make_kernel,
                                        const PermutationOptions& options) {
  if (labels.size() != cluster.size()) {
    throw std::invalid_argument("range under equality: lengths differ");
  }
  if (options.permutations == 0) {
    throw std::invalid_argument("range under equality: needs a permutation");
  }
  const auto clusters = rows_by_cluster(cluster);
  std::vector<double> ranges(options.permutations, std::numeric_limits<double>::quiet_NaN());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, options.permutations, 16), [&](const Range& part) {
    RangeKernel kernel = make_kernel();
    std::vector<std::uint32_t> shuffled;
    for (std::size_t r = part.begin(); r < part.end(); ++r) {
      shuffled.assign(labels.begin(), labels.end());
      shuffle_within(clusters, table::RandomStream(options.seed, options.analysis, r), shuffled);
      ranges[r] = kernel(shuffled);
      if (options.advance) {
        options.advance();
      }
    }
  });
  RangeUnderEquality result;
  if (const double observed = make_kernel()(labels); !std::isnan(observed)) {
    result.observed = observed;
  }
  std::erase_if(ranges, [](double range) { return std::isnan(range); });
  result.permutations = ranges.size();
  result.failed = options.permutations - ranges.size();
  if (ranges.empty()) {
    return result;
  }
  double sum = 0.0;
  std::size_t as_large = 0;
  for (const double range : ranges) {
    sum += range;
    // Equal statistics of other labels may differ by rounding.
    as_large += result.observed && range >= *result.observed - 1e-12 ? 1 : 0;
  }
  result.expected = sum / static_cast<double>(ranges.size());
  result.upper = quantile(ranges, 0.95);
  if (result.observed) {
    result.p_value =
        (1.0 + static_cast<double>(as_large)) / (1.0 + static_cast<double>(result.permutations));
  }
  return result;
}

}  // namespace tcert::statistics
