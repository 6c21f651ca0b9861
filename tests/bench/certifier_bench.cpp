// ns per tick of the certifier at a given size of the corridor graph: a robot that laps a circle
// of as many nodes, so that every edge closes at a known node, some with a higher margin.

#include <benchmark/benchmark.h>

#include <random>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>
#include <vector>

#include "support/allocations.hpp"
#include "support/lap.hpp"

namespace {

using namespace tcert;

using test_support::Lap;

/// A tenth of the ticks in contact.
std::vector<std::vector<RayReading>> make_readings() {
  std::vector<std::vector<RayReading>> readings;
  std::mt19937 engine(1);
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  for (std::size_t k = 0; k < 9973; ++k) {
    const double force_n = engine() % 10 == 0 ? 1.0 : 0.0;
    readings.push_back({{uniform(0.2, 0.5), force_n}, {uniform(0.2, 0.5), 0.0}, {0.5, 0.0}});
  }
  return readings;
}

void certifier_update(benchmark::State& state, ClearanceReading clearance) {
  const Lap lap = test_support::make_lap(static_cast<std::size_t>(state.range(0)));
  const auto readings = make_readings();
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
    tick.rays = readings[k % readings.size()];
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
