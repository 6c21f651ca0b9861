#include <statistics/equivalence/statistic_by_group.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {

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

}  // namespace tcert::statistics
