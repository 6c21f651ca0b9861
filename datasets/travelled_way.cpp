#include "datasets/travelled_way.hpp"

#include <tcert/geometry.hpp>

namespace tcert {

std::vector<double> travelled_way(const TickTable& ticks) {
  constexpr double kCountedStepM = 0.01;
  std::vector<double> way_m(ticks.size(), 0.0);
  Point counted = ticks.size() > 0 ? ticks.poses.front().position : Point{};
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const Point here = ticks.poses[i].position;
    const double step_m = distance(counted, here);
    way_m[i] = way_m[i - 1];
    if (ticks.segment_start[i] != 0) {
      counted = here;
    } else if (step_m >= kCountedStepM) {
      way_m[i] += step_m;
      counted = here;
    }
  }
  return way_m;
}

}  // namespace tcert
