#include "support/random_run.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace tcert::test_support {
namespace {

Run with_own_readings(const Run& run) {
  Run copy = run;
  for (std::size_t k = 0; k < copy.ticks.size(); ++k) {
    copy.ticks[k].rays = copy.readings[k];
  }
  return copy;
}

template <typename Map>
void map_points(Run& run, Map map) {
  for (Tick& tick : run.ticks) {
    tick.pose.position = map(tick.pose.position);
  }
  for (auto* region : {&run.course.start, &run.course.goal}) {
    auto& disc = std::get<Disc>(region->value());
    disc.centre = map(disc.centre);
  }
}

}  // namespace

Run random_run(std::uint32_t seed, std::size_t length) {
  std::mt19937 engine(seed);
  const auto bits = [&engine] { return static_cast<std::uint32_t>(engine()); };
  const auto uniform = [&bits](double low, double high) {
    return low + (high - low) * static_cast<double>(bits()) / 4294967296.0;
  };
  const auto one_in = [&bits](std::uint32_t n) { return bits() % n == 0; };

  Run run;
  const double square = 0.5 * std::numbers::pi;
  run.robot.rays = {{"left", {0.0, 0.1}, square, 0.8, RayKind::range, {}},
                    {"right", {0.0, -0.1}, -square, 0.8, RayKind::range, {}},
                    {"ahead", {0.2, 0.0}, 0.0, 0.8, RayKind::range, {}}};
  run.course.start = Disc{{0.0, 0.0}, 0.4};
  run.course.goal = Disc{{1.3, 0.0}, 0.4};

  Pose pose;
  double gear = 1.0;
  double turn_per_m = uniform(-2.5, 2.5);
  std::int64_t time_ns = static_cast<std::int64_t>(bits() % 1000) * 1'000'000;
  for (std::size_t k = 0; k < length; ++k) {
    turn_per_m = one_in(40) ? uniform(-2.5, 2.5) : turn_per_m;
    gear = one_in(60) ? -gear : gear;
    const double step_m = one_in(6) ? 0.0 : gear * uniform(0.0, 0.06);
    pose.yaw_rad += step_m * turn_per_m + uniform(-0.002, 0.002);
    pose.position = pose.position + step_m * direction(pose.yaw_rad);
    if (one_in(300)) {
      pose = {{uniform(-1.0, 3.0), uniform(-1.0, 1.0)}, uniform(-3.0, 3.0)};
    }
    Tick tick;
    time_ns += 100'000'000;
    tick.time_ns = time_ns;
    tick.pose = {
        {pose.position.x_m + uniform(-0.001, 0.001), pose.position.y_m + uniform(-0.001, 0.001)},
        pose.yaw_rad};
    tick.stale = one_in(50);
    tick.segment_start = one_in(400);
    std::vector<RayReading> readings(3);
    for (RayReading& reading : readings) {
      reading.value = one_in(100) ? kMissing : 0.05 * static_cast<double>(bits() % 18);
      reading.fsr_n = one_in(3) ? kMissing : 0.2 * static_cast<double>(bits() % 6);
    }
    run.ticks.push_back(tick);
    run.readings.push_back(readings);
  }
  return with_own_readings(run);
}

Run mirrored(const Run& run) {
  Run copy = with_own_readings(run);
  map_points(copy, [](Point p) { return Point{p.x_m, -p.y_m}; });
  for (Tick& tick : copy.ticks) {
    tick.pose.yaw_rad = -tick.pose.yaw_rad;
  }
  for (Ray& ray : copy.robot.rays) {
    ray.mount.y_m = -ray.mount.y_m;
    ray.bearing_rad = -ray.bearing_rad;
  }
  return copy;
}

Run shifted_in_time(const Run& run, std::int64_t by_ns) {
  Run copy = with_own_readings(run);
  for (Tick& tick : copy.ticks) {
    tick.time_ns += by_ns;
  }
  return copy;
}

Run moved(const Run& run, double yaw_rad, Point by) {
  Run copy = with_own_readings(run);
  map_points(copy, [&](Point p) { return transform({by, yaw_rad}, p); });
  for (Tick& tick : copy.ticks) {
    tick.pose.yaw_rad += yaw_rad;
  }
  return copy;
}

Run scaled(const Run& run, double factor) {
  Run copy = with_own_readings(run);
  map_points(copy, [factor](Point p) { return factor * p; });
  for (auto* region : {&copy.course.start, &copy.course.goal}) {
    std::get<Disc>(region->value()).radius_m *= factor;
  }
  copy.robot.body_width_m *= factor;
  copy.robot.min_turn_radius_m *= factor;
  for (Ray& ray : copy.robot.rays) {
    ray.mount = factor * ray.mount;
    ray.reach_m *= factor;
  }
  for (auto& readings : copy.readings) {
    for (RayReading& reading : readings) {
      reading.value *= factor;
    }
  }
  return copy;
}

}  // namespace tcert::test_support
