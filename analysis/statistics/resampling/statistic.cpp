#include <statistics/resampling/statistic.hpp>

#include <memory>
#include <statistics/resampling/jackknife.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {

Statistic joined(std::vector<Statistic> parts) {
  if (parts.empty()) {
    throw std::invalid_argument("statistic: nothing to join");
  }
  const auto shared = std::make_shared<const std::vector<Statistic>>(std::move(parts));
  Statistic result;
  result.rows = shared->front().rows;
  result.values = 0;
  for (const Statistic& part : *shared) {
    if (part.rows != result.rows) {
      throw std::invalid_argument("statistic: joined parts are of different numbers of rows");
    }
    result.values += part.values;
  }
  result.make_kernel = [shared]() -> StatisticKernel {
    std::vector<std::pair<std::size_t, StatisticKernel>> kernels;
    for (const Statistic& part : *shared) {
      kernels.emplace_back(part.values, part.make_kernel());
    }
    return [kernels](std::span<const std::uint32_t> multiplicity, std::span<double> values) {
      std::size_t first = 0;
      for (const auto& [count, kernel] : kernels) {
        kernel(multiplicity, values.subspan(first, count));
        first += count;
      }
    };
  };
  result.leave_one_out = [shared](const ResamplingPlan& plan, std::span<std::vector<double>> out) {
    std::size_t first = 0;
    for (const Statistic& part : *shared) {
      leave_one_out(part, plan, out.subspan(first, part.values));
      first += part.values;
    }
  };
  return result;
}

}  // namespace tcert::statistics
