#include <statistics/calibration/isotonic.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// Rows that are pooled so far, as sums.
struct Pool {
  double first_x = 0.0;
  double last_x = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  std::size_t rows = 0;

  [[nodiscard]] double mean_y() const noexcept { return sum_y / static_cast<double>(rows); }

  void take(const Pool& next) noexcept {
    last_x = next.last_x;
    sum_x += next.sum_x;
    sum_y += next.sum_y;
    rows += next.rows;
  }
};

void require_finite_pairs(std::span<const double> x, std::span<const double> y) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (x.size() != y.size() || !std::ranges::all_of(x, finite) || !std::ranges::all_of(y, finite)) {
    throw std::invalid_argument("isotonic fit: as many x as y, all finite");
  }
}

/// A pool for each x that there is, in order.
std::vector<Pool> pools_by_x(std::span<const double> x, std::span<const double> y) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t row) { return x[row]; });
  std::vector<Pool> pools;
  for (const std::size_t row : order) {
    const Pool one{x[row], x[row], x[row], y[row], 1};
    if (!pools.empty() && pools.back().last_x == x[row]) {
      pools.back().take(one);
    } else {
      pools.push_back(one);
    }
  }
  return pools;
}

/// A mean that rounding must not push out of the rows that it is of.
double mean_x(const Pool& pool) noexcept {
  return std::clamp(pool.sum_x / static_cast<double>(pool.rows), pool.first_x, pool.last_x);
}

}  // namespace

double IsotonicFit::at(double x) const noexcept {
  const auto after =
      std::upper_bound(blocks.begin(), blocks.end(), x, [](double v, const IsotonicBlock& b) {
        return v < b.first_x;
      });
  if (after == blocks.begin()) {
    return blocks.front().value;
  }
  const IsotonicBlock& block = *(after - 1);
  if (x <= block.last_x || after == blocks.end()) {
    return block.value;
  }
  const double share = (x - block.last_x) / (after->first_x - block.last_x);
  return block.value + share * (after->value - block.value);
}

IsotonicFit isotonic_fit(std::span<const double> x, std::span<const double> y, Trend trend) {
  require_finite_pairs(x, y);
  std::vector<Pool> pools;
  for (const Pool& next : pools_by_x(x, y)) {
    pools.push_back(next);
    while (pools.size() > 1) {
      const Pool& last = pools.back();
      Pool& before = pools[pools.size() - 2];
      const bool rises = last.mean_y() > before.mean_y();
      const bool falls = last.mean_y() < before.mean_y();
      if (trend == Trend::rising ? rises : falls) {
        break;
      }
      before.take(last);
      pools.pop_back();
    }
  }
  IsotonicFit fit;
  fit.trend = trend;
  for (const Pool& pool : pools) {
    fit.blocks.push_back({pool.first_x, pool.last_x, mean_x(pool), pool.mean_y(), pool.rows});
  }
  for (std::size_t row = 0; row < x.size(); ++row) {
    const double residual = y[row] - fit.at(x[row]);
    fit.squares += residual * residual;
  }
  return fit;
}

IsotonicFit isotonic_fit(std::span<const double> x, std::span<const double> y) {
  IsotonicFit falling = isotonic_fit(x, y, Trend::falling);
  IsotonicFit rising = isotonic_fit(x, y, Trend::rising);
  return rising.squares < falling.squares ? rising : falling;
}

}  // namespace tcert::statistics
