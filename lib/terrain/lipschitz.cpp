#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <terrain/lipschitz.hpp>

namespace tcert::terrain {
namespace {

/// P(chi-square with 2m degrees of freedom <= x).
[[nodiscard]] double chi_square_even(int m, double x) {
  double term = std::exp(-0.5 * x);
  double tail = term;
  for (int k = 1; k < m; ++k) {
    term *= 0.5 * x / k;
    tail += term;
  }
  return 1.0 - tail;
}

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

// In length scales. A patch holds the measurements within kReach of its anchor; anchors are kApart
// from one another, so that the patches' centres are at least two apart.
constexpr double kReach = 0.5;
constexpr double kApart = 3.0;

/// A plane over a patch flattens the field: of a gradient's variance it keeps at least (1 +
/// kReach^2 / 2)^-2, which it does if all measurements are at the patch's edge.
constexpr double kLeastShare = 0.79;

[[nodiscard]] std::vector<const Measurement*> points_round(std::span<const Measurement> all,
                                                           const Position& anchor,
                                                           double reach) {
  std::vector<const Measurement*> points;
  for (const Measurement& m : all) {
    if ((m.at - anchor).norm() <= reach) {
      points.push_back(&m);
    }
  }
  return points;
}

/// Squared norm of the least-squares plane's gradient; negative if there are fewer than three
/// points or all are on a line.
[[nodiscard]] double squared_gradient(const std::vector<const Measurement*>& points) {
  if (points.size() < 3) {
    return -1.0;
  }
  Position centre(0.0, 0.0);
  double mean = 0.0;
  for (const Measurement* m : points) {
    centre += m->at;
    mean += m->value;
  }
  const auto n = static_cast<double>(points.size());
  centre /= n;
  mean /= n;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  Eigen::Vector2d moment(0.0, 0.0);
  for (const Measurement* m : points) {
    const Eigen::Vector2d d = m->at - centre;
    scatter += d * d.transpose();
    moment += d * (m->value - mean);
  }
  const double trace = scatter.trace();
  if (!(scatter.determinant() > 1e-4 * trace * trace)) {
    return -1.0;
  }
  return (scatter.inverse() * moment).squaredNorm();
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

double confidence_of_estimate(double confidence, int number) noexcept {
  return 1.0 - std::ldexp(1.0 - confidence, -number);
}

LipschitzEstimate estimate_lipschitz(const Grid& grid,
                                     std::span<const Measurement> measurements,
                                     double length_scale,
                                     double noise_bound,
                                     double confidence) {
  LipschitzEstimate estimate;
  std::vector<Position> anchors;
  double sum = 0.0;
  for (const Measurement& m : measurements) {
    const bool apart = std::all_of(anchors.begin(), anchors.end(), [&](const Position& a) {
      return (a - m.at).norm() >= kApart * length_scale;
    });
    if (!apart) {
      continue;
    }
    const double gradient2 =
        squared_gradient(points_round(measurements, m.at, kReach * length_scale));
    if (gradient2 >= 0.0) {
      sum += gradient2 / kLeastShare;
      anchors.push_back(m.at);
    }
  }
  estimate.patches = static_cast<int>(anchors.size());
  if (estimate.patches == 0) {
    estimate.constant = kUnbounded;
    return estimate;
  }
  const double half_risk = 0.5 * (1.0 - confidence);
  const double steepest = steepest_measured(measurements, noise_bound);
  estimate.gradient_sd = std::sqrt(sum / (2.0 * estimate.patches));
  const double quantile =
      solve_rising([&](double x) { return chi_square_even(estimate.patches, x); }, half_risk, 1e6);
  const double sd_bound = std::sqrt(sum / quantile);
  estimate.constant = std::max(steepest, sd_bound * steepest_factor(grid, length_scale, half_risk));
  return estimate;
}

}  // namespace tcert::terrain
