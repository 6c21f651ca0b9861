#pragma once
/// \file
/// Random runs of a small robot, with everything in them that a log can hold.

#include <cstdint>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert::test_support {

/// Ticks that own their readings.
struct Run {
  Robot robot;
  Course course;
  std::vector<Tick> ticks;  // rays point into readings
  std::vector<std::vector<RayReading>> readings;
};

/// A run of `length` ticks that drives in loops of random size through S and G, turns back now
/// and then, stands still, jumps, goes stale and loses rays; readings take few distinct values, so
/// that margins tie. Left and right range rays, and one ahead.
[[nodiscard]] Run random_run(std::uint32_t seed, std::size_t length);

/// Copies of a run under a map of the plane, of time and of the rays.
[[nodiscard]] Run mirrored(const Run& run);
[[nodiscard]] Run shifted_in_time(const Run& run, std::int64_t by_ns);
[[nodiscard]] Run moved(const Run& run, double yaw_rad, Point by);
[[nodiscard]] Run scaled(const Run& run, double factor);

}  // namespace tcert::test_support
