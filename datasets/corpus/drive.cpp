#include "datasets/corpus/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/path_pursuit.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr double kSpeedLag = 0.25;        // s
constexpr double kSpeedWanderSd = 0.05;   // of the logarithm
constexpr double kSpeedWanderTime = 2.0;  // s
constexpr double kHeadingTime = 0.4;      // s
constexpr double kTrialSpeedSd = 0.03;    // of the logarithm
constexpr double kCreep = 0.08;           // m/s, backing off and pushing
constexpr double kCloseContact = 0.30;    // m of clearance: felt in gates, not off a lane's walls
constexpr double kDepthCaution = 0.40;    // share of speed given up per share of that taken away
constexpr double kTypicalDepth = 0.50;    // in a gate: both kinds of caution cost the same there
constexpr double kStuckTime = 1.5;        // s
constexpr double kStuckTravel = 0.012;    // m
constexpr double kStopInside = 0.12;      // m driven inside G
constexpr double kStand = 1.0;            // s stood inside G
constexpr std::size_t kLateral = 2;

/// Exponentially correlated noise of unit variance.
class Wander {
 public:
  explicit Wander(double time_s)
      : keep_(elementary::exp(-kDriveStep / time_s)), add_(std::sqrt(1.0 - keep_ * keep_)) {}
  double next(table::RandomStream& random) noexcept {
    value_ = keep_ * value_ + add_ * random.normal();
    return value_;
  }

 private:
  double keep_;
  double add_;
  double value_ = 0.0;
};

class Driver {
 public:
  Driver(const DrivePlan& plan, const WallIndex& walls, table::RandomStream random)
      : plan_(plan), walls_(walls), random_(random), pose_(plan.start) {
    trial_speed_ = elementary::exp(kTrialSpeedSd * random_.normal());
    stand_until_ = random_.uniform(0.3, 1.0);
    patience_ = random_.uniform(5.0, 12.0);
  }

  Drive run() {
    while (drive_.end_reason == EndReason::unknown) {
      step();
    }
    return std::move(drive_);
  }

 private:
  [[nodiscard]] double now() const noexcept {
    return kDriveStep * static_cast<double>(drive_.poses.size());
  }

  void step() {
    feel();
    const double speed = commanded_speed();
    const bool reverse = backing_ ? true : plan_.legs[leg_].reverse;
    const double curvature = commanded_curvature(reverse);
    drive_.poses.push_back(pose_);
    drive_.speed_cmd_mps.push_back(reverse ? -speed : speed);
    drive_.yaw_rate_cmd_rps.push_back(speed * curvature);
    move(speed, curvature, reverse);
    watch_goal();
    watch_progress(speed);
    watch_clock();
  }

  void feel() noexcept {
    const auto clearances = cast_tentacles(walls_, pose_);
    bool touching = false;
    deepest_ = 0.0;
    for (std::size_t k = 0; k < kLateral; ++k) {
      touching = touching || clearances[k] < kCloseContact;
      deepest_ = std::max(deepest_, 1.0 - clearances[k] / kCloseContact);
    }
    if (touching && !touching_ && random_.uniform() < plan_.policy.pause) {
      stand_until_ = now() + random_.uniform(0.3, 1.5);
    }
    touching_ = touching;
  }

  double commanded_speed() noexcept {
    const double wander = elementary::exp(kSpeedWanderSd * speed_wander_.next(random_));
    if (now() < stand_until_ || arrived_) {
      return 0.0;
    }
    if (backing_ || stuck_since_ >= 0.0) {
      return kCreep;
    }
    double caution = touching_ ? plan_.policy.caution : 0.0;
    if (touching_) {
      caution += plan_.graded_caution * kDepthCaution * (deepest_ - kTypicalDepth);
    }
    return trial_speed_ * wander * plan_.policy.cruise_mps * (1.0 - std::clamp(caution, 0.0, 0.6));
  }

  double commanded_curvature(bool reverse) noexcept {
    Pose facing = pose_;
    if (reverse) {
      facing.yaw_rad += std::numbers::pi;
    }
    const auto& path = backing_ ? back_path_ : plan_.legs[leg_].path;
    PathProgress& progress = backing_ ? back_progress_ : progress_;
    return pursuit_curvature(facing, progress.target(path, pose_.position));
  }

  void move(double speed, double curvature, bool reverse) noexcept {
    speed_ += (speed - speed_) * (1.0 - elementary::exp(-kDriveStep / kSpeedLag));
    const double noise = plan_.policy.heading_noise_per_m * heading_wander_.next(random_);
    const double ds = speed_ * kDriveStep;
    const double turn = ds * (curvature + noise);
    const double middle = pose_.yaw_rad + 0.5 * turn + (reverse ? std::numbers::pi : 0.0);
    const Point wanted = pose_.position + ds * direction(middle);
    const auto [moved, is_free] = walls_.pushed_out(wanted, plan_.body_radius_m);
    if (is_free) {
      travelled_ += distance(pose_.position, moved);
      pose_.position = moved;
    }
    pose_.yaw_rad = wrapped_angle(pose_.yaw_rad + turn);
  }

  void watch_goal() noexcept {
    const bool inside = contains(plan_.goal, pose_.position);
    if (inside && entered_ < 0.0) {
      entered_ = now();
      entered_travel_ = travelled_;
    }
    if (inside && !arrived_ && travelled_ - entered_travel_ >= kStopInside) {
      arrived_ = true;
      arrived_at_ = now();
    }
    if (arrived_ && now() >= arrived_at_ + 3.0 * kSpeedLag + kStand) {
      finish(EndReason::goal, entered_, entered_travel_);
    }
  }

  void watch_progress(double speed) {
    if (arrived_) {
      return;
    }
    if (backing_) {
      if (back_progress_.finished(back_path_) || now() > backing_until_) {
        backing_ = false;
        stand_until_ = now() + random_.uniform(0.5, 2.0);
        restart_watch();
      }
      return;
    }
    if (progress_.finished(plan_.legs[leg_].path) && leg_ + 1 < plan_.legs.size()) {
      ++leg_;
      progress_.restart();
      stand_until_ = now() + 0.3;
    }
    if (speed <= 0.0 || distance(pose_.position, watched_) > kStuckTravel) {
      restart_watch();
      return;
    }
    if (stuck_since_ < 0.0 && now() - watched_at_ > kStuckTime) {
      stuck_since_ = now();
    }
    if (stuck_since_ >= 0.0) {
      be_stuck();
    }
  }

  void restart_watch() noexcept {
    watched_ = pose_.position;
    watched_at_ = now();
    stuck_since_ = -1.0;
  }

  void be_stuck() {
    const double since = now() - stuck_since_;
    if (plan_.when_stuck == EndReason::timeout) {
      if (since > 2.0) {
        back_off();
      }
    } else if (since > (plan_.when_stuck == EndReason::collision ? 0.5 : patience_)) {
      finish(plan_.when_stuck, now(), travelled_);
    }
  }

  /// Backs along the way it came for 0.25 to 0.5 m.
  void back_off() {
    const double back = random_.uniform(0.25, 0.50);
    back_path_.clear();
    double length = 0.0;
    for (std::size_t i = drive_.poses.size(); i > 1 && length < back; --i) {
      const Point p = drive_.poses[i - 1].position;
      const double gap = back_path_.empty() ? 0.0 : distance(back_path_.back(), p);
      if (back_path_.empty() || gap >= kPathStep) {
        back_path_.push_back(p);
        length += gap;
      }
    }
    backing_ = true;
    backing_until_ = now() + 2.0 * back / kCreep;
    back_progress_.restart();
    progress_.restart();
    stuck_since_ = -1.0;
  }

  void watch_clock() noexcept {
    if (drive_.end_reason == EndReason::unknown && now() >= plan_.time_limit_s) {
      finish(EndReason::timeout, now(), travelled_);
    }
  }

  void finish(EndReason reason, double time, double travelled) noexcept {
    drive_.end_reason = reason;
    drive_.time_s = std::round(time * 1e3) / 1e3;
    drive_.distance_m = std::round(travelled * 1e4) / 1e4;
  }

  const DrivePlan& plan_;
  const WallIndex& walls_;
  table::RandomStream random_;
  Drive drive_;

  Pose pose_;
  double speed_ = 0.0;
  double travelled_ = 0.0;
  double trial_speed_ = 1.0;
  Wander speed_wander_{kSpeedWanderTime};
  Wander heading_wander_{kHeadingTime};

  std::size_t leg_ = 0;
  PathProgress progress_;
  bool backing_ = false;
  std::vector<Point> back_path_;
  PathProgress back_progress_;
  double backing_until_ = 0.0;

  bool touching_ = false;
  double deepest_ = 0.0;
  double stand_until_ = 0.0;
  double patience_ = 0.0;
  Point watched_;
  double watched_at_ = 0.0;
  double stuck_since_ = -1.0;

  double entered_ = -1.0;
  double entered_travel_ = 0.0;
  bool arrived_ = false;
  double arrived_at_ = 0.0;
};

}  // namespace

Drive drive(const DrivePlan& plan, const WallIndex& walls, table::RandomStream random) {
  return Driver(plan, walls, random).run();
}

}  // namespace tcert
