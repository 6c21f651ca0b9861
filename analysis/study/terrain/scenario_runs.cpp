#include "analysis/study/terrain/scenario_runs.hpp"

#include <tbb/parallel_for.h>

#include <mutex>
#include <table/random.hpp>
#include <terrain/lipschitz.hpp>
#include <utility>

namespace tcert::terrain::study {
namespace {

struct Job {
  Scenario scenario;
  Variant variant;
  std::uint64_t seed = 0;
};

/// What a run of "around" under the same variant and seed has measured.
std::vector<Measurement> map_of_around(const Terrain& terrain, const Job& job) {
  const Scenario around = scenarios()[1];
  std::vector<Measurement> known;
  const auto keep = [&](const Planner& planner, const ExploreStep&, const ExploreResult&) {
    known = planner.measurements();
  };
  ExploreSetup setup = setup_of(terrain, around, job.variant, job.seed);
  settle_by_start(setup, terrain);
  (void)explore(terrain, setup, keep);
  return known;
}

ScenarioRun run(const Terrain& terrain, const Job& job) {
  ExploreSetup setup = setup_of(terrain, job.scenario, job.variant, job.seed);
  if (job.scenario.reuse) {
    setup.known = map_of_around(terrain, job);
    if (job.variant.rules.kind == RuleSet::thesis) {
      for (const Measurement& m : setup.known) {
        setup.seeds.push_back(nearest_cell(m.at));
      }
    }
  }
  settle_by_start(setup, terrain);
  return {job.scenario.name,
          job.variant.name,
          job.seed,
          explore(terrain, setup),
          setup.first_cells.size() + 1};
}

std::vector<Job> jobs_of(const Terrain& terrain, std::size_t seeds) {
  const double lipschitz = lipschitz_bound(terrain.grid, terrain.values);
  std::vector<Job> jobs;
  for (const Scenario& scenario : scenarios()) {
    for (const Variant& variant : variants_of(scenario, terrain, lipschitz)) {
      for (std::uint64_t seed = 0; seed < (variant.batch ? seeds : 1); ++seed) {
        jobs.push_back({scenario, variant, seed});
      }
    }
  }
  return jobs;
}

}  // namespace

std::vector<Variant> variants_of(const Scenario& scenario,
                                 const Terrain& terrain,
                                 double lipschitz) {
  const Variant plain = certified(scenario.threshold, lipschitz, terrain.at(scenario.start));
  const auto changed = [](Variant variant, const char* name, const auto& change) {
    variant.name = name;
    change(variant);
    return variant;
  };
  const Variant ahead = changed(plain, "certified, look-ahead", [](Variant& v) {
    v.rules.selection = Selection::look_ahead;
  });
  const Variant trusting = changed(ahead, "trusting the model", [](Variant& v) {
    v.rules.trust_model = true;
    v.rules.beta = kTrustedBeta;
  });
  const Variant pursuing =
      changed(ahead, "certified, pursuit", [](Variant& v) { v.motion = Motion::pursuit; });
  const Variant horizon = changed(pursuing, "certified, horizon, pursuit", [](Variant& v) {
    v.rules.selection = Selection::horizon;
  });
  const auto bounded = [](Variant& v) { v.confidence = 0.95; };
  const auto band_of = [&](const char* name, double length_scale, Selection selection) {
    return changed(horizon, name, [&](Variant& v) {
      v.rules.kind = RuleSet::band;
      v.rules.beta = kTrustedBeta;
      v.rules.selection = selection;
      v.prior.length_scale = length_scale;
      v.confidence = 0.95;
    });
  };
  const Variant as_published = published(scenario.threshold);
  return {
      as_published,
      thesis_as_printed(scenario.threshold),
      thesis_tuned(scenario.threshold, lipschitz),
      plain,
      ahead,
      trusting,
      changed(
          trusting, "trusting the model, beta 3", [](Variant& v) { v.rules.beta = Rules{}.beta; }),
      changed(ahead, "certified, look-ahead, adaptive", [](Variant& v) { v.adaptive.on = true; }),
      changed(plain, "certified, reactive", [](Variant& v) { v.motion = Motion::reactive; }),
      changed(plain,
              "certified, reactive, 6 cells inside",
              [](Variant& v) {
                v.motion = Motion::reactive;
                v.sub_goal_depth = 6.0;
              }),
      changed(plain, "certified, pursuit", [](Variant& v) { v.motion = Motion::pursuit; }),
      changed(pursuing, "certified, look-ahead, pursuit", [](Variant&) {}),
      horizon,
      changed(pursuing,
              "certified, pareto, pursuit",
              [](Variant& v) { v.rules.selection = Selection::pareto; }),
      changed(horizon, "certified, horizon, pursuit, L bounded", bounded),
      band_of("band, half of 70 cells", 35.0, Selection::thesis),
      band_of("band, 70 cells", 70.0, Selection::thesis),
      band_of("band, half of 70 cells, pareto", 35.0, Selection::pareto),
      changed(plain, "certified, published batch", [](Variant& v) { v.batch = true; }),
      changed(as_published, "published, adaptive", [](Variant& v) { v.adaptive.on = true; })};
}

std::vector<ScenarioRun> run_scenarios(const Terrain& terrain,
                                       std::size_t seeds,
                                       const std::function<void(std::size_t, std::size_t)>& done) {
  const std::vector<Job> jobs = jobs_of(terrain, seeds);
  std::vector<ScenarioRun> runs(jobs.size());
  std::mutex counting;
  std::size_t finished = 0;
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    runs[i] = run(terrain, jobs[i]);
    const std::lock_guard lock(counting);
    done(++finished, jobs.size());
  });
  return runs;
}

std::vector<BaselineRun> run_baselines(const Terrain& terrain, std::size_t seeds) {
  std::vector<BaselineRun> runs;
  for (const Scenario& s : scenarios()) {
    if (!s.goal || s.reuse) {
      continue;
    }
    runs.push_back(
        {s.name, "straight walk", 0, straight_walk(terrain, {}, s.threshold, s.start, *s.goal)});
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      table::RandomStream random(seed, 0x7e44bc, 0);
      SparseRrtOptions options;
      options.prior.mean = s.threshold;
      runs.push_back({s.name,
                      "sparse GP, RRT*",
                      seed,
                      sparse_rrt_walk(terrain, s.threshold, s.start, *s.goal, options, [&] {
                        return random.uniform();
                      })});
    }
  }
  return runs;
}

}  // namespace tcert::terrain::study
