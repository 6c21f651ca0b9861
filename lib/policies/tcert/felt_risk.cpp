#include <algorithm>
#include <cmath>
#include <tcert/felt_risk.hpp>
#include <utility>

namespace tcert::policies {

FeltRisk::FeltRisk(const PolicySetup& setup)
    : field_(setup.risk),
      weight_m_(setup.parameters.lambda_weight * setup.robot.body_width_m),
      ahead_m_(setup.risk.ahead_m),
      half_width_m_(0.5 * setup.robot.body_width_m),
      every_(static_cast<std::uint32_t>(
          std::max(1.0, std::round(setup.parameters.memory_period_s / setup.control_period_s)))) {
  validate(setup.risk, setup.robot);
}

void FeltRisk::reset() noexcept {
  field_.clear();
  step_ = 0;
  began_ = false;
  time_s_ = 0.0;
}

void FeltRisk::take(const BodyFrame& body,
                    std::span<const FeltRay> rays,
                    std::int64_t time_ns) noexcept {
  if (!std::exchange(began_, true)) {
    first_ns_ = time_ns;
  }
  time_s_ = std::max(time_s_, elapsed_s(first_ns_, time_ns));
  if (step_++ % every_ != 0) {
    return;
  }
  for (const FeltRay& ray : rays) {
    if (!std::isnan(ray.clearance_m)) {
      field_.observe_ray(body.to_odometry(ray.mount),
                         body.turned(ray.ahead),
                         ray.clearance_m,
                         ray.contact,
                         time_s_);
    }
  }
  field_.observe_body(body.origin, half_width_m_, time_s_);
}

void FeltRisk::add_cost(HeadingCosts& costs, const BodyFrame& body) const noexcept {
  for (int k = HeadingCosts::kLowest; k <= HeadingCosts::kHighest; ++k) {
    const Point ahead = body.turned(HeadingCosts::heading(k));
    costs.add(k, weight_m_ * field_.integral_along(body.origin, ahead, ahead_m_, time_s_));
  }
}

}  // namespace tcert::policies
