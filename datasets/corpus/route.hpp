#pragma once
/// \file
/// The paths that a trial's policy follows, leg by leg.

#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/corpus/trial_course.hpp"

namespace tcert {

inline constexpr double kPathStep = 0.02;  ///< Nominal distance of a path's points.

/// A path to follow, forwards or backing along it.
struct Leg {
  std::vector<Point> path;
  bool reverse = false;
};

/// From S along the route's centre lines to the middle of G, swerving through the middle of each
/// gate within 0.7 m of it. A route that changes sides at the crossing turns there on an arc of 1
/// m.
///
/// With `look_in`, the robot first drives `look_in_m` past the crossing into the lane that it does
/// not take, backs out to where the arc begins, and then takes the other.
[[nodiscard]] std::vector<Leg> plan_legs(const TrialCourse& trial, bool look_in, double look_in_m);

/// A straight way through points of equal spacing.
[[nodiscard]] std::vector<Point> straight_path(Point from, Point to);

}  // namespace tcert
