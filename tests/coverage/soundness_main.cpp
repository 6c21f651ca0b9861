// How often, how far and how tightly the certificate bounds the truth of random worlds, as CSV.
// soundness_study [WORLDS [U_TURNS [THREADS [SEED]]]]

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "analysis/study/soundness/soundness.hpp"

namespace {

using namespace tcert;

constexpr std::size_t kBatch = 10000;

/// Worlds in batches, so that a long run shows how far it is.
std::vector<WorldOutcome> study(const std::vector<SoundnessMethod>& methods,
                                SoundnessOptions options) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<WorldOutcome> all;
  const std::size_t worlds = options.worlds;
  while (all.size() < worlds) {
    options.first = all.size();
    options.worlds = std::min(kBatch, worlds - all.size());
    std::vector<WorldOutcome> batch = study_soundness(methods, options);
    all.insert(all.end(), batch.begin(), batch.end());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    std::fprintf(
        stderr, "%zu of %zu worlds, %.0f s; with a violation:", all.size(), worlds, took.count());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const SoundnessSummary s = summarise(all, m);
      std::fprintf(stderr,
                   " %s%s %zu (%.4f m)",
                   methods[m].name.c_str(),
                   methods[m].noise ? " with noise" : "",
                   s.violations,
                   s.largest_excess_m);
    }
    std::fprintf(stderr, "\n");
  }
  return all;
}

void print_rates(const char* set,
                 const std::vector<SoundnessMethod>& methods,
                 const std::vector<WorldOutcome>& worlds) {
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const SoundnessSummary s = summarise(worlds, m);
    std::printf("%s,\"%s\",%s,%zu,%llu,%zu,%zu,%zu,%zu,%llu,%.4f,%.3g,%.3g\n",
                set,
                methods[m].name.c_str(),
                methods[m].noise ? "yes" : "no",
                s.worlds,
                static_cast<unsigned long long>(s.ticks),
                s.issued,
                s.untraversable,
                s.spurious,
                s.violations,
                static_cast<unsigned long long>(s.violating_ticks),
                s.largest_excess_m,
                static_cast<double>(s.violations) / static_cast<double>(s.worlds),
                s.violation_bound);
  }
}

void print_tightness(const std::vector<SoundnessMethod>& methods,
                     const std::vector<WorldOutcome>& worlds) {
  std::printf("\nfamily,method,noise,lanes_explored,lanes,worlds,median_gap_m,p90_gap_m\n");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    for (const Tightness& row : tightness_of(worlds, m)) {
      std::printf("%s,\"%s\",%s,%u,%u,%zu,%.4f,%.4f\n",
                  std::string(name_of(row.family)).c_str(),
                  methods[m].name.c_str(),
                  methods[m].noise ? "yes" : "no",
                  row.explored,
                  row.lanes,
                  row.worlds,
                  row.median_m,
                  row.p90_m);
    }
  }
}

std::size_t argument(int argc, char** argv, int place, std::size_t otherwise) {
  return argc > place ? std::strtoul(argv[place], nullptr, 10) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  SoundnessOptions options;
  options.worlds = argument(argc, argv, 1, 100000);
  const std::size_t u_turns = argument(argc, argv, 2, 10000);
  const std::size_t threads = argument(argc, argv, 3, 2);
  options.seed = argument(argc, argv, 4, 1);
  if (options.worlds == 0 || u_turns == 0 || threads == 0 || argc > 5) {
    std::fprintf(stderr, "usage: soundness_study [WORLDS [U_TURNS [THREADS [SEED]]]]\n");
    return 2;
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const auto mixed = mixed_methods();
  const std::vector<WorldOutcome> worlds = study(mixed, options);
  std::printf(
      "worlds_of,method,noise,worlds,ticks,issued,untraversable,issued_untraversable,"
      "violating_worlds,violating_ticks,largest_excess_m,rate,upper_95\n");
  print_rates("mixed", mixed, worlds);
  for (const WorldFamily family : kMixedFamilies) {
    std::vector<WorldOutcome> of_family;
    std::copy_if(worlds.begin(), worlds.end(), std::back_inserter(of_family), [&](const auto& w) {
      return w.family == family;
    });
    print_rates(std::string(name_of(family)).c_str(), mixed, of_family);
  }
  options.family = WorldFamily::u_turn;
  options.worlds = u_turns;
  const auto turning = u_turn_methods();
  const std::vector<WorldOutcome> turns = study(turning, options);
  print_rates("u_turn", turning, turns);
  print_tightness(mixed, worlds);
  return 0;
}
