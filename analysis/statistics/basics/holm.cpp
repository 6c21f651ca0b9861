#include <statistics/basics/holm.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace tcert::statistics {

std::vector<std::optional<double>> holm(std::span<const std::optional<double>> p) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (!p[k]) {
      continue;
    }
    if (!(*p[k] >= 0.0 && *p[k] <= 1.0)) {
      throw std::invalid_argument("Holm: a p-value is not in [0, 1]");
    }
    order.push_back(k);
  }
  std::stable_sort(
      order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return *p[a] < *p[b]; });
  std::vector<std::optional<double>> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    largest = std::max(largest, static_cast<double>(order.size() - k) * *p[order[k]]);
    adjusted[order[k]] = std::min(1.0, largest);
  }
  return adjusted;
}

}  // namespace tcert::statistics
