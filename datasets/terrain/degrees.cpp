#include "datasets/terrain/degrees.hpp"

#include <algorithm>
#include <cmath>

namespace tcert::terrain_reading {

bool may_be_in_degrees(const TerrainGrid& terrain) {
  constexpr double kSmall = 0.01;
  const MapFrame& frame = terrain.frame;
  const int x = terrain.rows - 1;
  const int y = terrain.columns - 1;
  const auto within = [](double a, double b, double most) {
    return std::max(std::abs(a), std::abs(b)) <= most;
  };
  return frame.is_declared && std::max(frame.x_step, frame.y_step) < kSmall &&
         within(frame.first_of(0, 0), frame.first_of(x, y), 360.0) &&
         within(frame.second_of(0, 0), frame.second_of(x, y), 90.0);
}

}  // namespace tcert::terrain_reading
