#include "support/lap.hpp"

#include <cmath>
#include <numbers>

namespace tcert::test_support {

Lap make_lap(std::size_t nodes) {
  constexpr double kStep_m = 0.017;
  Lap lap;
  const double square = 0.5 * std::numbers::pi;
  lap.robot.rays = {{"left", {0.2, 0.1}, square, 0.7, RayKind::range, {}},
                    {"right", {0.2, -0.1}, -square, 0.7, RayKind::range, {}},
                    {"ahead", {0.3, 0.0}, 0.0, 0.5, RayKind::range, {}}};
  const double length_m = 0.25 * static_cast<double>(nodes);
  const double radius_m = length_m / (2.0 * std::numbers::pi);
  const auto steps = static_cast<std::size_t>(length_m / kStep_m);
  for (std::size_t k = 0; k < steps; ++k) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(steps);
    lap.poses.push_back({radius_m * Point{std::sin(a), 1.0 - std::cos(a)}, a});
  }
  lap.course.start = Disc{lap.poses[0].position, 0.3};
  lap.course.goal = Disc{lap.poses[steps / 2].position, 0.3};
  return lap;
}

}  // namespace tcert::test_support
