#include "datasets/values/check_yaw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tcert/geometry.hpp>

namespace tcert {
namespace {

constexpr double kStepM = 0.05;
constexpr std::size_t kLeastSteps = 20;
constexpr double kBeyondTurnsRad = 7.0;  // more than an angle that is kept within a turn
constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kTan15 = 0.267949192431122706;
constexpr double kTan20 = 0.363970234266202362;
constexpr double kNearTurnRad = 0.5;
constexpr std::size_t kLeastJumps = 3;

/// At how many steps the heading lies how far off the motion, ahead or back.
struct HeadingCount {
  std::size_t steps = 0;
  std::size_t within_15 = 0;
  std::size_t off_20 = 0;
  std::size_t off_45 = 0;

  void add(Point motion, Point heading) noexcept {
    const double along = std::abs(dot(motion, heading));
    const double across = std::abs(motion.x_m * heading.y_m - motion.y_m * heading.x_m);
    ++steps;
    within_15 += across < kTan15 * along ? 1 : 0;
    off_20 += across > kTan20 * along ? 1 : 0;
    off_45 += across > along ? 1 : 0;
  }
  [[nodiscard]] bool most(std::size_t count) const noexcept { return 2 * count > steps; }
};

/// The headings of a trial against its motion, yaw taken `scale` times.
HeadingCount count_headings(const TickTable& ticks, double scale) {
  HeadingCount count;
  bool begun = false;
  Point from;
  Point heading;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    begun = begun && ticks.segment_start[i] == 0;
    if (ticks.stale[i] != 0) {
      continue;
    }
    const Point motion = ticks.poses[i].position - from;
    if (begun && dot(motion, motion) < kStepM * kStepM) {
      continue;
    }
    const double yaw_rad = scale * ticks.poses[i].yaw_rad;
    const Point here{std::cos(yaw_rad), std::sin(yaw_rad)};
    if (begun) {
      count.add(motion, {heading.x_m + here.x_m, heading.y_m + here.y_m});
    }
    begun = true;
    from = ticks.poses[i].position;
    heading = here;
  }
  return count;
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
                     std::abs(std::remainder(step_rad, 2.0 * std::numbers::pi)) > kNearTurnRad
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
  const HeadingCount radians = count_headings(ticks, 1.0);
  const bool judged = radians.steps >= kLeastSteps;
  const bool off_45 = judged && radians.most(radians.off_45);
  const bool off_20 = judged && radians.most(radians.off_20);
  const double largest_rad = largest_yaw(ticks);
  if (largest_rad > kBeyondTurnsRad) {
    if (off_20) {
      const HeadingCount degrees = count_headings(ticks, kRadPerDegree);
      if (degrees.most(degrees.within_15)) {
        return yaw_finding(
            fmt::format("angles up to {:g} that follow the motion as degrees do", largest_rad),
            "radians: degrees?");
      }
    }
    const std::size_t jumps = count_jumps(ticks);
    if (jumps >= std::max(kLeastJumps, ticks.size() / 100)) {
      return yaw_finding(
          fmt::format(
              "angles up to {:g}, {} jumps from tick to tick by more than pi", largest_rad, jumps),
          "radians that turn as the robot does: degrees?");
    }
  }
  if (off_45) {
    return yaw_finding(
        fmt::format(
            "over 45 degrees off the motion at {:.0f} % of the steps",
            100.0 * static_cast<double>(radians.off_45) / static_cast<double>(radians.steps)),
        "radians anticlockwise from the x axis of x_m and y_m: degrees, a compass bearing, another "
        "frame? A robot that moves sideways reads so too");
  }
  return std::nullopt;
}

}  // namespace tcert
