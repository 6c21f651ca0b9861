// Runs the scenarios on a terrain file: one CSV row a run.
#include <tbb/parallel_for.h>

#include <table/random.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <terrain/lipschitz.hpp>
#include <vector>
#include "analysis/study/terrain/baselines.hpp"

#include "analysis/study/terrain/scenarios.hpp"
#include "analysis/study/terrain/terrain_soundness.hpp"
#include "datasets/terrain_file.hpp"

namespace tcert::terrain::study {
namespace {

struct Job {
  Scenario scenario;
  Variant variant;
  std::uint64_t seed = 0;
};

std::string run(const Terrain& terrain, const Job& job) {
  ExploreSetup setup = setup_of(terrain, job.scenario, job.variant, job.seed);
  if (job.scenario.reuse) {
    // The map of a run of "around" under the same variant and seed.
    const Scenario before = scenarios()[1];
    std::vector<Measurement> known;
    const auto keep = [&](const Planner& planner, const ExploreStep&, const ExploreResult&) {
      known = planner.measurements();
    };
    (void)explore(terrain, setup_of(terrain, before, job.variant, job.seed), keep);
    setup.known = std::move(known);
    if (job.variant.rules.kind == RuleSet::thesis) {
      for (const Measurement& m : setup.known) {
        setup.seeds.push_back(nearest_cell(m.at));
      }
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  const ExploreResult result = explore(terrain, setup);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  char certificate[40] = "";
  if (result.last().certificate) {
    std::snprintf(certificate, sizeof certificate, "%.2f", *result.last().certificate);
  }
  char line[400];
  std::snprintf(line,
                sizeof line,
                "%s,%s,%llu,%s,%zu,%zu,%zu,%zu,%zu,%.1f,%.4f,%zu,%zu,%.1f,%.1f,%s\n",
                job.scenario.name.c_str(),
                job.variant.name.c_str(),
                static_cast<unsigned long long>(job.seed),
                std::string(to_string(result.end)).c_str(),
                result.steps.size(),
                setup.first_cells.size() + 1,
                result.last().safe,
                result.last().unsafe_visits,
                result.most_unsafe_certified,
                result.last().travelled,
                seconds / static_cast<double>(result.steps.size()),
                result.ways,
                result.controller_fallbacks,
                result.controller_cells,
                result.route_cells,
                certificate);
  return line;
}

/// How often what is held safe is not, on random terrains.
int soundness_table(int terrains) {
  std::printf(
      "told,model_trusted,terrains,with_unsafe_cells,with_unsafe_visits,contradicted,reached,"
      "not_reachable,limit,mean_samples\n");
  for (const bool trust : {false, true}) {
    for (const double factor : {1.0, 0.75, 0.5}) {
      const Soundness s = soundness(static_cast<std::size_t>(terrains), factor, trust, 1);
      std::printf("%.2f,%d,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%.1f\n",
                  factor,
                  trust ? 1 : 0,
                  s.terrains,
                  s.with_unsafe_cells,
                  s.with_unsafe_visits,
                  s.contradicted,
                  s.reached,
                  s.not_reachable,
                  s.limit,
                  s.mean_samples);
      std::fflush(stdout);
    }
  }
  return 0;
}

/// What a band of the model costs that is trusted with certifying.
int trust_table(int terrains) {
  std::printf("beta,sd,terrains,with_unsafe_cells,with_unsafe_visits,reached,mean_samples\n");
  for (const double beta : {3.0, 9.0, 16.0, 25.0, 36.0}) {
    const Soundness s = soundness(static_cast<std::size_t>(terrains), 1.0, true, 1, beta);
    std::printf("%g,%.2f,%zu,%zu,%zu,%zu,%.1f\n",
                beta,
                std::sqrt(beta),
                s.terrains,
                s.with_unsafe_cells,
                s.with_unsafe_visits,
                s.reached,
                s.mean_samples);
    std::fflush(stdout);
  }
  return 0;
}

/// Table 4.1 with numbers: the baselines on the scenarios with a goal.
void baseline_table(const Terrain& terrain, int seeds) {
  std::printf("scenario,method,seed,reached,unsafe_visits,samples,plans,length,plan_s\n");
  for (const Scenario& s : scenarios()) {
    if (!s.goal || s.reuse) {
      continue;
    }
    const auto print = [&](const char* name, int seed, const BaselineResult& r, double seconds) {
      std::printf("%s,%s,%d,%d,%zu,%zu,%zu,%.1f,%.4f\n",
                  s.name.c_str(),
                  name,
                  seed,
                  r.reached ? 1 : 0,
                  r.unsafe_visits,
                  r.samples,
                  r.plans,
                  r.length,
                  seconds / static_cast<double>(r.plans));
      std::fflush(stdout);
    };
    const auto now = [] { return std::chrono::steady_clock::now(); };
    auto begin = now();
    const BaselineResult walk = straight_walk(terrain, {}, s.threshold, s.start, *s.goal);
    print("straight walk", 0, walk, std::chrono::duration<double>(now() - begin).count());
    for (int seed = 0; seed < seeds; ++seed) {
      table::RandomStream random(static_cast<std::uint64_t>(seed), 0x7e44bc, 0);
      SparseRrtOptions options;
      options.prior.mean = s.threshold;
      begin = now();
      const BaselineResult rrt = sparse_rrt_walk(
          terrain, s.threshold, s.start, *s.goal, options, [&] { return random.uniform(); });
      print("sparse GP, RRT*", seed, rrt, std::chrono::duration<double>(now() - begin).count());
    }
  }
}

int main_of(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "soundness") {
    return soundness_table(argc > 2 ? std::atoi(argv[2]) : 1000);
  }
  if (argc > 1 && std::string(argv[1]) == "trust") {
    return trust_table(argc > 2 ? std::atoi(argv[2]) : 300);
  }
  if (argc < 4) {
    std::fprintf(stderr,
                 "usage: terrain_study TERRAIN SCENARIO|all VARIANT|all [SEEDS]\n"
                 "       terrain_study TERRAIN baselines all [SEEDS]\n"
                 "       terrain_study soundness [TERRAINS]\n"
                 "       terrain_study trust [TERRAINS]\n");
    return 2;
  }
  const std::string wanted_scenario = argv[2];
  const std::string wanted_variant = argv[3];
  const int seeds = argc > 4 ? std::atoi(argv[4]) : 20;
  auto file = read_terrain(argv[1], {{}, TerrainHeader::yes});
  if (!file.terrain) {
    for (const table::Diagnostic& problem : file.diagnostics) {
      std::fprintf(stderr, "%s\n", table::to_string(problem).c_str());
    }
    return 65;
  }
  const Terrain terrain{{file.terrain->rows, file.terrain->columns},
                        std::move(file.terrain->values)};
  if (wanted_scenario == "baselines") {
    baseline_table(terrain, seeds);
    return 0;
  }
  const double lipschitz = lipschitz_bound(terrain.grid, terrain.values);
  std::fprintf(stderr, "Lipschitz bound %.3f\n", lipschitz);
  std::vector<Job> jobs;
  for (const Scenario& s : scenarios()) {
    Variant ahead = certified(s.threshold, lipschitz, terrain.at(s.start));
    ahead.name = "certified, look-ahead";
    ahead.rules.look_ahead = true;
    Variant trusting = ahead;
    trusting.name = "trusting the model";
    trusting.rules.trust_model = true;
    trusting.rules.beta = kTrustedBeta;
    Variant narrow = trusting;
    narrow.name = "trusting the model, beta 3";
    narrow.rules.beta = Rules{}.beta;
    Variant adaptive = ahead;
    adaptive.name = "certified, look-ahead, adaptive";
    adaptive.adaptive.on = true;
    Variant reactive = certified(s.threshold, lipschitz, terrain.at(s.start));
    reactive.name = "certified, reactive";
    reactive.motion = Motion::reactive;
    Variant batched = certified(s.threshold, lipschitz, terrain.at(s.start));
    batched.name = "certified, published batch";
    batched.batch = true;
    Variant published_adaptive = published(s.threshold);
    published_adaptive.name = "published, adaptive";
    published_adaptive.adaptive.on = true;
    for (const Variant& v : {published(s.threshold),
                             thesis_as_printed(s.threshold),
                             thesis_tuned(s.threshold, lipschitz),
                             certified(s.threshold, lipschitz, terrain.at(s.start)),
                             ahead,
                             trusting,
                             narrow,
                             adaptive,
                             reactive,
                             batched,
                             published_adaptive}) {
      for (int seed = 0; seed < seeds; ++seed) {
        const bool one = !v.batch && seed > 0;  // nothing is drawn
        if (!one && (wanted_scenario == "all" || wanted_scenario == s.name) &&
            (wanted_variant == "all" || wanted_variant == v.name)) {
          jobs.push_back({s, v, static_cast<std::uint64_t>(seed)});
        }
      }
    }
  }
  std::vector<std::string> lines(jobs.size());
  std::printf(
      "scenario,variant,seed,end,iterations,first,safe,unsafe_visits,unsafe_certified,travelled,"
      "step_s,ways,fallbacks,controller_cells,route_cells,certificate\n");
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    lines[i] = run(terrain, jobs[i]);
    std::fputs(lines[i].c_str(), stderr);
  });
  for (const std::string& line : lines) {
    std::fputs(line.c_str(), stdout);
  }
  return 0;
}

}  // namespace
}  // namespace tcert::terrain::study

int main(int argc, char** argv) { return tcert::terrain::study::main_of(argc, argv); }
