#include "analysis/study/gate/gate_pass.hpp"

#include <algorithm>
#include <cmath>

namespace tcert::study {

GatePass gate_pass(std::span<const CertifiedTick> series, double approach_m) {
  GatePass pass;
  double gate_travel_m = 0.0;
  for (const CertifiedTick& tick : series) {
    if (!std::isnan(tick.margin_m) && (!pass.bottleneck_m || tick.margin_m < *pass.bottleneck_m)) {
      pass.bottleneck_m = tick.margin_m;
      gate_travel_m = tick.travel_m;
    }
  }
  for (const CertifiedTick& tick : series) {
    if (!std::isnan(tick.margin_m) && tick.travel_m < gate_travel_m - approach_m) {
      const double value_m = series_value(tick);
      pass.before_m = pass.before_m ? std::min(*pass.before_m, value_m) : value_m;
    }
  }
  return pass;
}

}  // namespace tcert::study
