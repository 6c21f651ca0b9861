#include <algorithm>
#include <array>
#include <cmath>
#include <tcert/region_overlap.hpp>
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
constexpr int kStepsATarget = 80;
constexpr double kCoarse = 0.08;  // m, between the points of a band; halved at each level
constexpr int kLevels = 3;
constexpr double kHope = 0.02;  // m, by which a finer band may be better

/// Margins in m to try: one that the widest route promises, and the most there can be.
struct Targets {
  double likely_m = 0.0;
  double most_m = 0.0;
};

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
Band bisected(Band band, const Targets& targets, const BandProblem& problem, int& iterations) {
  double high_m = targets.most_m;
  double target_m = targets.likely_m;
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

/// Stretches a route coarse to fine, and keeps what the checker measures of each.
void try_route(const std::vector<Point>& route,
               const Targets& targets,
               const BandProblem& problem,
               const FreeCells& cells,
               int iterations,
               Found& found) {
  Band band{smoothed(resampled(route, kCoarse)), 0.0};
  double best_m = -1.0;
  for (int level = 0; level < kLevels; ++level) {
    if (level > 0) {
      band.polygon = refined(band.polygon);
    }
    int budget = iterations / kLevels;
    band.margin_m = estimate(band.polygon, problem.field, problem.robot).margin_m;
    const double likely_m =
        level == 0 ? targets.likely_m : std::min(targets.likely_m, best_m + kHope);
    band = bisected(std::move(band), {likely_m, targets.most_m}, problem, budget);
    best_m = std::max(best_m, band.margin_m);
    const bool promises = !found.witness || band.margin_m > found.witness->checked.margin_m;
    if (!promises) {
      continue;
    }
    Path path = path_of(band.polygon);
    Checked checked = check(path, cells, problem.start, problem.goal, problem.robot);
    if (!checked.refused.empty()) {
      found.reason = checked.refused;
    } else if (!found.witness || checked.margin_m > found.witness->checked.margin_m) {
      found.witness = Witness{std::move(path), std::move(checked)};
    }
  }
}

}  // namespace

Found search(const FreeCells& cells,
             const Region& start,
             const Region& goal,
             const Robot& robot,
             const Samples& samples,
             int iterations) {
  if (touch(start, goal)) {
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
  const Targets targets{likely_m, likely_m + 2.0 * beside_m};
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
    try_route(routes[k], targets, problem, cells, iterations, found);
  }
  return found;
}

}  // namespace tcert::witness
