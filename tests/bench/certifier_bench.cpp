// ns per tick of the certifier at a given size of the corridor graph: a robot that laps a circle
// of as many nodes, so that every edge closes at a known node, some with a higher margin.

#include <benchmark/benchmark.h>

#include <numbers>
#include <random>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>
#include <vector>

#include "support/allocations.hpp"

namespace {

using namespace tcert;

constexpr double kStep_m = 0.017;  // 0.17 m/s at 10 Hz

struct Lap {
  Robot robot;
  Course course;
  std::vector<Pose> poses;  // one lap
  std::vector<std::vector<RayReading>> readings;
};

Lap make_lap(std::size_t nodes) {
  Lap lap;
  const double square = 0.5 * std::numbers::pi;
  lap.robot.rays = {{"left", {0.2, 0.1}, square, 0.7, RayKind::range, {}},
                    {"right", {0.2, -0.1}, -square, 0.7, RayKind::range, {}},
                    {"ahead", {0.3, 0.0}, 0.0, 0.5, RayKind::range, {}}};
  const double length_m = 0.25 * static_cast<double>(nodes);
  const double radius_m = length_m / (2.0 * std::numbers::pi);
  const auto steps = static_cast<std::size_t>(length_m / kStep_m);
  for (std::size_t k = 0; k < steps; ++k) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(steps);
    lap.poses.push_back({radius_m * Point{std::sin(a), 1.0 - std::cos(a)}, a});
  }
  lap.course.start = Disc{lap.poses[0].position, 0.3};
  lap.course.goal = Disc{lap.poses[steps / 2].position, 0.3};
  std::mt19937 engine(1);
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  for (std::size_t k = 0; k < 9973; ++k) {
    const double force_n = engine() % 10 == 0 ? 1.0 : 0.0;
    lap.readings.push_back({{uniform(0.2, 0.5), force_n}, {uniform(0.2, 0.5), 0.0}, {0.5, 0.0}});
  }
  return lap;
}

void certifier_update(benchmark::State& state, ClearanceReading clearance) {
  const Lap lap = make_lap(static_cast<std::size_t>(state.range(0)));
  CertificateParameters parameters;
  parameters.clearance = clearance;
  parameters.max_nodes = static_cast<std::uint32_t>(state.range(0)) + 64;
  parameters.max_edges = 2 * parameters.max_nodes;
  Certifier certifier(lap.robot, lap.course, parameters);
  Tick tick;
  std::size_t k = 0;
  CertifiedTick out;
  const auto next = [&] {
    tick.time_ns += 100'000'000;
    tick.pose = lap.poses[k % lap.poses.size()];
    tick.rays = lap.readings[k % lap.readings.size()];
    ++k;
    out = certifier.update(tick);
  };
  while (k <= lap.poses.size() + 100) {
    next();
  }
  std::size_t allocations = 0;
  for ([[maybe_unused]] auto turn : state) {
    const std::size_t before = test_support::allocation_count();
    next();
    allocations += test_support::allocation_count() - before;
    benchmark::DoNotOptimize(out);
  }
  state.counters["nodes"] = out.nodes;
  state.counters["edges"] = out.edges;
  state.counters["allocations"] = static_cast<double>(allocations);
}
BENCHMARK_CAPTURE(certifier_update, width, ClearanceReading::width)->Arg(64)->Arg(512)->Arg(4096);
BENCHMARK_CAPTURE(certifier_update, radial, ClearanceReading::radial)->Arg(512);
BENCHMARK_CAPTURE(certifier_update, swept, ClearanceReading::swept)->Arg(64)->Arg(512)->Arg(4096);

}  // namespace
