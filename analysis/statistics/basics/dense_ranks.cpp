#include <statistics/basics/dense_ranks.hpp>

#include <statistics/basics/sort_order.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

std::vector<std::uint32_t> group_codes(const TimeOrder& order) {
  std::vector<std::uint32_t> codes(order.by_stop.size());
  for (std::size_t g = 0; g < order.groups(); ++g) {
    for (const std::uint32_t row : order.stops_of(g)) {
      codes[row] = static_cast<std::uint32_t>(g);
    }
  }
  return codes;
}

}  // namespace

DenseRanks dense_ranks(std::span<const double> values, const TimeOrder& order) {
  if (values.size() != order.by_stop.size()) {
    throw std::invalid_argument("ranks: as many values as rows are needed");
  }
  std::vector<std::uint32_t> by_value = sort_order(values);
  if (order.groups() > 1) {
    by_value = group_order(std::move(by_value), group_codes(order), order.first);
  }
  DenseRanks result;
  result.rank.resize(values.size());
  result.distinct.reserve(order.groups());
  for (std::size_t g = 0; g < order.groups(); ++g) {
    std::uint32_t distinct = 0;
    for (std::size_t k = order.first[g]; k < order.first[g + 1]; ++k) {
      if (k == order.first[g] || values[by_value[k]] != values[by_value[k - 1]]) {
        ++distinct;
      }
      result.rank[by_value[k]] = distinct - 1;
    }
    result.distinct.push_back(distinct);
  }
  return result;
}

}  // namespace tcert::statistics
