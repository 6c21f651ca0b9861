#include <statistics/equivalence/statistic_by_group.hpp>

#include <statistics/basics/compact_codes.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/resampling/jackknife.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {
namespace {

/// Of the group that lies on the fewest; where clusters are not named every row is its own.
std::size_t smallest_clusters(const table::Factor& group, std::span<const std::uint32_t> cluster) {
  std::vector<std::vector<std::uint32_t>> codes(group.levels.size());
  for (std::size_t row = 0; row < group.codes.size(); ++row) {
    codes.at(group.codes[row])
        .push_back(cluster.empty() ? static_cast<std::uint32_t>(row) : cluster[row]);
  }
  std::size_t least = group.codes.size();
  for (const std::vector<std::uint32_t>& one : codes) {
    least = std::min(least, count_codes(one));
  }
  return least;
}

}  // namespace

Statistic by_group(const Statistic& whole, const table::Factor& group) {
  if (group.rows() != whole.rows) {
    throw std::invalid_argument("a statistic by group: rows differ");
  }
  const std::size_t groups = group.levels.size();
  const std::size_t each = whole.values;
  Statistic statistic;
  statistic.rows = whole.rows;
  statistic.values = groups * each;
  statistic.make_kernel = [whole, codes = group.codes, groups, each]() -> StatisticKernel {
    return [kernel = whole.make_kernel(),
            codes,
            groups,
            each,
            masked = std::vector<std::uint32_t>(codes.size())](
               std::span<const std::uint32_t> multiplicity, std::span<double> values) mutable {
      for (std::size_t g = 0; g < groups; ++g) {
        for (std::size_t row = 0; row < codes.size(); ++row) {
          masked[row] = codes[row] == g ? multiplicity[row] : 0;
        }
        kernel(masked, values.subspan(g * each, each));
      }
    };
  };
  return statistic;
}

std::function<RangeKernel()> range_of(const Statistic& whole,
                                      std::size_t value,
                                      std::size_t groups) {
  return [whole, value, groups]() -> RangeKernel {
    return [kernel = whole.make_kernel(),
            value,
            groups,
            masked = std::vector<std::uint32_t>(whole.rows),
            values =
                std::vector<double>(whole.values)](std::span<const std::uint32_t> labels) mutable {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (std::size_t g = 0; g < groups; ++g) {
        for (std::size_t row = 0; row < masked.size(); ++row) {
          masked[row] = labels[row] == g ? 1 : 0;
        }
        kernel(masked, values);
        if (std::isnan(values[value])) {
          return values[value];
        }
        low = std::min(low, values[value]);
        high = std::max(high, values[value]);
      }
      return high - low;
    };
  };
}

std::optional<GroupEstimates> jackknife_by_group(const Statistic& whole,
                                                 std::size_t value,
                                                 const table::Factor& group,
                                                 std::span<const std::uint32_t> cluster) {
  const Statistic each = by_group(whole, group);
  const ResamplingPlan plan = ResamplingPlan::of_clusters(cluster);
  std::vector<double> values(each.values);
  each.make_kernel()(std::vector<std::uint32_t>(whole.rows, 1), values);
  const std::vector<std::vector<double>> without = leave_one_out(each, plan);
  GroupEstimates estimates;
  estimates.names = group.levels;
  estimates.clusters = smallest_clusters(group, cluster);
  const auto groups = static_cast<Eigen::Index>(group.levels.size());
  estimates.values.resize(groups);
  Eigen::MatrixXd left_out(groups, static_cast<Eigen::Index>(plan.units()));
  for (Eigen::Index g = 0; g < groups; ++g) {
    const std::size_t at = static_cast<std::size_t>(g) * whole.values + value;
    estimates.values(g) = values[at];
    left_out.row(g) = Eigen::Map<const Eigen::RowVectorXd>(without[at].data(), left_out.cols());
  }
  estimates.covariance = jackknife_covariance(estimates.values, left_out);
  const bool known = estimates.values.allFinite() && estimates.covariance.allFinite() &&
                     estimates.covariance.diagonal().minCoeff() > 0.0;
  return known && estimates.clusters > 1 ? std::optional(std::move(estimates)) : std::nullopt;
}

}  // namespace tcert::statistics
