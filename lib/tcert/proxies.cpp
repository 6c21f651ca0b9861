#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>
#include <tcert/felt_clearance.hpp>
#include <tcert/proxies.hpp>

namespace tcert {
namespace {

constexpr double kSquare = 0.5 * std::numbers::pi;
// A ray at exactly 60 degrees is within 30 degrees of square, whatever the last bit says.
constexpr double kAngleRounding = 1e-9;
// sin 10 degrees: motion that is less off the heading is along it, for what is known of it.
constexpr double kLeastAcross = 0.17364817766693033;
// cos 30 degrees: motion further off the heading takes the side rays along, not square to it.
constexpr double kLeastAlong = 0.8660254037844386;

double side_window(const Robot& robot, const CertificateParameters& parameters) {
  return parameters.side_window_m > 0.0 ? parameters.side_window_m : robot.body_width_m;
}

}  // namespace

Proxies::Proxies(const Robot& robot, const CertificateParameters& parameters)
    : parameters_(parameters),
      half_width_m_(0.5 * robot.body_width_m),
      clearance_m_(robot.rays.size(), kMissing),
      look_window_m_(side_window(robot, parameters)),
      left_(side_window(robot, parameters), parameters.travel_deadband_m),
      right_(side_window(robot, parameters), parameters.travel_deadband_m),
      left_moving_(side_window(robot, parameters), parameters.travel_deadband_m),
      right_moving_(side_window(robot, parameters), parameters.travel_deadband_m),
      motion_(parameters.curvature_window_m, parameters.travel_deadband_m),
      contact_curvature_(robot.rays.size(), parameters) {
  double left_m = std::numeric_limits<double>::infinity();
  double right_m = left_m;
  double longest_m = half_width_m_;
  for (const Ray& ray : robot.rays) {
    RayState state;
    state.ray = ray;
    state.ray.reach_m = longest_clearance(ray);
    longest_m = std::max(longest_m, std::abs(ray.mount.y_m) + state.ray.reach_m);
    point(state, ray.bearing_rad);
    bearing_rad_.push_back(ray.bearing_rad);
    double& reach_m = state.side > 0 ? left_m : right_m;
    if (state.side != 0) {
      reach_m = std::min(reach_m, state.offset_m + state.ray.reach_m * state.across);
    }
    rays_.push_back(state);
  }
  reach_width_m_ = across_both(std::isinf(left_m) ? half_width_m_ : left_m,
                               std::isinf(right_m) ? half_width_m_ : right_m);
  widest_m_ = across_both(std::isinf(left_m) ? longest_m : left_m,
                          std::isinf(right_m) ? longest_m : right_m);
}

void Proxies::point(RayState& state, double bearing_rad) const noexcept {
  const double from_left = std::abs(angle_between(kSquare, bearing_rad));
  const double from_right = std::abs(angle_between(-kSquare, bearing_rad));
  const double within = parameters_.side_angle_rad + kAngleRounding;
  state.side = from_left <= within ? 1 : from_right <= within ? -1 : 0;
  state.offset_m = state.side < 0 ? -state.ray.mount.y_m : state.ray.mount.y_m;
  state.across = std::abs(elementary::sin(bearing_rad));
  state.ahead = direction(bearing_rad);
}

void Proxies::follow_joint(std::size_t ray, double bearing_rad) noexcept {
  if (bearing_rad != bearing_rad_[ray]) {
    bearing_rad_[ray] = bearing_rad;
    point(rays_[ray], bearing_rad);
    moves_ = true;
  }
}

// A ray that a joint moves looks to one side at a time: in between, the side is what it last felt
// there, for as far as a side is remembered.
double Proxies::since_look(Look& look,
                           double felt_m,
                           double travel_m,
                           double time_s) const noexcept {
  if (std::isfinite(felt_m)) {
    look = {felt_m, travel_m, time_s};
    return felt_m;
  }
  const bool is_recent = moves_ && !exceeds(travel_m - look.travel_m, look_window_m_);
  return is_recent && std::isfinite(look.side_m)
             ? look.side_m - parameters_.obstacle_speed_mps * (time_s - look.time_s)
             : half_width_m_;
}

void Proxies::clear() noexcept {
  restart_windows();
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    follow_joint(k, rays_[k].ray.bearing_rad);
    rays_[k].in_contact = false;
  }
  moves_ = false;
  std::fill(clearance_m_.begin(), clearance_m_.end(), kMissing);
}

void Proxies::restart_windows() noexcept {
  left_.clear();
  right_.clear();
  left_moving_.clear();
  right_moving_.clear();
  motion_.clear();
  contact_curvature_.clear();
  left_look_ = {};
  right_look_ = {};
  has_yaw_ = false;
  across_m_ = 0.0;
}

bool Proxies::feels_contact(const RayState& state,
                            double clearance_m,
                            double force_n) const noexcept {
  if (!std::isnan(force_n)) {
    return force_n >= (state.in_contact ? parameters_.contact_off_n : parameters_.contact_on_n);
  }
  return clearance_m < state.ray.reach_m - parameters_.contact_slack_m;
}

// Where obstacles move, each side by `u` at most, a reading loses worth with time.
double Proxies::trailing(TrailingMinimum& still,
                         TrailingAged& moving,
                         double side_m,
                         double travel_m,
                         double time_s) const noexcept {
  if (parameters_.obstacle_speed_mps == 0.0) {
    return still.add(travel_m, side_m);
  }
  const double lost_m = parameters_.obstacle_speed_mps * time_s;
  const double felt_m = side_m - parameters_.obstacle_speed_mps * parameters_.reading_age_s;
  return moving.add(travel_m, unwrapped_yaw_rad_, felt_m, lost_m);
}

double Proxies::across_both(double left_m, double right_m) const noexcept {
  return parameters_.clearance == ClearanceReading::radial ? 2.0 * std::min(left_m, right_m)
                                                           : left_m + right_m;
}

// Turning inside S is no evidence about the corridor: the window begins no earlier than the last
// tick there. A step is as long as what travel counts at once; one that turns points somewhere
// between its two headings, and one that turns about a point of the body is a turn on the spot.
TrailingMotion::Motion Proxies::follow(const Pose& pose,
                                       double travel_m,
                                       bool inside_start) noexcept {
  unwrapped_yaw_rad_ =
      has_yaw_ ? unwrapped_yaw_rad_ + angle_between(last_yaw_rad_, pose.yaw_rad) : 0.0;
  if (!has_yaw_) {
    counted_ = pose;
    counted_m_ = travel_m;
  } else if (travel_m > counted_m_) {
    const double half_turn_rad = 0.5 * angle_between(counted_.yaw_rad, pose.yaw_rad);
    const Point mean = direction(counted_.yaw_rad + half_turn_rad);
    const Point step = pose.position - counted_.position;
    const double askew_rad =
        elementary::atan2(std::abs(cross(mean, step)), std::abs(dot(mean, step)));
    if (norm(step) > 2.0 * std::abs(half_turn_rad) * half_width_m_) {
      across_m_ += norm(step) * elementary::sin(std::max(0.0, askew_rad - std::abs(half_turn_rad)));
    }
    counted_ = pose;
    counted_m_ = travel_m;
  }
  last_yaw_rad_ = pose.yaw_rad;
  has_yaw_ = true;
  if (inside_start) {
    motion_.clear();
  }
  return motion_.add({travel_m, unwrapped_yaw_rad_, across_m_});
}

// Cosine of the angle between motion and heading, in the mean of the steps, forwards and back; 1
// where it is small, or not known.
double Proxies::along_heading(const TrailingMotion::Motion& moved) const noexcept {
  if (!reaches(moved.travel_m, parameters_.curvature_min_travel_m) ||
      !exceeds(moved.across_m, kLeastAcross * moved.travel_m)) {
    return 1.0;
  }
  const double across = std::min(moved.across_m / moved.travel_m, 1.0);
  return std::sqrt(1.0 - across * across);
}

// 1 / max(|dpsi| / ds, epsilon) over the executed path.
double Proxies::path_radius(const TrailingMotion::Motion& moved, bool inside_start) const noexcept {
  const double straightest = parameters_.min_curvature_per_m;
  if (inside_start || !reaches(moved.travel_m, parameters_.curvature_min_travel_m)) {
    return 1.0 / straightest;
  }
  return 1.0 / std::max(std::abs(moved.yaw_rad) / moved.travel_m, straightest);
}

void Proxies::feel_contact(std::size_t ray,
                           const Tick& tick,
                           double travel_m,
                           double time_s,
                           ContactMemory& memory) noexcept {
  const double clearance_m = clearance_m_[ray];
  if (std::isnan(clearance_m)) {
    return;  // felt, but nobody knows where
  }
  const Point local = rays_[ray].ray.mount + clearance_m * rays_[ray].ahead;
  const Point point = transform(tick.pose, local);
  memory.add(point, tick.rays[ray].fsr_n, time_s);
  const Point ahead = direction(tick.pose.yaw_rad);
  contact_curvature_.add(ray, {point, local.y_m, {-ahead.y_m, ahead.x_m}, travel_m});
}

LocalGeometry Proxies::update(const Tick& tick,
                              double travel_m,
                              double time_s,
                              bool inside_start,
                              ContactMemory& memory) noexcept {
  LocalGeometry local;
  const TrailingMotion::Motion moved = follow(tick.pose, travel_m, inside_start);
  const double along = along_heading(moved);
  local.across_heading = along < 1.0;
  double left_m = std::numeric_limits<double>::infinity();
  double right_m = left_m;
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    RayState& state = rays_[k];
    follow_joint(k, bearing_of(state.ray, tick.rays[k].bearing_rad));
    clearance_m_[k] = felt_clearance(state.ray, tick.rays[k]);
    const bool missing = std::isnan(clearance_m_[k]);
    local.missing_ray = local.missing_ray || missing;
    if (state.side != 0) {
      double& side_m = state.side > 0 ? left_m : right_m;
      const double stated_m =
          missing ? half_width_m_ : state.offset_m + clearance_m_[k] * state.across;
      const double felt_m =
          reaches(along, kLeastAlong) ? along * stated_m : std::min(stated_m, half_width_m_);
      side_m = std::min(side_m, felt_m);
    }
    const bool contact = feels_contact(state, clearance_m_[k], tick.rays[k].fsr_n);
    local.contacts += contact ? 1U : 0U;
    local.new_contacts += contact && !state.in_contact ? 1U : 0U;
    state.in_contact = contact;
    if (contact) {
      feel_contact(k, tick, travel_m, time_s, memory);
    }
  }
  const double left_now_m = since_look(left_look_, left_m, travel_m, time_s);
  const double right_now_m = since_look(right_look_, right_m, travel_m, time_s);
  local.left_m = trailing(left_, left_moving_, left_now_m, travel_m, time_s);
  local.right_m = trailing(right_, right_moving_, right_now_m, travel_m, time_s);
  local.width_m = across_both(local.left_m, local.right_m);

  const double path_radius_m = path_radius(moved, inside_start);
  switch (parameters_.curvature) {
    case CurvatureReading::none:
      local.turn_radius_m = 1.0 / parameters_.min_curvature_per_m;
      break;
    case CurvatureReading::path:
      local.turn_radius_m = path_radius_m;
      break;
    case CurvatureReading::contact:
    case CurvatureReading::contact_literal:
      local.turn_radius_m =
          inside_start ? path_radius_m : contact_curvature_.radius(travel_m, path_radius_m);
      break;
  }
  return local;
}

}  // namespace tcert
