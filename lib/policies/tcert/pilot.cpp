#include <algorithm>
#include <cmath>
#include <tcert/elementary.hpp>
#include <tcert/pilot.hpp>

namespace tcert::policies {
namespace {

const PolicySetup& validated(const PolicySetup& setup) {
  validate(setup);
  return setup;
}

bool usable(const Pose& pose) noexcept {
  return std::abs(pose.position.x_m) <= kLargestPose &&
         std::abs(pose.position.y_m) <= kLargestPose && std::abs(pose.yaw_rad) <= kLargestPose;
}

}  // namespace

Pilot::Pilot(const PolicySetup& setup)
    : parameters_(validated(setup).parameters),
      half_width_m_(0.5 * setup.robot.body_width_m),
      min_turn_radius_m_(setup.robot.min_turn_radius_m),
      front_cosine_(elementary::cos(parameters_.front_rad)),
      reader_(setup.robot, setup.certificate),
      line_(setup.line, parameters_.lookahead_m),
      recovery_(parameters_, min_turn_radius_m_, setup.control_period_s) {
  if (parameters_.lambda_weight > 0.0) {
    risk_.emplace(setup);
  }
}

void Pilot::reset() noexcept {
  reader_.reset();
  line_.reset();
  recovery_.reset();
  if (risk_) {
    risk_->reset();
  }
  side_ = 1;
  give_up_ = false;
  last_speed_mps_ = 0.0;
}

std::optional<Command> Pilot::begin(const Senses& senses, Outlook& now) noexcept {
  const Pose& pose = senses.tick.pose;
  if (senses.tick.stale || !usable(pose)) {
    return command({});
  }
  now.body = BodyFrame::of(pose);
  now.yaw_rad = pose.yaw_rad;
  now.rays = reader_.read(senses.tick.rays);
  now.depth = deepest(now.rays);
  if (risk_) {
    risk_->take(now.body, now.rays, senses.tick.time_ns);
  }
  if (senses.bump && std::isfinite(senses.bump->bearing_rad)) {
    now.bump = now.body.to_odometry(half_width_m_ * unit(senses.bump->bearing_rad));
  }
  const Point carrot = now.body.to_body(line_.carrot(pose.position, senses.goal));
  now.bearing_rad = bearing_of(carrot);
  if (!std::isfinite(now.bearing_rad)) {
    return command({});
  }
  const int fuller = sign_of(left_excess(now.rays));
  if (carrot.y_m != 0.0) {
    side_ = sign_of(carrot.y_m);
  } else if (fuller != 0) {
    side_ = -fuller;
  }
  now.side = side_;
  const double commanded_mps =
      std::isfinite(senses.commanded_mps) ? senses.commanded_mps : last_speed_mps_;
  const auto recovering = recovery_.step(pose,
                                         {frontal_force(now.rays, front_cosine_), senses.bump},
                                         fuller != 0 ? -fuller : side_,
                                         commanded_mps);
  now.gave_up = recovery_.gives_up() || give_up_;
  give_up_ = false;
  if (now.gave_up) {
    line_.give_up_lane();
  }
  now.held_turn_rad = recovery_.held_turn(pose);
  now.whole = true;
  return recovering ? std::optional(command(*recovering)) : std::nullopt;
}

double Pilot::cautious_speed(double depth) const noexcept {
  return parameters_.cruise_mps * (1.0 - parameters_.caution * depth);
}

double Pilot::largest_yaw_rate(double speed_mps) const noexcept {
  return min_turn_radius_m_ > 0.0
             ? std::min(parameters_.max_yaw_rate_rps, speed_mps / min_turn_radius_m_)
             : parameters_.max_yaw_rate_rps;
}

Command Pilot::steer(const Outlook& now, double turn_rad, double speed_mps) noexcept {
  const double turn = now.sided(turn_rad);
  const double onward = std::fmax(0.0, elementary::cos(std::abs(turn)));
  return drive(min_turn_radius_m_ > 0.0 ? speed_mps : speed_mps * onward,
               parameters_.heading_gain_per_s * turn);
}

Command Pilot::drive(double speed_mps, double yaw_rate_rps) noexcept {
  const double speed = std::clamp(speed_mps, 0.0, parameters_.cruise_mps);
  const double largest_rps = largest_yaw_rate(speed);
  return command({speed, std::clamp(yaw_rate_rps, -largest_rps, largest_rps)});
}

// Adding 0 turns -0 into 0.
Command Pilot::command(const Command& command) noexcept {
  last_speed_mps_ = command.speed_mps;
  return {command.speed_mps + 0.0, command.yaw_rate_rps + 0.0};
}

}  // namespace tcert::policies
