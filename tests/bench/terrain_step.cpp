// Times of one planning step at full size, printed as JSON: what scripts/compare_with_numpy sets
// beside the direct way; and of the steps of explorations, as the robot's own loop plans them.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <table/random.hpp>
#include <terrain/planner.hpp>
#include <terrain/routes.hpp>
#include <terrain/session.hpp>
#include <vector>

#include "datasets/terrain/raster_text.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::terrain::study {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double quantile(std::vector<double> times, double share) {
  std::sort(times.begin(), times.end());
  const auto last = static_cast<double>(times.size() - 1);
  return times[static_cast<std::size_t>(share * last + 0.5)];
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// The layers of a plan as ESRI rasters: what `explore --rasters asc` adds to a step.
double raster_ms(const Planner& planner, Cell start) {
  const auto begin = std::chrono::steady_clock::now();
  const Grid& grid = planner.grid();
  const auto write = [&](std::span<const double> values, RasterRounding rounding) {
    return esri_raster({grid.rows, grid.columns, {values.begin(), values.end()}, {}}, rounding)
        .size();
  };
  const CellSet ground = planner.ground();
  std::size_t bytes =
      write(std::vector<double>(ground.begin(), ground.end()), RasterRounding::nearest);
  bytes += write(planner.proven(), RasterRounding::down);
  bytes += write(planner.possible(), RasterRounding::up);
  bytes += write(planner.model().mean(), RasterRounding::nearest);
  std::vector<double> sd(planner.model().variance().begin(), planner.model().variance().end());
  for (double& v : sd) {
    v = std::sqrt(std::max(v, 0.0));
  }
  bytes += write(sd, RasterRounding::up);
  bytes += write(widest_field(grid, ground, planner.proven(), planner.rules().threshold, start),
                 RasterRounding::down);
  return bytes > 0 ? 1e3 * seconds_since(begin) : 0.0;
}

/// Steps of the rules at 600 x 400 cells, timed in blocks of 50 measurements.
void run(RuleSet kind, int measurements) {
  TerrainFieldOptions field;
  const TerrainGrid made = random_terrain(field);
  const Grid grid{made.rows, made.columns};
  Rules rules;
  rules.kind = kind;
  rules.threshold = 1000.0;
  rules.lipschitz = kind == RuleSet::certified ? field.lipschitz : 0.003;
  GpPrior prior{0.0, 2.0, 30.0, 1.0};
  if (kind == RuleSet::certified) {
    prior = {1000.0, 80000.0, 30.0, 1.0};
  }
  if (kind == RuleSet::band) {
    prior = {1000.0, 1.0, 30.0, kBandNugget, true};
    rules.beta = kTrustedBeta;
  }
  rules.selection = kind == RuleSet::certified ? Selection::horizon : Selection::thesis;
  Planner planner(grid, rules, prior);
  if (kind == RuleSet::band) {
    planner.set_field_variance(80000.0);
  }
  table::RandomStream random(1, 0x7e44bd, 0);
  std::vector<double> block;
  std::vector<double> cpu;
  std::printf("{\"rules\": \"%s\", \"blocks\": [", std::string(to_string(kind)).c_str());
  for (int n = 1; n <= measurements; ++n) {
    const Cell c{static_cast<int>(random.below(600)), static_cast<int>(random.below(400))};
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu_begin = std::clock();
    planner.add({position(c), made.values[grid.index(c)]});
    planner.plan(Cell{300, 200}, c);
    block.push_back(1e3 * seconds_since(begin));
    cpu.push_back(1e3 * static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC);
    if (n % 50 == 0) {
      std::printf(
          "%s{\"n\": %d, \"median_ms\": %.3f, \"p99_ms\": %.3f, \"median_cpu_ms\": %.3f, "
          "\"p99_cpu_ms\": %.3f}",
          n == 50 ? "" : ", ",
          n,
          quantile(block, 0.5),
          quantile(block, 0.99),
          quantile(cpu, 0.5),
          quantile(cpu, 0.99));
      block.clear();
      cpu.clear();
    }
  }
  std::vector<double> rasters;
  const Cell start = nearest_cell(planner.measurements().front().at);
  for (int k = 0; k < 20; ++k) {
    const std::clock_t cpu_begin = std::clock();
    raster_ms(planner, start);
    rasters.push_back(1e3 * static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC);
  }
  std::printf("], \"rasters_median_cpu_ms\": %.3f, \"model_mb\": %.1f, \"peak_mb\": %.1f}",
              quantile(rasters, 0.5),
              static_cast<double>(planner.model().bytes()) / 1048576.0,
              peak_megabytes());
}

/// A robot that explores from the highest cell, told or not told the Lipschitz constant: all that
/// a line with plan 1 costs, in blocks of 50 steps; `most` is a step at which a bound changed.
void explore(RuleSet kind, bool is_told, int measurements) {
  TerrainFieldOptions field;
  const TerrainGrid made = random_terrain(field);
  const Grid grid{made.rows, made.columns};
  ExploreSetup setup;
  setup.rules.kind = kind;
  setup.rules.lipschitz = field.lipschitz;
  setup.rules.selection = kind == RuleSet::band ? Selection::pareto : Selection::horizon;
  setup.rules.beta = kind == RuleSet::band ? kTrustedBeta : setup.rules.beta;
  setup.prior.length_scale = kind == RuleSet::band ? 35.0 : 70.0;
  setup.confidence = 0.95;
  setup.motion = Motion::pursuit;
  const auto highest = std::max_element(made.values.begin(), made.values.end());
  setup.start = grid.cell(static_cast<std::size_t>(highest - made.values.begin()));
  Session session(grid, setup, {is_told, false, false});
  for (const Cell c : cells_round(grid, {}, setup.start, 2)) {
    session.take(c, made.values[grid.index(c)]);
  }
  std::printf("{\"explored_by\": \"%s%s\", \"blocks\": [",
              std::string(to_string(kind)).c_str(),
              kind == RuleSet::certified && !is_told ? ", auto" : "");
  std::vector<double> cpu;
  Cell robot = setup.start;
  for (int n = 1; n <= measurements; ++n) {
    const std::clock_t cpu_begin = std::clock();
    const Decision& decision = session.plan(robot, made.values[grid.index(robot)]);
    cpu.push_back(1e3 * static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC);
    if (n % 50 == 0 || decision.end) {
      std::printf(
          "%s{\"n\": %d, \"median_cpu_ms\": %.3f, \"p90_cpu_ms\": %.3f, \"most_cpu_ms\": %.3f}",
          n <= 50 ? "" : ", ",
          n,
          quantile(cpu, 0.5),
          quantile(cpu, 0.9),
          quantile(cpu, 1.0));
      cpu.clear();
    }
    if (decision.end) {
      break;
    }
    robot = nearest_cell(decision.way.back());
  }
  std::printf("]}");
}

}  // namespace
}  // namespace tcert::terrain::study

int main(int argc, char** argv) {
  using namespace tcert::terrain;
  const int measurements = argc > 1 ? std::atoi(argv[1]) : 500;
  std::printf("[");
  study::run(RuleSet::published, measurements);
  std::printf(", ");
  study::run(RuleSet::certified, measurements);
  std::printf(", ");
  study::run(RuleSet::band, measurements);
  std::printf(", ");
  study::explore(RuleSet::certified, true, measurements);
  std::printf(", ");
  study::explore(RuleSet::certified, false, measurements);
  std::printf(", ");
  study::explore(RuleSet::band, false, measurements);
  std::printf("]\n");
}
