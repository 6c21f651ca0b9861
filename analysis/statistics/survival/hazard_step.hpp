#pragma once
/// \file
/// What the events of a time add to a cumulative hazard. Internal to survival_curve.cpp.

#include <cstddef>

namespace tcert::statistics {

/// Change of a cumulative hazard by the events of a time and its derivatives: by the weight of a
/// row that has its event then, and by that of one that is at risk.
struct HazardStep {
  double hazard = 0.0;
  double variance = 0.0;
  double by_event = 0.0;
  double by_risk = 0.0;
};

[[nodiscard]] HazardStep nelson_aalen(double events, double at_risk);

/// As if the `rows` events, of the same weight each, came one after another.
[[nodiscard]] HazardStep fleming_harrington(double events, double at_risk, std::size_t rows);

/// The same of -log of the product-limit estimate.
[[nodiscard]] HazardStep product_limit(double events, double at_risk);

}  // namespace tcert::statistics
