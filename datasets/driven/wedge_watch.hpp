#pragma once
/// \file
/// Whether a robot is stopped for good, by what it is told and where it gets.

#include <cstdint>
#include <optional>
#include <tcert/geometry.hpp>

#include "datasets/driven/drive_parameters.hpp"

namespace tcert {

/// Counts stalls and recoveries, and says when there is nothing to hope for.
///
/// A *stall* is stall_s of forward command during which the body gets no further than
/// stall_travel_m. A *recovery* is a command to reverse after the body touched something. At
/// either the robot was *stopped*. Being stopped again before it got further than wedge_place_m
/// from where it was stopped first says that what it did in between, be it nothing, has failed.
/// Once wedge_recoveries have failed and forward was commanded for stall_s more, being stopped yet
/// again makes it *wedged*: a robot that gives up, backs out and gets away is not.
class WedgeWatch {
 public:
  WedgeWatch(const DriveParameters& parameters, Point start) noexcept
      : parameters_(parameters), from_(start) {}

  /// The next `seconds` of the trial: what was commanded, whether the body touched a wall, and
  /// where it is at their end.
  void watch(double seconds, double speed_cmd_mps, bool touches, Point position) noexcept;

  [[nodiscard]] bool wedged() const noexcept { return wedged_; }
  [[nodiscard]] std::uint32_t stalls() const noexcept { return stalls_; }
  [[nodiscard]] std::uint32_t recoveries() const noexcept { return recoveries_; }

 private:
  void be_stopped(Point position) noexcept;
  void restart(Point position) noexcept;

  DriveParameters parameters_;
  Point from_;              ///< Of the stretch in which the next stall would be.
  double forward_s_ = 0.0;  ///< Of forward command in it.
  bool touched_ = false;    ///< Since the last command to reverse.
  std::optional<Point> place_;
  std::uint32_t failed_ = 0;
  double hopeless_s_ = 0.0;  ///< Of forward command since enough recoveries have failed.
  bool wedged_ = false;
  std::uint32_t stalls_ = 0;
  std::uint32_t recoveries_ = 0;
};

}  // namespace tcert
