#include <limits>
#include <tcert/tracking_bound.hpp>

namespace tcert {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

}  // namespace

double tracking_radius_m(const DoubleIntegrator& model, double speed_mps) noexcept {
  const double left_mps2 = model.braking_mps2 - model.disturbance_mps2;
  if (!(left_mps2 > 0.0) || !(speed_mps >= 0.0)) {
    return kNoBound;
  }
  const double pushed = speed_mps + model.disturbance_mps;
  const double strayed = model.exploring_mps * (2.0 * speed_mps + 0.5 * model.exploring_mps);
  return (pushed * pushed + strayed) / left_mps2;
}

double tracking_hold_s(const DoubleIntegrator& model, double speed_left_mps) noexcept {
  const double left_mps2 = model.braking_mps2 - model.disturbance_mps2;
  if (!(left_mps2 > 0.0) || !(speed_left_mps >= 0.0)) {
    return kNoBound;
  }
  return (speed_left_mps + model.disturbance_mps) / left_mps2;
}

}  // namespace tcert
