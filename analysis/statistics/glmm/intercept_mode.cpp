#include <cmath>
#include <cstddef>
#include <limits>
#include <statistics/glmm/intercept_mode.hpp>

namespace tcert::statistics {
namespace {

RowSums sums_at(const InterceptGroup& group, double theta, double u) {
  const double factor = std::exp(theta * u);
  double residual = 0.0;
  double weight = 0.0;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    const double odds = group.odds[i] * factor;
    const double failure = 1.0 / (1.0 + odds);
    const double success = odds * failure;
    residual += group.successes[i] - group.trials[i] * success;
    weight += group.trials[i] * success * failure;
  }
  RowSums sums;
  sums.residual = residual;
  sums.w0 = weight;
  return sums;
}

}  // namespace

bool find_mode(const InterceptGroup& group, double theta, double& mode) {
  double low = -std::numeric_limits<double>::infinity();
  double high = -low;
  double u = mode;
  for (int iteration = 0; iteration < 200; ++iteration) {
    if (!(std::abs(theta * u) <= kLargestGroupEta)) {
      // Far off: start where every group can.
      u = 0.0;
      if (iteration > 0) {
        return false;
      }
    }
    const RowSums sums = sums_at(group, theta, u);
    const double slope = theta * sums.residual - u;
    const double step = slope / (1.0 + theta * theta * sums.w0);
    (slope > 0.0 ? low : high) = u;
    double next = u + step;
    if (std::abs(step) <= 1e-9 * (1.0 + std::abs(u))) {
      mode = next;
      return std::isfinite(next);
    }
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
      if (!std::isfinite(next)) {
        return false;
      }
    }
    u = next;
  }
  return false;
}

InterceptMode at_mode(const InterceptGroup& group,
                      double theta,
                      double u,
                      InterceptScratch& scratch) {
  const auto rows = static_cast<std::size_t>(group.rows);
  scratch.w0.resize(rows);
  scratch.w1.resize(rows);
  scratch.w2.resize(rows);
  const double factor = std::exp(theta * u);
  InterceptMode mode;
  for (Eigen::Index i = 0; i < group.rows; ++i) {
    const double odds = group.odds[i] * factor;
    const double failure = 1.0 / (1.0 + odds);
    const double success = odds * failure;
    const double w0 = group.trials[i] * success * failure;
    const double w1 = w0 * (failure - success);
    const double w2 = w0 * (1.0 - 6.0 * success * failure);
    mode.sums.residual += group.successes[i] - group.trials[i] * success;
    mode.sums.w0 += w0;
    mode.sums.w1 += w1;
    mode.sums.w2 += w2;
    scratch.w0[static_cast<std::size_t>(i)] = w0;
    scratch.w1[static_cast<std::size_t>(i)] = w1;
    scratch.w2[static_cast<std::size_t>(i)] = w2;
  }
  mode.u = u;
  mode.h = 1.0 + theta * theta * mode.sums.w0;
  mode.s = 1.0 / std::sqrt(mode.h);
  return mode;
}

double intercept_curvature(const InterceptGroup& group, double theta, double u) {
  return 1.0 + theta * theta * sums_at(group, theta, u).w0;
}

}  // namespace tcert::statistics
