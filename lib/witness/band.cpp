#include <algorithm>
#include <array>
#include <cmath>
#include <tcert/elementary.hpp>
#include <witness/band.hpp>
#include <witness/banded_system.hpp>
#include <witness/polygon.hpp>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

constexpr double kSpareClearance = 0.0003;  // m, asked for beyond what is needed
constexpr double kSpareRadius = 1.003;
constexpr double kMet = 0.0002;        // m
constexpr double kSlope = 0.006;       // m, to either side of a gradient
constexpr double kLongestMove = 0.04;  // m a step
// A corner that turns by a hundredth too much weighs as 0.3 mm of clearance.
constexpr double kTurnWeight = 0.03;
constexpr double kEvenWeight = 0.1;
// Of the weight of turning, what any bend weighs, from the first steps to the last: bends spread
// along the band first, and then give way to what is asked for.
constexpr std::array kBendShares{0.3, 0.1, 0.03, 0.004};
constexpr int kMostSteps = 25;  // with one weight of bends
constexpr double kFirstDamping = 0.01;
constexpr double kLeastDamping = 1e-5;
constexpr double kMostDamping = 1e3;

/// One set of needs, and the equations of a step towards them.
class Stretching {
 public:
  Stretching(const BandProblem& problem, double wanted_m, std::size_t points)
      : problem_(problem),
        clearance_m_(needed_clearance(problem.robot, wanted_m) + kSpareClearance),
        radius_m_(kSpareRadius * needed_radius(problem.robot, wanted_m)),
        system_(2 * points) {}

  double bend_share = kBendShares.back();

  /// Builds the equations at these points; hands back half the sum of squares.
  double linearise(const std::vector<Point>& points) {
    system_.clear();
    edge_m_ = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      edge_m_ += distance(points[i - 1], points[i]) / static_cast<double>(points.size() - 1);
    }
    return sum_up(points, [this](std::size_t first, const auto& derivatives, double residual) {
      system_.add(first, derivatives(), residual);
    });
  }
  [[nodiscard]] double cost(const std::vector<Point>& points) const {
    return sum_up(points, [](std::size_t, const auto&, double) {});
  }
  [[nodiscard]] std::vector<Point> moved(const std::vector<Point>& points, double damping) const {
    const std::vector<double> step = system_.solved(damping);
    double largest_m = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      largest_m = std::max(largest_m, norm({step[2 * i], step[2 * i + 1]}));
    }
    const double share = largest_m > kLongestMove ? kLongestMove / largest_m : 1.0;
    std::vector<Point> there = points;
    for (std::size_t i = problem_.held; i + problem_.held < points.size(); ++i) {
      there[i] = points[i] + share * Point{step[2 * i], step[2 * i + 1]};
    }
    if (problem_.held == 0) {
      there.front() = nearest_within(problem_.start, there.front());
      there.back() = nearest_within(problem_.goal, there.back());
    }
    return there;
  }

 private:
  using Row = std::array<double, BandedSystem::kBand>;

  template <class Add>
  [[nodiscard]] double sum_up(const std::vector<Point>& p, const Add& add) const {
    double sum = 0.0;
    const std::size_t last = p.size() - 1;
    const auto take = [&](std::size_t point, double residual, const auto& derivatives) {
      sum += 0.5 * residual * residual;
      add(
          2 * point,
          [&] {
            Row row = derivatives();
            for (std::size_t k = 0; k < row.size(); ++k) {
              const std::size_t of = point + k / 2;
              row[k] = of < problem_.held || of + problem_.held > last ? 0.0 : row[k];
            }
            return row;
          },
          residual);
    };
    for (const std::size_t end : {std::size_t{0}, last}) {
      const double lack_m = clearance_m_ - problem_.field.at(p[end]);
      if (lack_m > 0.0) {
        take(end, lack_m, [&] {
          const Point slope = problem_.field.gradient(p[end], kSlope);
          return Row{-slope.x_m, -slope.y_m};
        });
      }
    }
    for (std::size_t i = 0; i < last; ++i) {
      const Point middle = 0.5 * (p[i] + p[i + 1]);
      const double lack_m = clearance_m_ - problem_.field.at(middle);
      if (lack_m > 0.0) {
        take(i, lack_m, [&] {
          const Point slope = 0.5 * problem_.field.gradient(middle, kSlope);
          return Row{-slope.x_m, -slope.y_m, -slope.x_m, -slope.y_m};
        });
      }
    }
    const double weight = kTurnWeight * std::min(radius_m_, 1.0) / edge_m_;
    for (std::size_t i = 1; i < last; ++i) {
      const Point in = p[i] - p[i - 1];
      const Point out = p[i + 1] - p[i];
      const double in_m = std::max(1e-9, norm(in));
      const double out_m = std::max(1e-9, norm(out));
      const Point u = (1.0 / in_m) * in;
      const Point v = (1.0 / out_m) * out;
      const double turn = elementary::atan2(cross(u, v), dot(u, v));
      // How the turn changes as the ends of the two edges move square to them.
      const Point by_in = (1.0 / in_m) * Point{-u.y_m, u.x_m};
      const Point by_out = (1.0 / out_m) * Point{-v.y_m, v.x_m};
      const auto turning = [&](double scale, double stretch) {
        const Point first = scale * by_in - stretch * u;
        const Point third = scale * by_out + stretch * v;
        const Point second = -1.0 * (first + third);
        return Row{first.x_m, first.y_m, second.x_m, second.y_m, third.x_m, third.y_m};
      };
      const double most = 0.5 * (in_m + out_m) / radius_m_;
      if (std::abs(turn) > most) {
        take(i - 1, weight * (std::abs(turn) - most), [&] {
          return turning(turn > 0.0 ? weight : -weight, -0.5 * weight / radius_m_);
        });
      }
      const double weak = bend_share * weight;
      take(i - 1, weak * turn, [&] { return turning(weak, 0.0); });
      take(i - 1, kEvenWeight * (out_m - in_m), [&] {
        const Point first = kEvenWeight * u;
        const Point third = kEvenWeight * v;
        const Point second = -1.0 * (first + third);
        return Row{first.x_m, first.y_m, second.x_m, second.y_m, third.x_m, third.y_m};
      });
    }
    return sum;
  }

  const BandProblem& problem_;
  double clearance_m_;
  double radius_m_;
  double edge_m_ = 0.0;  // mean length at the points that were last linearised at
  BandedSystem system_;
};

}  // namespace

Band stretched(const std::vector<Point>& polygon,
               double wanted_m,
               const BandProblem& problem,
               int& iterations) {
  Band best{polygon, estimate(polygon, problem.field, problem.robot).margin_m};
  Stretching stretching(problem, wanted_m, polygon.size());
  std::vector<Point> points = polygon;
  for (const double share : kBendShares) {
    stretching.bend_share = share;
    double damping = kFirstDamping;
    double cost = stretching.linearise(points);
    int steps = std::min(iterations, kMostSteps);
    iterations -= steps;
    while (steps > 0 && best.margin_m < wanted_m - kMet && damping < kMostDamping) {
      --steps;
      std::vector<Point> next = stretching.moved(points, damping);
      const double next_cost = stretching.cost(next);
      if (!(next_cost < cost)) {
        damping *= 6.0;
        continue;
      }
      const bool settled = cost - next_cost < 1e-4 * cost;
      damping = std::max(kLeastDamping, 0.3 * damping);
      points = std::move(next);
      const double margin_m = estimate(points, problem.field, problem.robot).margin_m;
      if (margin_m > best.margin_m) {
        best = {points, margin_m};
      }
      if (settled) {
        break;
      }
      cost = stretching.linearise(points);
    }
    iterations += steps;
  }
  return best;
}

}  // namespace tcert::witness
