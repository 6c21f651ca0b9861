#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tcert/felt_clearance.hpp>
#include <tcert/felt_points.hpp>
#include <tcert/lengths.hpp>

namespace tcert {
namespace {

/// Rays within this of the heading look ahead.
constexpr double kAhead = std::numbers::pi / 12.0;

}  // namespace

FeltPoints::FeltPoints(const Robot& robot, const CertificateParameters& parameters)
    : rays_(robot.rays),
      half_width_m_(0.5 * robot.body_width_m),
      window_m_(robot.body_width_m),
      slack_m_(parameters.contact_slack_m) {
  for (const Ray& ray : rays_) {
    longest_m_.push_back(longest_clearance(ray));
  }
  const std::size_t stops =
      static_cast<std::size_t>(robot.body_width_m / parameters.travel_deadband_m) + 3;
  stops_.resize(stops);
  points_.resize(stops * std::max<std::size_t>(rays_.size(), 1));
}

void FeltPoints::clear() noexcept {
  first_ = size_ = 0;
  front_m_ = 0.0;
}

void FeltPoints::add(const Tick& tick, double travel_m) noexcept {
  const auto at = [&](std::size_t i) noexcept { return (first_ + i) % stops_.size(); };
  while (size_ > 0 && exceeds(travel_m - stops_[first_].travel_m, window_m_)) {
    first_ = at(1);
    --size_;
  }
  if (size_ == 0 || stops_[at(size_ - 1)].travel_m < travel_m) {
    if (size_ == stops_.size()) {
      first_ = at(1);
      --size_;
    }
    stops_[at(size_)] = {travel_m, at(size_) * std::max<std::size_t>(rays_.size(), 1), 0};
    ++size_;
  }
  Stop& stop = stops_[at(size_ - 1)];
  stop.count = 0;
  double front_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rays_.size() && k < tick.rays.size(); ++k) {
    const Ray& ray = rays_[k];
    const double clear_m = felt_clearance(ray, tick.rays[k]);
    const double bearing_rad = bearing_of(ray, tick.rays[k].bearing_rad);
    if (std::abs(bearing_rad) <= kAhead) {
      const double reaches_m = ray.mount.x_m + clear_m * direction(bearing_rad).x_m - half_width_m_;
      front_m = std::min(front_m, std::isnan(reaches_m) ? 0.0 : reaches_m);
    }
    if (clear_m < longest_m_[k] - slack_m_) {
      const Point tip = ray.mount + clear_m * direction(bearing_rad);
      points_[stop.slot + stop.count++] = transform(tick.pose, tip);
    }
  }
  front_m_ = std::isfinite(front_m) ? std::max(front_m, 0.0) : 0.0;
}

double FeltPoints::free_way_m(const Pose& pose, double most_m) const noexcept {
  const Point heading = direction(pose.yaw_rad);
  double least_m = most_m;
  for (std::size_t i = 0; i < size_; ++i) {
    const Stop& stop = stops_[(first_ + i) % stops_.size()];
    for (std::size_t k = 0; k < stop.count; ++k) {
      const Point away = points_[stop.slot + k] - pose.position;
      const double across_m = cross(heading, away);
      const double along_m = dot(heading, away);
      if (along_m > 0.0 && std::abs(across_m) < half_width_m_) {
        const double meets_m =
            along_m - std::sqrt(half_width_m_ * half_width_m_ - across_m * across_m);
        least_m = std::min(least_m, std::max(meets_m, 0.0));
      }
    }
  }
  return least_m;
}

FeltPoints::Nearest FeltPoints::nearest(Point to) const noexcept {
  Nearest found;
  for (std::size_t i = 0; i < size_; ++i) {
    const Stop& stop = stops_[(first_ + i) % stops_.size()];
    for (std::size_t k = 0; k < stop.count; ++k) {
      const Point point = points_[stop.slot + k];
      const double distance_m = distance(point, to);
      if (found.count == kNearest && !(distance_m < found.distances_m[kNearest - 1])) {
        continue;
      }
      std::size_t place = found.count < kNearest ? found.count++ : kNearest - 1;
      for (; place > 0 && distance_m < found.distances_m[place - 1]; --place) {
        found.points[place] = found.points[place - 1];
        found.distances_m[place] = found.distances_m[place - 1];
      }
      found.points[place] = point;
      found.distances_m[place] = distance_m;
    }
  }
  return found;
}

}  // namespace tcert
