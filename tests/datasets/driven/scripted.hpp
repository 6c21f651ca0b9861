#pragma once
/// \file
/// Controllers and worlds of the tests of driven trials: simple, and not the policies of the
/// product.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <table/random.hpp>
#include <tcert/elementary.hpp>
#include <tcert/geometry.hpp>
#include <tcert/senses.hpp>
#include <vector>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/driven/driven_design.hpp"

namespace tcert::driven_test {

inline constexpr double kBodyRadius = 0.225;

/// One speed and one yaw rate, whatever it feels.
struct Steady {
  double speed_mps = 0.2;
  double yaw_rate_rps = 0.0;
  policies::Command operator()(const policies::Senses& /*senses*/) const {
    return {speed_mps, yaw_rate_rps};
  }
};

/// Aims 0.4 m ahead on the first lane of each lobe, keeps off the side that is felt nearer, and
/// backs off to the other side of a bump for a while. Mirrors to the bit: it only adds two numbers
/// at a time, and every choice is one of magnitude.
class LineDriver {
 public:
  explicit LineDriver(const DrivenWorld& world, double speed_mps = 0.17) : speed_mps_(speed_mps) {
    for (const auto& lanes : world.lobes) {
      line_.insert(line_.end(), lanes.front().begin(), lanes.front().end());
    }
  }

  policies::Command operator()(const policies::Senses& senses) {
    constexpr double kFirm = 10.0;  // N
    const Pose& pose = senses.tick.pose;
    if (senses.bump && senses.bump->force_n > kFirm && backing_ == 0) {
      backing_ = 75;
      turn_ = senses.bump->bearing_rad > 0.0 ? 0.2 : -0.2;
    }
    if (backing_ > 0) {
      --backing_;
      return {-0.10, turn_};
    }
    while (next_ + 1 < line_.size() && distance(line_[next_], pose.position) < 0.4) {
      ++next_;
    }
    const Point ahead = direction(pose.yaw_rad);
    const Point to = line_[next_] - pose.position;
    const double turn = elementary::atan2(cross(ahead, to), dot(ahead, to));
    const double left = senses.tick.rays[0].value;  // bends: 0 is free
    const double right = senses.tick.rays[1].value;
    const double aside = std::isnan(left) || std::isnan(right) ? 0.0 : 0.3 * (right - left);
    return {speed_mps_ * std::max(std::cos(std::abs(turn)), 0.1),
            std::clamp(1.5 * turn + aside, -0.8, 0.8)};
  }

 private:
  std::vector<Point> line_;
  double speed_mps_;
  std::size_t next_ = 0;
  int backing_ = 0;
  double turn_ = 0.0;
};

/// Draws a speed and a yaw rate anew now and then, mostly forward; `mirrored` turns the other way.
class Wanderer {
 public:
  Wanderer(std::uint64_t seed, std::uint64_t index, bool mirrored = false)
      : random_(seed, 0x7465'0001, index), side_(mirrored ? -1.0 : 1.0) {}

  policies::Command operator()(const policies::Senses& /*senses*/) {
    if (left_ == 0) {
      left_ = 5 + random_.below(60);
      command_.speed_mps = random_.uniform(-0.12, 0.3);
      command_.yaw_rate_rps = side_ * random_.uniform(-1.0, 1.0);
    }
    --left_;
    return command_;
  }

 private:
  table::RandomStream random_;
  double side_;
  std::uint32_t left_ = 0;
  policies::Command command_;
};

inline Polygon box(Point low, Point high) {
  return {{low, {high.x_m, low.y_m}, high, {low.x_m, high.y_m}}};
}

/// A straight corridor along x from S, the disc of 0.3 m round the origin, to G, the same round
/// (length, 0).
inline DrivenWorld corridor(double length_m, double width_m) {
  DrivenWorld driven;
  const double half = 0.5 * width_m;
  driven.world.name = "corridor";
  driven.world.bounds = {{-1.5, -half - 0.5}, {length_m + 1.5, half + 0.5}};
  driven.world.obstacles = {box({-1.0, half}, {length_m + 1.0, half + 0.2}),
                            box({-1.0, -half - 0.2}, {length_m + 1.0, -half}),
                            box({-1.2, -half - 0.2}, {-1.0, half + 0.2}),
                            box({length_m + 1.0, -half - 0.2}, {length_m + 1.2, half + 0.2})};
  driven.world.start = Disc{{0.0, 0.0}, 0.3};
  driven.world.goal = Disc{{length_m, 0.0}, 0.3};
  driven.lobes = {{{{0.0, 0.0}, {length_m, 0.0}}}};
  driven.margin_m = width_m - 2.0 * kBodyRadius;
  return driven;
}

/// The same with jaws that leave a gate of `gate_m`, 0.15 m long, in the middle.
inline DrivenWorld gated_corridor(double length_m, double width_m, double gate_m) {
  DrivenWorld driven = corridor(length_m, width_m);
  const double middle = 0.5 * length_m;
  const double half = 0.5 * width_m + 0.05;
  driven.world.obstacles.emplace_back(box({middle - 0.075, 0.5 * gate_m}, {middle + 0.075, half}));
  driven.world.obstacles.emplace_back(
      box({middle - 0.075, -half}, {middle + 0.075, -0.5 * gate_m}));
  driven.margin_m = gate_m - 2.0 * kBodyRadius;
  return driven;
}

inline DrivenDesign design_of(DrivenWorld world, const DriveParameters& parameters = {}) {
  DrivenDesign design;
  design.world = std::move(world);
  design.parameters = parameters;
  design.trial_id = "t0";
  return design;
}

/// No force ends a trial.
inline DriveParameters uncrashable() {
  DriveParameters parameters;
  parameters.crash_force_n = 1e6;
  return parameters;
}

}  // namespace tcert::driven_test
