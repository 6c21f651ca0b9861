#include "analysis/study/h3/pareto.hpp"

#include <algorithm>
#include <cmath>

namespace tcert::study {

std::vector<bool> pareto_front(std::span<const GainAndRetention> points) {
  std::vector<bool> front;
  for (const GainAndRetention& point : points) {
    const bool known = !std::isnan(point.gain) && !std::isnan(point.retention);
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const GainAndRetention& by) {
      return by.gain >= point.gain && by.retention >= point.retention &&
             (by.gain > point.gain || by.retention > point.retention);
    });
    front.push_back(known && !beaten);
  }
  return front;
}

}  // namespace tcert::study
