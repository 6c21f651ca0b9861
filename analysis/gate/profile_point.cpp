#include "analysis/gate/profile_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "analysis/basics/normal.hpp"

namespace tcert {
namespace {

constexpr double kTolerance = 1e-12;
constexpr int kMaxSteps = 200;

/// log(1 + exp(eta)) without overflow.
double softplus(double eta) { return std::max(eta, 0.0) + std::log1p(std::exp(-std::abs(eta))); }

/// The drop of the likelihood along the point.
class Drop {
 public:
  Drop(std::span<const double> x, std::span<const std::uint8_t> success, double point, double slope)
      : x_(x), success_(success), slope_(slope), highest_(at(point, slope).value) {}

  /// Twice the drop at x0, less `target`.
  [[nodiscard]] double beyond(double x0, double target) const {
    double beta = slope_;
    Likelihood now = at(x0, beta);
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

/// An end of a bounded set, by steps that double; empty if the drop stays below the target.
std::optional<double> bounded_end(const Drop& drop, double point, double step, double target) {
  double inside = point;
  for (int i = 0; i < 60; ++i) {
    const double outside = point + step * std::exp2(i);
    if (drop.beyond(outside, target) > 0.0) {
      return end_between(drop, inside, outside, target);
    }
    inside = outside;
  }
  return std::nullopt;
}

/// Of a set without bounds: what it leaves out, if anything, found on a grid that reaches far.
ConfidenceSet unbounded_set(const Drop& drop, double point, double scale, double target) {
  constexpr int kGrid = 400;
  std::vector<double> grid;
  for (int i = 1; i < kGrid; ++i) {
    grid.push_back(point + scale * std::tan(std::numbers::pi * (i / double{kGrid} - 0.5)));
  }
  const auto outside = [&](double x0) { return drop.beyond(x0, target) > 0.0; };
  const auto first = std::find_if(grid.begin(), grid.end(), outside);
  if (first == grid.end() || first == grid.begin() || outside(grid.back())) {
    return {ConfidenceSetKind::whole_line, 0.0, 0.0};
  }
  const auto last = std::find_if(grid.rbegin(), grid.rend(), outside).base();
  return {ConfidenceSetKind::two_rays,
          end_between(drop, *(first - 1), *first, target),
          end_between(drop, *last, *(last - 1), target)};
}

}  // namespace

ConfidenceSet profile_point_set(std::span<const double> x,
                                std::span<const std::uint8_t> success,
                                double point,
                                double slope,
                                double scale,
                                double level) {
  const double z = normal_factor(level);
  const double target = z * z;
  const Drop drop(x, success, point, slope);
  const auto low = bounded_end(drop, point, -scale, target);
  const auto high = bounded_end(drop, point, scale, target);
  if (low && high) {
    return {ConfidenceSetKind::bounded, *low, *high};
  }
  return unbounded_set(drop, point, scale, target);
}

}  // namespace tcert
