#include <algorithm>
#include <utility>
#include <witness/polygon.hpp>
#include <witness/tried_polygon.hpp>

namespace tcert::witness {
namespace {

constexpr double kHope = 0.02;  // m, by which a finer band may be better

}  // namespace

void try_polygon(const std::vector<Point>& polygon,
                 const StretchOptions& options,
                 const BandProblem& problem,
                 const Checker& checker,
                 Found& found) {
  const Targets& targets = options.targets;
  Band band{polygon, 0.0};
  double best_m = -1.0;
  for (int level = 0; level < options.levels; ++level) {
    if (level > 0) {
      band.polygon = refined(band.polygon);
    }
    int budget = options.iterations / options.levels;
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
    Checked checked = checker.check(path, problem.start, problem.goal, problem.robot);
    if (!checked.refused.empty()) {
      found.reason = checked.refused;
    } else if (!found.witness || checked.margin_m > found.witness->checked.margin_m) {
      found.witness = Witness{std::move(path), std::move(checked)};
    }
  }
}

}  // namespace tcert::witness
