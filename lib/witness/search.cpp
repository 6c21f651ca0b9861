#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>
#include <witness/band.hpp>
#include <witness/distance_field.hpp>
#include <witness/driven_route.hpp>
#include <witness/lattice_route.hpp>
#include <witness/polygon.hpp>
#include <witness/region_shape.hpp>
#include <witness/search.hpp>

namespace tcert::witness {
namespace {

constexpr double kStride = 0.015;        // m, between the vertices of a route
constexpr double kNearlyAsWide = 0.006;  // m
constexpr double kFine = 0.0006;         // m, to which a margin is bisected
constexpr int kStepsATarget = 40;
constexpr std::array kSpacings{0.08, 0.04, 0.02};  // m

/// Steps out the corners of a route over a lattice.
std::vector<Point> smoothed(std::vector<Point> p) {
  for (int pass = 0; pass < 20; ++pass) {
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      p[i] = 0.5 * p[i] + 0.25 * (p[i - 1] + p[i + 1]);
    }
  }
  return p;
}

/// Stretches towards `likely_m` first, then bisects up to `most_m`.
Band bisected(
    Band band, double likely_m, double most_m, const BandProblem& problem, int& iterations) {
  double high_m = most_m;
  double target_m = likely_m;
  while (iterations > 0 && high_m - band.margin_m > kFine) {
    int steps = std::min(iterations, kStepsATarget);
    iterations -= steps;
    const double before_m = band.margin_m;
    const Band next = stretched(band.polygon, target_m, problem, steps);
    iterations += steps;
    if (next.margin_m > band.margin_m) {
      band = next;
    }
    if (band.margin_m < target_m - kFine) {
      high_m = target_m;
    }
    if (band.margin_m <= before_m && high_m - band.margin_m <= kFine) {
      break;
    }
    target_m = 0.5 * (std::max(band.margin_m, -1.0) + high_m);
  }
  return band;
}

Band best_band(const std::vector<Point>& route,
               double likely_m,
               double most_m,
               const BandProblem& problem,
               int iterations) {
  Band band{smoothed(resampled(route, kSpacings.front())), 0.0};
  for (const double spacing_m : kSpacings) {
    int budget = iterations / static_cast<int>(kSpacings.size());
    band.polygon = resampled(band.polygon, spacing_m);
    band.margin_m = estimate(band.polygon, problem.field, problem.robot).margin_m;
    band = bisected(std::move(band), likely_m, most_m, problem, budget);
  }
  return band;
}

}  // namespace

Found search(const FreeCells& cells,
             const Region& start,
             const Region& goal,
             const Robot& robot,
             const Samples& samples,
             int iterations) {
  if (overlap(start, goal)) {
    return {std::nullopt, "S and G overlap"};
  }
  const DistanceField field(cells);
  const double cell_m = cells.lattice().cell_m;
  const int stride = std::max(1, static_cast<int>(std::lround(kStride / cell_m)));
  // The middle of a passage may lie between the vertices of a route.
  const double beside_m = 0.75 * stride * cell_m;
  const RouteGrid grid{field, start, goal, stride};
  const auto value_m = widest_value(grid, needed_clearance(robot, 0.0) - beside_m);
  if (!value_m) {
    return {std::nullopt, "no route from S to G is as wide as the body"};
  }
  const double likely_m = 2.0 * (*value_m - needed_clearance(robot, 0.0));
  const double most_m = likely_m + 2.0 * beside_m;
  const BandProblem problem{field, start, goal, robot};
  Found found;
  std::array routes{short_route(grid, *value_m - kNearlyAsWide), std::vector<Point>()};
  for (std::size_t k = 0; k < routes.size(); ++k) {
    if (k == 1) {
      if (found.witness && found.witness->checked.margin_m > likely_m - kNearlyAsWide) {
        break;
      }
      routes[k] = driven_route(samples, start, goal);
    }
    if (routes[k].size() < 2) {
      continue;
    }
    Path path = path_of(best_band(routes[k], likely_m, most_m, problem, iterations).polygon);
    Checked checked = check(path, cells, start, goal, robot);
    if (!checked.refused.empty()) {
      found.reason = checked.refused;
    } else if (!found.witness || checked.margin_m > found.witness->checked.margin_m) {
      found.witness = Witness{std::move(path), std::move(checked)};
    }
  }
  return found;
}

}  // namespace tcert::witness
