#include "analysis/study/rays/ray_curve.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace tcert::study {
namespace {

using Blocks = std::vector<statistics::IsotonicBlock>;

constexpr double kFarInErrors = 2.0;
constexpr double kRoundingOfValuesMetres = 1e-9;

/// Of a block: how far its value is from the line between two others, in m.
double distance_to_line(const Blocks& blocks, std::size_t from, std::size_t to, std::size_t at) {
  const double share =
      (blocks[at].mean_x - blocks[from].mean_x) / (blocks[to].mean_x - blocks[from].mean_x);
  const double line = blocks[from].value + share * (blocks[to].value - blocks[from].value);
  return std::abs(blocks[at].value - line);
}

/// The blocks that become knots, in order.
std::vector<std::size_t> knots_among(const Blocks& blocks,
                                     double residual_m,
                                     std::size_t most_knots) {
  std::set<std::size_t> knots{0, blocks.size() - 1};
  while (knots.size() < most_knots) {
    std::size_t furthest = 0;
    double most = std::max(kFarInErrors * residual_m, kRoundingOfValuesMetres);
    for (auto knot = knots.begin(); std::next(knot) != knots.end(); ++knot) {
      for (std::size_t at = *knot + 1; at < *std::next(knot); ++at) {
        const double weight = std::sqrt(static_cast<double>(blocks[at].rows));
        const double far = weight * distance_to_line(blocks, *knot, *std::next(knot), at);
        if (far > most) {
          most = far;
          furthest = at;
        }
      }
    }
    if (furthest == 0) {
      break;
    }
    knots.insert(furthest);
  }
  return {knots.begin(), knots.end()};
}

}  // namespace

RayCurve fit_ray_curve(std::span<const double> bend_rad,
                       std::span<const double> clearance_m,
                       std::size_t most_knots) {
  const statistics::IsotonicFit fit = statistics::isotonic_fit(bend_rad, clearance_m);
  RayCurve curve;
  curve.trend = fit.trend;
  curve.pairs = bend_rad.size();
  curve.residual_m = std::sqrt(fit.squares / static_cast<double>(curve.pairs));
  for (const std::size_t knot : knots_among(fit.blocks, curve.residual_m, most_knots)) {
    curve.calibration.bend_rad.push_back(fit.blocks[knot].mean_x);
    curve.calibration.clearance_m.push_back(fit.blocks[knot].value);
  }
  for (const double bend : bend_rad) {
    const double thinned = calibrated_clearance(curve.calibration, bend);
    curve.thinning_m = std::max(curve.thinning_m, std::abs(thinned - fit.at(bend)));
  }
  return curve;
}

Calibration lowered(const Calibration& curve, double by_m) {
  Calibration low;
  const auto add = [&](double bend, double clearance) {
    if (low.bend_rad.empty() || bend > low.bend_rad.back()) {
      low.bend_rad.push_back(bend);
      low.clearance_m.push_back(clearance);
    }
  };
  double before = 0.0;
  for (std::size_t i = 0; i < curve.bend_rad.size(); ++i) {
    const double bend = curve.bend_rad[i];
    const double here = curve.clearance_m[i] - by_m;
    if (i > 0 && (before > 0.0) != (here > 0.0)) {
      const double share = before / (before - here);
      add(curve.bend_rad[i - 1] + share * (bend - curve.bend_rad[i - 1]), 0.0);
    }
    if (here > 0.0) {
      add(bend, here);
    }
    before = here;
  }
  if (low.bend_rad.empty()) {
    add(curve.bend_rad.front(), 0.0);
  }
  return low;
}

}  // namespace tcert::study
