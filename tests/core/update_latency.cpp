// How long one update takes, tick by tick: update_latency FILE [TICKS]
// FILE of export_ticks; its trials are run again and again, 10^7 ticks unless told otherwise. Then
// graphs of growing size, up to the capacity, and the worst that can happen in each.

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>
#include <tcert/runtime.hpp>

#include "support/allocations.hpp"
#include "support/lap.hpp"
#include "support/tick_file.hpp"

namespace {

using namespace tcert;
using test_support::TickFile;
using Clock = std::chrono::steady_clock;

std::uint64_t since_ns(Clock::time_point begin) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count());
}

/// Counts of times, eight classes to each doubling: a value is known to one part in eight.
class Histogram {
 public:
  void add(std::uint64_t ns) {
    ++counts_[class_of(ns)];
    ++total_;
    most_ = std::max(most_, ns);
  }
  /// Upper end of the class in which the quantile lies.
  [[nodiscard]] std::uint64_t quantile(double p) const {
    const auto rank = static_cast<std::uint64_t>(p * static_cast<double>(total_));
    std::uint64_t below = 0;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      below += counts_[k];
      if (below > rank) {
        return std::min(most_, end_of(k));
      }
    }
    return most_;
  }
  [[nodiscard]] std::uint64_t most() const { return most_; }
  void print() const {
    for (unsigned doubling = 3; doubling < 40; ++doubling) {
      std::uint64_t count = 0;
      for (std::size_t k = 0; k < 8; ++k) {
        count += counts_[(doubling - 2) * 8 + k];
      }
      if (count > 0) {
        const double share = static_cast<double>(count) / static_cast<double>(total_);
        std::printf("  %10llu to %10llu ns  %9llu  %9.5f %%  %s\n",
                    1ULL << doubling,
                    (1ULL << (doubling + 1)) - 1,
                    static_cast<unsigned long long>(count),
                    100.0 * share,
                    std::string(static_cast<std::size_t>(60.0 * share + 0.5), '#').c_str());
      }
    }
  }

 private:
  static std::size_t class_of(std::uint64_t ns) {
    if (ns < 8) {
      return static_cast<std::size_t>(ns);
    }
    const auto doubling = static_cast<unsigned>(std::bit_width(ns)) - 1;
    return (doubling - 2) * 8 + static_cast<std::size_t>((ns >> (doubling - 3)) & 7U);
  }
  static std::uint64_t end_of(std::size_t k) {
    if (k < 8) {
      return k;
    }
    const unsigned doubling = static_cast<unsigned>(k / 8) + 2;
    return ((8 + (k % 8) + 1) << (doubling - 3)) - 1;
  }

  std::array<std::uint64_t, 40 * 8> counts_{};
  std::uint64_t total_ = 0;
  std::uint64_t most_ = 0;
};

std::uint64_t preemptions() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_nivcsw);
}

void print_row(const char* what, const Histogram& times, std::uint32_t most_labels) {
  std::printf("%-44s p50 %6llu  p99 %6llu  p99.9 %7llu  max %9llu ns  labels at most %u\n",
              what,
              static_cast<unsigned long long>(times.quantile(0.5)),
              static_cast<unsigned long long>(times.quantile(0.99)),
              static_cast<unsigned long long>(times.quantile(0.999)),
              static_cast<unsigned long long>(times.most()),
              most_labels);
}

/// The certifier, and certifier with guards, over the trials of the file.
void time_trials(const TickFile& file, std::uint64_t wanted) {
  std::size_t ticks_of_file = 0;
  for (const TickFile::Trial& trial : file.trials) {
    ticks_of_file += trial.ticks.size();
  }
  std::printf("%zu trials, %zu ticks\n", file.trials.size(), ticks_of_file);
  Certifier certifier(file.robot, file.course, {});
  Guards guards({file.robot, {}, {}, {}, TrackingErrorTable()});
  std::vector<std::uint64_t> fastest(ticks_of_file, std::numeric_limits<std::uint64_t>::max());
  Histogram clock_alone;
  for (int k = 0; k < 1'000'000; ++k) {
    const auto begin = Clock::now();
    clock_alone.add(since_ns(begin));
  }
  print_row("reading the clock twice, in every figure below", clock_alone, 0);
  Histogram certify;
  Histogram guard;
  std::uint32_t most_labels = 0;
  std::uint32_t most_nodes = 0;
  double sum = 0.0;
  const std::size_t allocations = test_support::allocation_count() + test_support::malloc_count();
  const std::uint64_t preempted = preemptions();
  std::uint64_t done = 0;
  while (done < wanted) {
    std::size_t at = 0;
    for (const TickFile::Trial& trial : file.trials) {
      certifier.reset();
      guards.reset();
      for (const Tick& tick : trial.ticks) {
        const auto begin = Clock::now();
        const CertifiedTick now = certifier.update(tick);
        const std::uint64_t ns = since_ns(begin);
        const auto again = Clock::now();
        sum += guards.update(tick, now).speed_mps;
        guard.add(since_ns(again));
        certify.add(ns);
        fastest[at] = std::min(fastest[at], ns);
        ++at;
        most_labels = std::max(most_labels, now.labels_raised);
        most_nodes = std::max(most_nodes, now.nodes);
      }
      done += trial.ticks.size();
    }
  }
  std::printf(
      "%llu ticks; allocations and mallocs %zu; preempted %llu times; up to %u nodes (%g)\n",
      static_cast<unsigned long long>(done),
      test_support::allocation_count() + test_support::malloc_count() - allocations,
      static_cast<unsigned long long>(preemptions() - preempted),
      most_nodes,
      sum);
  print_row("Certifier::update, trials", certify, most_labels);
  certify.print();
  print_row("Guards::update, trials", guard, 0);
  Histogram slowest;
  for (const std::uint64_t ns : fastest) {
    slowest.add(ns);
  }
  print_row("each tick's fastest of all rounds", slowest, most_labels);
}

/// A whole tick with everything on: certificate, guards, risk field, default rules, and step().
void time_runtime(const TickFile& file, SpeedLawKind law, std::uint64_t wanted) {
  ActionSetup setup;
  setup.guards = {file.robot, {}, {}, {}, TrackingErrorTable()};
  setup.guards.law.kind = law;
  setup.risk.emplace();
  setup.rules = parse_rules(default_rules());
  Runtime runtime(file.course, setup);
  Histogram times;
  double sum = 0.0;
  const std::size_t allocations = test_support::allocation_count() + test_support::malloc_count();
  for (std::uint64_t done = 0; done < wanted;) {
    for (const TickFile::Trial& trial : file.trials) {
      runtime.reset();
      for (const Tick& tick : trial.ticks) {
        const auto begin = Clock::now();
        const RuntimeTick now = runtime.update(tick);
        const Command next = runtime.step({now.acted.guarded.speed_mps, 0.1}, tick.pose, 0.1);
        times.add(since_ns(begin));
        sum += next.speed_mps;
      }
      done += trial.ticks.size();
    }
  }
  std::printf("everything on: allocations and mallocs %zu (%g)\n",
              test_support::allocation_count() + test_support::malloc_count() - allocations,
              sum);
  print_row(law == SpeedLawKind::barrier ? "Runtime, everything on, barrier law"
                                         : "Runtime, everything on, clip law",
            times,
            0);
}

/// The barrier filter alone, on programs of eight random rows, a third of them without a solution.
void time_filter() {
  std::mt19937 engine(1);
  const auto unit = [&engine] { return static_cast<double>(engine()) / 2147483648.0 - 1.0; };
  Histogram times;
  double sum = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    std::array<BarrierRow, kMostBarrierRows> rows{};
    for (BarrierRow& row : rows) {
      row = {unit(), 0.3 * unit(), 0.1 * unit() - 0.1};
    }
    const Command wanted{0.11 + 0.2 * unit(), 0.8 * unit()};
    const auto begin = Clock::now();
    sum += nearest_command(wanted, rows, {}).command.speed_mps;
    times.add(since_ns(begin));
  }
  std::printf("filter (%g)\n", sum);
  print_row("nearest_command, eight rows", times, 0);
}

/// Laps of a circle of so many nodes: readings at random, a tenth of the ticks in contact.
void time_laps(std::uint32_t nodes) {
  const test_support::Lap lap = test_support::make_lap(nodes - 8);
  CertificateParameters parameters;
  Certifier certifier(lap.robot, lap.course, parameters);
  std::mt19937 engine(1);
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  Histogram times;
  std::uint32_t most_labels = 0;
  const std::size_t first_lap = lap.poses.size() + 100;
  for (std::size_t k = 0; k < first_lap + 1'000'000; ++k) {
    const std::array<RayReading, 3> readings{{{uniform(0.2, 0.5), engine() % 10 == 0 ? 1.0 : 0.0},
                                              {uniform(0.2, 0.5), 0.0},
                                              {0.5, 0.0}}};
    const Tick tick{static_cast<std::int64_t>(k) * 100'000'000,
                    lap.poses[k % lap.poses.size()],
                    readings,
                    false,
                    false};
    const auto begin = Clock::now();
    const CertifiedTick now = certifier.update(tick);
    const std::uint64_t ns = since_ns(begin);
    if (k >= first_lap) {
      times.add(ns);
      most_labels = std::max(most_labels, now.labels_raised);
    }
  }
  const std::string what = "laps, " + std::to_string(certifier.graph().nodes().size()) + " nodes";
  print_row(what.c_str(), times, most_labels);
}

/// The worst of a graph of that size: the narrow place at the start of the only corridor turns out
/// to be wide, and every label rises at one tick. The fastest of several rounds of that tick.
void time_worst(std::uint32_t nodes) {
  const test_support::Lap lap = test_support::make_lap(nodes - 8);
  Certifier certifier(lap.robot, lap.course, {});
  std::uint64_t fastest = std::numeric_limits<std::uint64_t>::max();
  std::uint32_t labels = 0;
  std::uint32_t edges = 0;
  for (int round = 0; round < 20; ++round) {
    certifier.reset();
    std::uint64_t slowest = 0;
    for (std::size_t k = 0; k < lap.poses.size() + 100; ++k) {
      const double range_m = k >= 40 && k < 60 ? 0.3 : 0.5;
      const std::array<RayReading, 3> readings{{{range_m, 0.0}, {range_m, 0.0}, {0.5, 0.0}}};
      const Tick tick{static_cast<std::int64_t>(k) * 100'000'000,
                      lap.poses[k % lap.poses.size()],
                      readings,
                      false,
                      false};
      const auto begin = Clock::now();
      const CertifiedTick now = certifier.update(tick);
      const std::uint64_t ns = since_ns(begin);
      if (now.labels_raised > nodes) {
        slowest = std::max(slowest, ns);
        labels = std::max(labels, now.labels_raised);
        edges = now.edges;
      }
    }
    fastest = std::min(fastest, slowest);
  }
  std::printf("worst tick, %4u nodes, %4u edges: %5u labels rise (bound %u), %8llu ns\n",
              nodes,
              edges,
              labels,
              8 * (edges + 2),
              static_cast<unsigned long long>(fastest));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "update_latency FILE [TICKS]\n");
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::ifstream stream(argv[1], std::ios::binary);
  const TickFile file = test_support::read_tick_file(stream);
  time_trials(file, argc == 3 ? std::strtoull(argv[2], nullptr, 10) : 10'000'000);
  for (const SpeedLawKind law : {SpeedLawKind::clip, SpeedLawKind::barrier}) {
    time_runtime(file, law, 1'000'000);
  }
  time_filter();
  for (const std::uint32_t nodes : {64U, 512U, 2048U, 4096U}) {
    time_laps(nodes);
  }
  for (const std::uint32_t nodes : {64U, 512U, 2048U, 4096U}) {
    time_worst(nodes);
  }
  return 0;
}
