#include <algorithm>
#include <array>
#include <cmath>
#include <tcert/region_overlap.hpp>
#include <vector>
#include <witness/bisected_band.hpp>
#include <witness/driven_route.hpp>
#include <witness/lattice_route.hpp>
#include <witness/polygon.hpp>
#include <witness/search.hpp>
#include <witness/tried_polygon.hpp>

namespace tcert::witness {
namespace {

constexpr double kStride = 0.015;        // m, between the vertices of a route
constexpr double kNearlyAsWide = 0.006;  // m
constexpr double kCoarse = 0.08;         // m, between the points of a band; halved at each level
constexpr int kLevels = 3;

}  // namespace

Found search(const SearchSpace& space,
             const Region& start,
             const Region& goal,
             const Robot& robot,
             const Samples& samples,
             int iterations) {
  if (touch(start, goal)) {
    return {std::nullopt, "S and G overlap"};
  }
  const double cell_m = space.field.cell_m();
  const int stride = std::max(1, static_cast<int>(std::lround(kStride / cell_m)));
  // The middle of a passage may lie between the vertices of a route.
  const double beside_m = 0.75 * stride * cell_m;
  const RouteGrid grid{space.field, start, goal, stride};
  const auto value_m = widest_value(grid, needed_clearance(robot, 0.0) - beside_m);
  if (!value_m) {
    return {std::nullopt, "no route from S to G is as wide as the body"};
  }
  const double likely_m = 2.0 * (*value_m - needed_clearance(robot, 0.0));
  const Targets targets{likely_m, likely_m + 2.0 * beside_m};
  const BandProblem problem{space.field, start, goal, robot};
  Found found;
  std::array routes{short_route(grid, *value_m - kNearlyAsWide), std::vector<Point>()};
  for (std::size_t k = 0; k < routes.size(); ++k) {
    if (k == 1) {
      if (found.witness && found.witness->checked.margin_m > likely_m - kNearlyAsWide) {
        break;
      }
      routes[k] = DrivenPositions(samples).route(start, goal);
    }
    if (routes[k].size() < 2) {
      continue;
    }
    try_polygon(smoothed(resampled(routes[k], kCoarse)),
                {targets, kLevels, iterations},
                problem,
                space.checker,
                found);
  }
  return found;
}

}  // namespace tcert::witness
