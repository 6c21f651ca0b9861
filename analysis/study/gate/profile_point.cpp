#include "analysis/study/gate/profile_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <statistics/basics/normal.hpp>
#include <vector>

namespace tcert::study {
namespace {

constexpr double kTolerance = 1e-12;
constexpr int kMaxSteps = 200;

/// log(1 + exp(eta)) without overflow.
double softplus(double eta) { return std::max(eta, 0.0) + std::log1p(std::exp(-std::abs(eta))); }

/// The drop of the likelihood along the point.
class Drop {
 public:
  Drop(std::span<const double> x, std::span<const std::uint8_t> success, double point, double slope)
      : x_(x), success_(success), slope_(slope), highest_(at(point, slope).value) {
    // The limit of the likelihood far from the data: a constant chance.
    const auto n = static_cast<double>(x.size());
    double successes = 0.0;
    for (const std::uint8_t one : success) {
      successes += one;
    }
    level_ = successes * std::log(successes / n) + (n - successes) * std::log1p(-successes / n);
  }

  /// Twice the drop far from the data, less `target`: of the test that the slope is 0.
  [[nodiscard]] double beyond_at_infinity(double target) const {
    return 2.0 * (highest_ - level_) - target;
  }

  /// Twice the drop at x0, less `target`.
  [[nodiscard]] double beyond(double x0, double target) const {
    // The slope of the estimate is a bad start far from its point, where it overflows.
    double beta = slope_;
    Likelihood now = at(x0, beta);
    if (const Likelihood level = at(x0, 0.0); !(now.value > level.value)) {
      beta = 0.0;
      now = level;
    }
    for (int step = 0; step < kMaxSteps; ++step) {
      const double move = now.gradient / now.information;
      Likelihood next;
      double share = 1.0;
      do {
        next = at(x0, beta + share * move);
        share *= 0.5;
      } while (!(next.value >= now.value) && share > 1e-12);
      if (!(next.value >= now.value)) {
        break;
      }
      beta += 2.0 * share * move;
      const bool done = std::abs(move) <= kTolerance * (1.0 + std::abs(beta));
      now = next;
      if (done) {
        break;
      }
    }
    return 2.0 * (highest_ - now.value) - target;
  }

 private:
  struct Likelihood {
    double value = 0.0;
    double gradient = 0.0;
    double information = 0.0;
  };

  [[nodiscard]] Likelihood at(double x0, double beta) const {
    Likelihood sum;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double off = x_[i] - x0;
      const double eta = beta * off;
      const double p = 1.0 / (1.0 + std::exp(-eta));
      const double y = success_[i];
      sum.value += y * eta - softplus(eta);
      sum.gradient += (y - p) * off;
      sum.information += p * (1.0 - p) * off * off;
    }
    return sum;
  }

  std::span<const double> x_;
  std::span<const std::uint8_t> success_;
  double slope_;
  double highest_;
  double level_ = 0.0;
};

/// Where the drop passes the target between a point inside and one outside.
double end_between(const Drop& drop, double inside, double outside, double target) {
  for (int step = 0; step < kMaxSteps; ++step) {
    const double middle = 0.5 * (inside + outside);
    if (middle == inside || middle == outside) {
      break;
    }
    (drop.beyond(middle, target) <= 0.0 ? inside : outside) = middle;
  }
  return inside;
}

/// From a point that is `outside` or not, the first one by doubling steps that is the other.
double first_change(const Drop& drop, double from, double step, double target, bool outside) {
  double at = from + step;
  for (int i = 1; i < 60 && (drop.beyond(at, target) > 0.0) == outside; ++i) {
    at = from + step * std::exp2(i);
  }
  return at;
}

ConfidenceSet bounded_set(const Drop& drop, double point, double scale, double target) {
  const double low = first_change(drop, point, -scale, target, false);
  const double high = first_change(drop, point, scale, target, false);
  return {ConfidenceSetKind::bounded,
          end_between(drop, point, low, target),
          end_between(drop, point, high, target)};
}

/// Of a set without bounds: what it leaves out, if anything, found on a grid that reaches far.
ConfidenceSet unbounded_set(const Drop& drop, double point, double scale, double target) {
  constexpr int kGrid = 400;
  std::vector<double> grid;
  for (int i = 1; i < kGrid; ++i) {
    grid.push_back(point + scale * std::tan(std::numbers::pi * (i / double{kGrid} - 0.5)));
  }
  const auto outside = [&](double x0) { return drop.beyond(x0, target) > 0.0; };
  const auto some = std::find_if(grid.begin(), grid.end(), outside);
  if (some == grid.end()) {
    return {ConfidenceSetKind::whole_line, 0.0, 0.0};
  }
  const auto last = std::find_if(grid.rbegin(), grid.rend(), outside).base() - 1;
  const double before =
      some == grid.begin() ? first_change(drop, *some, -scale, target, true) : *(some - 1);
  const double after =
      last + 1 == grid.end() ? first_change(drop, *last, scale, target, true) : *(last + 1);
  return {ConfidenceSetKind::two_rays,
          end_between(drop, before, *some, target),
          end_between(drop, after, *last, target)};
}

}  // namespace

ConfidenceSet profile_point_set(std::span<const double> x,
                                std::span<const std::uint8_t> success,
                                double point,
                                double slope,
                                double scale,
                                double level) {
  const double z = statistics::normal_factor(level);
  const double target = z * z;
  const Drop drop(x, success, point, slope);
  return drop.beyond_at_infinity(target) > 0.0 ? bounded_set(drop, point, scale, target)
                                               : unbounded_set(drop, point, scale, target);
}

}  // namespace tcert::study
