#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/elementary.hpp>
#include <tcert/footing.hpp>

namespace tcert {
namespace {

constexpr std::array kMembers{
    &Footing::pitch_rad, &Footing::roll_rad, &Footing::step_m, &Footing::slip};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Squared; 0 of what is missing.
double tangent2(double angle_rad) noexcept {
  if (std::isnan(angle_rad)) {
    return 0.0;
  }
  if (!(std::abs(angle_rad) < 0.5 * std::numbers::pi)) {
    return kInfinity;
  }
  const double tangent = elementary::tan(angle_rad);
  return tangent * tangent;
}

double slack(double value, double critical, double scale_m) noexcept {
  return std::isnan(value) ? kInfinity : scale_m * (1.0 - std::abs(value) / critical);
}

}  // namespace

double slope_of(const Footing& footing) noexcept {
  if (std::isnan(footing.pitch_rad) && std::isnan(footing.roll_rad)) {
    return kMissing;
  }
  const double pitch2 = tangent2(footing.pitch_rad);
  const double roll2 = tangent2(footing.roll_rad);
  if (std::isinf(pitch2) || std::isinf(roll2)) {
    return kInfinity;
  }
  return std::sqrt(pitch2 + roll2 + pitch2 * roll2);
}

double footing_slack(const Footing& footing,
                     const CertificateParameters& parameters,
                     double scale_m) noexcept {
  const double steepest =
      std::min(parameters.friction, parameters.track_width_m / (2.0 * parameters.centre_height_m));
  return std::min({slack(slope_of(footing), steepest, scale_m),
                   slack(footing.step_m, parameters.largest_step_m, scale_m),
                   slack(footing.slip, parameters.largest_slip, scale_m)});
}

bool is_measured(const Footing& footing) noexcept {
  return std::ranges::any_of(kMembers, [&](auto member) { return !std::isnan(footing.*member); });
}

void keep_worst(const Footing& now, Footing& worst) noexcept {
  for (double Footing::*const member : kMembers) {
    if (std::isfinite(now.*member) && !(std::abs(now.*member) <= std::abs(worst.*member))) {
      worst.*member = now.*member;
    }
  }
}

void keep_known(const Footing& now, Footing& last) noexcept {
  for (double Footing::*const member : kMembers) {
    if (std::isfinite(now.*member)) {
      last.*member = now.*member;
    }
  }
}

}  // namespace tcert
