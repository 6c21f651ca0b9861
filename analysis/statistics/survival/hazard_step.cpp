#include <cmath>
#include <statistics/survival/hazard_step.hpp>

namespace tcert::statistics {

HazardStep nelson_aalen(double events, double at_risk) {
  return {
      events / at_risk, events / (at_risk * at_risk), 1.0 / at_risk, -events / (at_risk * at_risk)};
}

HazardStep fleming_harrington(double events, double at_risk, std::size_t rows) {
  HazardStep step;
  const auto m = static_cast<double>(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    const double part = static_cast<double>(k) / m;
    const double left = at_risk - part * events;
    step.hazard += events / m / left;
    step.variance += events / m / (left * left);
    step.by_event += 1.0 / m / left + events / m * part / (left * left);
    step.by_risk -= events / m / (left * left);
  }
  return step;
}

HazardStep product_limit(double events, double at_risk) {
  const double left = at_risk - events;
  return {-std::log1p(-events / at_risk),
          events / (at_risk * left),
          1.0 / left,
          -events / (at_risk * left)};
}

}  // namespace tcert::statistics
