#include <algorithm>
#include <cmath>
#include <tcert/felt_clearance.hpp>
#include <tcert/felt_rays.hpp>

namespace tcert::policies {

double ray_bearing(const Ray& ray, const RayReading& reading) noexcept {
  return bearing_of(ray, reading.bearing_rad);
}

RayReader::RayReader(const Robot& robot, const CertificateParameters& parameters)
    : rays_(robot.rays),
      felt_(robot.rays.size()),
      contact_on_n_(parameters.contact_on_n),
      contact_off_n_(parameters.contact_off_n),
      contact_slack_m_(parameters.contact_slack_m) {
  for (Ray& ray : rays_) {
    ray.reach_m = std::max(longest_clearance(ray), 0.0);
  }
}

void RayReader::reset() noexcept { std::fill(felt_.begin(), felt_.end(), FeltRay{}); }

std::span<const FeltRay> RayReader::read(std::span<const RayReading> readings) noexcept {
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const Ray& ray = rays_[i];
    const RayReading reading = i < readings.size() ? readings[i] : RayReading{};
    FeltRay& felt = felt_[i];
    felt.mount = ray.mount;
    felt.ahead = unit(ray_bearing(ray, reading));
    felt.force_n = reading.fsr_n;
    felt.clearance_m = felt_clearance(ray, reading);
    felt.depth = (ray.reach_m - felt.clearance_m) / ray.reach_m;  // NaN of a missing one
    felt.contact = std::isnan(felt.force_n)
                       ? felt.clearance_m < ray.reach_m - contact_slack_m_
                       : felt.force_n >= (felt.contact ? contact_off_n_ : contact_on_n_);
  }
  return felt_;
}

double deepest(std::span<const FeltRay> rays) noexcept {
  double largest = 0.0;
  for (const FeltRay& ray : rays) {
    largest = std::fmax(largest, ray.depth);
  }
  return largest;
}

double left_excess(std::span<const FeltRay> rays) noexcept {
  double excess = 0.0;
  for (const FeltRay& ray : rays) {
    excess += std::isnan(ray.depth) ? 0.0 : exact_term(ray.depth * ray.ahead.y_m);
  }
  return excess;
}

double frontal_force(std::span<const FeltRay> rays, double least_cosine) noexcept {
  double largest = kMissing;
  for (const FeltRay& ray : rays) {
    if (ray.ahead.x_m >= least_cosine) {
      largest = std::fmax(largest, ray.force_n);
    }
  }
  return largest;
}

}  // namespace tcert::policies
