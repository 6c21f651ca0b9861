#include <algorithm>
#include <witness/bisected_band.hpp>

namespace tcert::witness {
namespace {

constexpr double kFine = 0.0006;  // m
constexpr int kStepsATarget = 80;
constexpr int kPasses = 20;

}  // namespace

std::vector<Point> smoothed(std::vector<Point> polygon, std::size_t held) {
  const std::size_t first = std::max<std::size_t>(1, held);
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = first; i + first < polygon.size(); ++i) {
      polygon[i] = 0.5 * polygon[i] + 0.25 * (polygon[i - 1] + polygon[i + 1]);
    }
  }
  return polygon;
}

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

}  // namespace tcert::witness
