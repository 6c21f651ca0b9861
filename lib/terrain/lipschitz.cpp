#include <algorithm>
#include <cmath>
#include <numbers>
#include <terrain/lipschitz.hpp>

namespace tcert::terrain {
namespace {

/// Where a rising function of x > 0 passes `level`.
template <class F>
[[nodiscard]] double solve_rising(F f, double level, double high) {
  double low = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < level ? low : high) = middle;
  }
  return high;
}

}  // namespace

double lipschitz_bound(const Grid& grid, std::span<const double> values) {
  const auto width = static_cast<std::size_t>(grid.columns);
  double steepest2 = 0.0;
  for (int x = 0; x < grid.rows; ++x) {
    for (int y = 0; y < grid.columns; ++y) {
      const std::size_t i = grid.index({x, y});
      const bool down = x + 1 < grid.rows;
      const bool right = y + 1 < grid.columns;
      double dx = down ? std::abs(values[i + width] - values[i]) : 0.0;
      double dy = right ? std::abs(values[i + 1] - values[i]) : 0.0;
      if (down && right) {
        dx = std::max(dx, std::abs(values[i + width + 1] - values[i + 1]));
        dy = std::max(dy, std::abs(values[i + width + 1] - values[i + width]));
      }
      steepest2 = std::max(steepest2, dx * dx + dy * dy);
    }
  }
  return std::sqrt(steepest2);
}

double steepest_measured(std::span<const Measurement> measurements, double noise_bound) {
  double steepest = 0.0;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double d = (measurements[i].at - measurements[j].at).norm();
      if (d > 0.0) {
        const double rise =
            std::abs(measurements[i].value - measurements[j].value) - 2.0 * noise_bound;
        steepest = std::max(steepest, rise / d);
      }
    }
  }
  return steepest;
}

double steepest_factor(const Grid& grid, double length_scale, double risk) {
  const double moment = 3.0 / (length_scale * length_scale);
  const auto area = static_cast<double>(grid.size());
  const double half_perimeter = static_cast<double>(grid.rows) + grid.columns;
  // Negative expected Euler characteristic above u^2 = t, for t above 1.
  const auto safety = [&](double t) {
    const double decay = std::exp(-0.5 * t);
    const double two = area * moment / (2.0 * std::numbers::pi) * (t - 1.0) * decay;
    const double one =
        half_perimeter * std::sqrt(moment) * std::sqrt(t / (2.0 * std::numbers::pi)) * decay;
    return -(two + one + decay);
  };
  // The sum falls beyond t = 3.
  const double t = 3.0 + solve_rising([&](double over) { return safety(3.0 + over); }, -risk, 1e3);
  return std::sqrt(t);
}

double variance_of(const Grid& grid, double lipschitz, double length_scale) {
  const double sd = lipschitz * length_scale / steepest_factor(grid, length_scale, 0.5);
  return sd * sd;
}

}  // namespace tcert::terrain
