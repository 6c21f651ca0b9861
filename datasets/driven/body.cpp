#include "datasets/driven/body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tcert/mirror_exact.hpp>

#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

double within(double value, double most) noexcept {
  return std::isfinite(value) ? std::clamp(value, -most, most) : 0.0;
}

constexpr double kTouching = 1e-7;  // m
constexpr double kTreading = 0.05;  // m/s

/// Normal of a wall when a body at `velocity` touches it, if it does within `seconds`. An edge
/// keeps its normal; round a corner or a disc the body's middle is `radius_m` from the centre then.
/// A wall that is touched already counts even if the body does not press on it: sliding along
/// another it may.
std::optional<Point> touching_normal(const Contact& contact,
                                     double radius_m,
                                     Point velocity,
                                     double seconds) noexcept {
  if (contact.gap_m <= kTouching) {
    return contact.normal;
  }
  const double closing = -dot(contact.normal, velocity);
  if (closing <= 0.0) {
    return std::nullopt;
  }
  if (std::isinf(radius_m)) {
    return closing * seconds >= contact.gap_m ? std::optional(contact.normal) : std::nullopt;
  }
  // |from + t velocity| = radius, the earlier of the two.
  const Point from = (radius_m + contact.gap_m) * contact.normal;
  const double towards = -dot(from, velocity);
  const double beyond2 = contact.gap_m * (2.0 * radius_m + contact.gap_m);
  const double root2 = towards * towards - dot(velocity, velocity) * beyond2;
  if (root2 < 0.0) {
    return std::nullopt;
  }
  const double time = beyond2 / (towards + std::sqrt(root2));
  return time <= seconds ? std::optional((1.0 / radius_m) * (from + time * velocity))
                         : std::nullopt;
}

}  // namespace

double RateLimited::advance(double target, double rate, double seconds) noexcept {
  const double lacking = target - value_;
  const double ramp_s = std::min(std::abs(lacking) / rate, seconds);
  const double end = ramp_s < seconds ? target : value_ + std::copysign(rate * seconds, lacking);
  const double mean = end + 0.5 * (ramp_s / seconds) * (value_ - end);
  value_ = end;
  return mean;
}

Body::Body(const DriveParameters& parameters,
           const WallIndex& walls,
           double radius_m,
           const Pose& start,
           std::span<const ReliefPatch> relief) noexcept
    : parameters_(parameters), walls_(walls), radius_m_(radius_m), relief_(relief), pose_(start) {}

void Body::advance(double seconds, const policies::Command& command) noexcept {
  const double speed = speed_.advance(within(command.speed_mps, parameters_.most_speed_mps),
                                      parameters_.acceleration_mps2,
                                      seconds);
  double most_yaw_rate = parameters_.most_yaw_rate_rps;
  if (parameters_.turn_radius_m > 0.0) {
    most_yaw_rate = std::min(most_yaw_rate, std::abs(speed) / parameters_.turn_radius_m);
  }
  const double yaw_rate = std::clamp(
      yaw_rate_.advance(
          within(command.yaw_rate_rps, most_yaw_rate), parameters_.yaw_acceleration_rps2, seconds),
      -most_yaw_rate,
      most_yaw_rate);
  const double turn = yaw_rate * seconds;
  const Point heading = policies::unit(pose_.yaw_rad + 0.5 * turn);
  const double lost =
      relief_.empty()
          ? 0.0
          : tread_loss(relief_, pose_.position, std::copysign(1.0, speed) * heading, parameters_);
  const Point velocity = held_back((1.0 - lost) * speed * heading, seconds);
  slip_ = std::abs(speed) > kTreading && hold_.force_n == 0.0 ? lost : kMissing;
  forward_mps_ = dot(velocity, heading);
  speed_mps_ = norm(velocity);
  const double way = seconds * speed_mps_;
  travelled_m_ += way;
  clear_m_ -= way;
  pose_.position = pose_.position + seconds * velocity;
  pose_.yaw_rad = wrapped_angle(pose_.yaw_rad + turn);
}

Point Body::held_back(Point velocity, double seconds) noexcept {
  hold_ = {};
  if (norm(velocity) * seconds <= clear_m_) {
    return velocity;
  }
  look_around(velocity, seconds);
  if (crowded_) {
    hold_ = hold_by(velocity);
    return {};
  }
  const std::span<const Contact> touched = std::span(touched_).first(touched_count_);
  const Point slide = nearest_allowed(velocity, touched, 0.0);
  hold_ = hold_by(velocity - slide);
  const double along = norm(slide);
  const double rubbed = parameters_.friction * hold_.force_n / parameters_.contact_damping;
  const Point left = along > 0.0 ? velocity - (std::min(rubbed, along) / along) * slide : velocity;
  return nearest_allowed(left, std::span(near_).first(near_count_), 1.0 / seconds);
}

Hold Body::hold_by(Point taken) const noexcept {
  const double press = norm(taken);
  if (press <= 0.0) {
    return {};
  }
  const double standing = std::min(press / parameters_.onset_mps, 1.0);
  return {parameters_.contact_damping * press + parameters_.standing_force_n * standing,
          (1.0 / press) * taken};
}

void Body::look_around(Point velocity, double seconds) noexcept {
  const double reach = norm(velocity) * seconds;
  near_count_ = 0;
  touched_count_ = 0;
  crowded_ = false;
  clear_m_ = std::min(walls_.distance_from(pose_.position), kSensingRange) - radius_m_;
  if (clear_m_ >= reach) {
    return;
  }
  std::array<NearWall, kMostContacts> walls{};
  const std::size_t found = walls_.walls_within(pose_.position, radius_m_ + reach, walls);
  crowded_ = found > walls.size();
  for (std::size_t i = 0; i < std::min(found, walls.size()); ++i) {
    const Point out = pose_.position - walls[i].nearest;
    const Contact contact{(1.0 / norm(out)) * out, std::max(walls[i].distance_m - radius_m_, 0.0)};
    near_[near_count_++] = contact;
    if (const auto normal =
            touching_normal(contact, radius_m_ + walls[i].radius_m, velocity, seconds)) {
      touched_[touched_count_++] = {*normal, 0.0};
    }
  }
}

}  // namespace tcert
