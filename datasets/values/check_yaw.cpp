#include "datasets/values/check_yaw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tcert/geometry.hpp>
#include <utility>
#include <vector>

namespace tcert {
namespace {

constexpr double kStepM = 0.05;
constexpr std::size_t kLeastSteps = 20;
constexpr std::size_t kLeastStepsInDegrees = 10;  // where a better reading is at hand
constexpr double kBeyondTurnsRad = 7.0;           // more than an angle that is kept within a turn
constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kTan15 = 0.267949192431122706;
constexpr double kBetterShare = 0.7;
constexpr double kNearTurnRad = 0.5;
constexpr std::size_t kLeastJumps = 3;

/// A step along the path, with the mean of the headings at its ends. Where yaw wraps between them,
/// the mean points back, which makes no difference here.
struct Step {
  Point motion;
  double yaw_rad = 0.0;
};

std::vector<Step> steps_of(const TickTable& ticks) {
  std::vector<Step> steps;
  bool begun = false;
  Pose from;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    begun = begun && ticks.segment_start[i] == 0;
    if (ticks.stale[i] != 0) {
      continue;
    }
    const Pose& here = ticks.poses[i];
    const Point motion = here.position - from.position;
    if (begun && dot(motion, motion) < kStepM * kStepM) {
      continue;
    }
    if (begun) {
      steps.push_back({motion, 0.5 * (from.yaw_rad + here.yaw_rad)});
    }
    begun = true;
    from = here;
  }
  return steps;
}

/// How far the heading of a step, yaw taken `scale` times, lies off its motion, ahead or back.
struct OffMotion {
  double along = 0.0;
  double across = 0.0;

  OffMotion(const Step& step, double scale) noexcept {
    const double yaw_rad = scale * step.yaw_rad;
    const Point heading{std::cos(yaw_rad), std::sin(yaw_rad)};
    along = std::abs(dot(step.motion, heading));
    across = std::abs(step.motion.x_m * heading.y_m - step.motion.y_m * heading.x_m);
  }
  [[nodiscard]] bool is_over_45() const noexcept { return across > along; }
  [[nodiscard]] bool is_within_15() const noexcept { return across < kTan15 * along; }
  [[nodiscard]] bool is_half_of(const OffMotion& other) const noexcept {
    return across * other.along < 0.5 * other.across * along;
  }
};

std::size_t count_over_45(const std::vector<Step>& steps) {
  return static_cast<std::size_t>(std::ranges::count_if(
      steps, [](const Step& step) { return OffMotion(step, 1.0).is_over_45(); }));
}

/// True if the headings follow the motion as degrees, and far better so than as radians.
bool follow_as_degrees(const std::vector<Step>& steps) {
  std::size_t within_15 = 0;
  std::size_t better = 0;
  for (const Step& step : steps) {
    const OffMotion degrees(step, kRadPerDegree);
    within_15 += degrees.is_within_15() ? 1 : 0;
    better += degrees.is_half_of(OffMotion(step, 1.0)) ? 1 : 0;
  }
  return 2 * within_15 > steps.size() &&
         static_cast<double>(better) > kBetterShare * static_cast<double>(steps.size());
}

double largest_yaw(const TickTable& ticks) {
  double largest = 0.0;
  for (const Pose& pose : ticks.poses) {
    largest = std::max(largest, std::abs(pose.yaw_rad));
  }
  return largest;
}

/// Steps of yaw beyond pi from one tick to the next that are no whole turns.
std::size_t count_jumps(const TickTable& ticks) {
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const double step_rad = ticks.poses[i].yaw_rad - ticks.poses[i - 1].yaw_rad;
    jumps += ticks.segment_start[i] == 0 && std::abs(step_rad) > std::numbers::pi &&
                     std::abs(wrapped_angle(step_rad)) > kNearTurnRad
                 ? 1
                 : 0;
  }
  return jumps;
}

ValueFinding yaw_finding(std::string found, std::string expectation) {
  return value_finding(ValueKind::yaw, "yaw_rad", std::move(found), std::move(expectation));
}

}  // namespace

std::optional<ValueFinding> check_yaw(const TickTable& ticks) {
  const std::vector<Step> steps = steps_of(ticks);
  const double largest_rad = largest_yaw(ticks);
  if (largest_rad > kBeyondTurnsRad) {
    if (steps.size() >= kLeastStepsInDegrees && follow_as_degrees(steps)) {
      return yaw_finding(
          fmt::format("angles up to {:g} that follow the motion as degrees do", largest_rad),
          "radians: degrees?");
    }
    const std::size_t jumps = count_jumps(ticks);
    if (jumps >= std::max(kLeastJumps, ticks.size() / 100)) {
      return yaw_finding(
          fmt::format(
              "angles up to {:g}, {} jumps from tick to tick by more than pi", largest_rad, jumps),
          "radians that turn as the robot does: degrees?");
    }
  }
  const std::size_t off = count_over_45(steps);
  if (steps.size() < kLeastSteps || 2 * off <= steps.size()) {
    return std::nullopt;
  }
  return yaw_finding(
      fmt::format("over 45 degrees off the motion at {:.0f} % of the steps",
                  100.0 * static_cast<double>(off) / static_cast<double>(steps.size())),
      "radians anticlockwise from the x axis of x_m and y_m: degrees, a compass bearing, another "
      "frame? A robot that moves sideways reads so too");
}

}  // namespace tcert
