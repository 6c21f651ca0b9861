#include "cli/explore_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <terrain/lipschitz.hpp>

#include "cli/errors.hpp"
#include "cli/output.hpp"
#include "datasets/random.hpp"

namespace tcert::cli {
namespace {

using terrain::Cell;
using terrain::Measurement;
using terrain::RuleSet;
using terrain::Terrain;

constexpr std::string_view kText =
    R"(Explore a terrain that is felt one cell at a time: measure, grow the ground that is certified
safe, go to the next cell, until the goal is joined or no cell can make the ground grow.

TERRAIN is a rectangle of numbers, higher is safer; x counts its lines, y its columns, from 0.
--config reads the published configuration file ([environment] THRESHOLD = 1000, ...); flags go
first. --rules: 'certified' certifies by measurements and the Lipschitz constant alone; 'thesis' is
Algorithm 1 as printed; 'published' is the published program.

With --output DIR: DIR/series.csv (one row a step), DIR/path.csv, DIR/frames/frame_*.svg and
DIR/manifest.json. Without it: the summary alone.

Usage: tcert explore TERRAIN --start X,Y [--goal X,Y] [options]

Example:
  tcert simulate terrain --output terrain.csv --seed 3
  tcert explore terrain.csv --start 300,200 --goal 420,260 --lipschitz 18 --output run
  tcert explore terrain.csv --config config.toml --rules published --header yes \
    --start 230,220 --goal 104,82
  tcert explore terrain.csv --start 300,200 --mode explore --max-steps 100 --lipschitz auto

Cost: 5 to 30 ms a step at 240,000 cells, and 60 MB at 500 measurements.
)";

[[nodiscard]] bool is_given(const CommonOptions& common, const char* name) {
  return std::find(common.given.begin(), common.given.end(), name) != common.given.end();
}

[[nodiscard]] double lipschitz_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0.0) ||
      !std::isfinite(value)) {
    throw UsageError("--lipschitz: found '" + text + "', expected a number above 0 or 'auto'");
  }
  return value;
}

/// The cells within `radius` of the start, the start not among them.
[[nodiscard]] std::vector<Cell> cells_round(const Terrain& terrain, Cell start, int radius) {
  std::vector<Cell> cells;
  for (int x = start.x - radius; x <= start.x + radius; ++x) {
    for (int y = start.y - radius; y <= start.y + radius; ++y) {
      const Cell c{x, y};
      if (terrain.grid.contains(c) && !(c == start) &&
          squared_distance(c, start) <= radius * radius) {
        cells.push_back(c);
      }
    }
  }
  return cells;
}

/// The published program's 50 draws round the start; those below the threshold are discarded.
[[nodiscard]] std::vector<Cell> published_batch(const Terrain& terrain,
                                                Cell start,
                                                double threshold,
                                                std::int64_t seed) {
  constexpr std::uint32_t kPurpose = 0x7e44ba;
  constexpr int kReach = 20;
  constexpr int kDraws = 50;
  RandomStream random(static_cast<std::uint64_t>(seed), kPurpose, 0);
  const auto draw = [&](int centre, int limit) {
    const int low = std::max(0, centre - kReach);
    const int high = std::min(limit, centre + kReach);
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low)));
  };
  std::vector<Cell> cells;
  for (int k = 0; k < kDraws; ++k) {
    const int x = draw(start.x, terrain.grid.rows);
    const int y = draw(start.y, terrain.grid.columns);
    if (terrain.at({x, y}) >= threshold) {
      cells.push_back({x, y});
    }
  }
  return cells;
}

[[nodiscard]] std::vector<Measurement> measured(const Terrain& terrain,
                                                const std::vector<Cell>& cells) {
  std::vector<Measurement> measurements;
  for (const Cell c : cells) {
    measurements.push_back({terrain::position(c), terrain.at(c)});
  }
  return measurements;
}

/// Lipschitz constant and prior of the certified rules, from what was measured round the start.
void set_certified(terrain::ExploreSetup& setup,
                   const ExploreOptions& o,
                   const CommonOptions& common,
                   const Terrain& terrain) {
  std::vector<Cell> around = setup.first_cells;
  around.push_back(setup.start);
  for (const Cell c : around) {
    if (terrain.at(c) - o.noise_bound < o.threshold) {
      throw BadData(
          fmt::format("the ground round the start is not safe: {} at ({}, {}) is below "
                      "the threshold {}; start elsewhere or lower --start-radius",
                      terrain.at(c),
                      c.x,
                      c.y,
                      o.threshold));
    }
  }
  const std::vector<Measurement> first = measured(terrain, around);
  const double steepest = terrain::steepest_measured(first, o.noise_bound);
  bool estimated = o.lipschitz.empty() || o.lipschitz == "auto";
  if (!estimated) {
    setup.rules.lipschitz = lipschitz_of(o.lipschitz);
    if (steepest > setup.rules.lipschitz * (1.0 + 1e-9)) {
      estimated = true;
      say(fmt::format(
          "warning: the Lipschitz constant {} is contradicted by the first measurements "
          "({:.3g} per cell); it is estimated instead. Give the terrain's own with "
          "--lipschitz.",
          setup.rules.lipschitz,
          steepest));
    }
  }
  if (estimated) {
    const auto estimate =
        terrain::estimate_lipschitz(terrain.grid,
                                    first,
                                    o.kernel_length_scale,
                                    o.noise_bound,
                                    terrain::confidence_of_estimate(o.confidence, 1));
    if (!std::isfinite(estimate.constant) || !(estimate.constant > 0.0)) {
      throw UsageError("the Lipschitz constant cannot be estimated from " +
                       std::to_string(first.size()) +
                       " measurements; give it with --lipschitz or raise --start-radius");
    }
    setup.rules.lipschitz = estimate.constant;
    setup.lipschitz_confidence = o.confidence;
    say(
        fmt::format("Lipschitz constant {:.4g} per cell at {:g} % confidence, from {} "
                    "measurements; raised where later ones ask for it.",
                    estimate.constant,
                    100.0 * o.confidence,
                    first.size()));
  }
  // The prior's scale is that of the data: a field whose steepest gradient is the constant.
  if (!is_given(common, "kernel-variance")) {
    const double factor = terrain::steepest_factor(terrain.grid, o.kernel_length_scale, 0.5);
    const double sd = setup.rules.lipschitz * o.kernel_length_scale / factor;
    setup.prior.variance = sd * sd;
  }
  if (!is_given(common, "kernel-mean")) {
    setup.prior.mean = terrain.at(setup.start);
  }
}

}  // namespace

CommandLine explore_command_line(ExploreOptions& o) {
  CommandLine line{"explore",
                   kText,
                   uses_output | uses_seed,
                   po::options_description("Options"),
                   {{"TERRAIN", &o.terrain, false}}};
  const auto text = [](std::string& value, const char* name) {
    return po::value(&value)->value_name(name)->default_value(value);
  };
  const auto number = [](double& value, const char* name) {
    return po::value(&value)->value_name(name)->default_value(value);
  };
  const auto whole = [](std::int64_t& value, const char* name) {
    return po::value(&value)->value_name(name)->default_value(value);
  };
  line.own.add_options()("config", text(o.config, "FILE"), "published configuration file (INI)")(
      "rules", text(o.rules, "RULES"), "certified, thesis or published")(
      "start", text(o.start, "X,Y"), "cell where the robot stands")(
      "goal", text(o.goal, "X,Y"), "cell to be reached; none: explore")(
      "mode", text(o.mode, "MODE"), "navigate or explore; by default navigate if there is a goal")(
      "header", text(o.header, "WHEN"), "the first line is no data: detect, yes or no")(
      "threshold", number(o.threshold, "H"), "ground is safe at values of at least this")(
      "lipschitz",
      text(o.lipschitz, "L"),
      "largest slope per cell: give it if it is known; 'auto' is an estimate, several times "
      "too wide from one place, so that goals may not be reached (certified rules)")(
      "confidence",
      number(o.confidence, "P"),
      "that no estimate of the Lipschitz constant in the run is too low")(
      "beta", number(o.beta, "B"), "half-width of the model's band: sqrt(B) sd; published: B sd")(
      "expanders", whole(o.expanders, "N"), "so many expanders nearest to the goal are considered")(
      "kernel-variance",
      number(o.kernel_variance, "V"),
      "of the model; certified rules take it from the Lipschitz constant unless it is a flag")(
      "kernel-length-scale", number(o.kernel_length_scale, "CELLS"), "of the model")(
      "kernel-mean",
      number(o.kernel_mean, "M"),
      "prior mean; certified rules take the value at the start unless it is a flag")(
      "noise-variance",
      number(o.noise_variance, "V"),
      "of a measurement, in the model; at least 1e-10 of the kernel's is taken")(
      "noise-bound",
      number(o.noise_bound, "E"),
      "largest error of a measurement (certified rules)")(
      "start-radius",
      whole(o.start_radius, "CELLS"),
      "cells round the start that are measured first (certified and thesis rules)")(
      "motion", text(o.motion, "HOW"), "between measurements: route, reactive or jump")(
      "simplification", number(o.simplification, "CELLS"), "tolerance of outlines")(
      "robot-radius", number(o.robot_radius, "CELLS"), "erosion of the local free space")(
      "look-ahead",
      po::bool_switch(&o.look_ahead),
      "choose by where the ground is expected to reach, the way counted (certified rules)")(
      "travel-weight", number(o.travel_weight, "W"), "of the way in --look-ahead")(
      "adaptive", po::bool_switch(&o.adaptive), "choose the length scale by likelihood on the way")(
      "trust-model",
      po::bool_switch(&o.trust_model),
      "the model's lower bound certifies too: fewer measurements, no proof (certified rules)")(
      "obstacles",
      text(o.obstacles, "FILE"),
      "second layer, a terrain file of the same size: cells that are not 0 are blocked")(
      "max-steps", whole(o.max_steps, "N"), "measurements at most")(
      "frames", whole(o.frames, "N"), "pictures, evenly spaced over the run");
  return line;
}

void apply_config(ExploreOptions& o, const CommonOptions& common) {
  if (o.config.empty()) {
    return;
  }
  const TerrainConfig file = read_terrain_config(o.config);
  const auto take = [&](const char* name, auto& into, const auto& from) {
    if (from && !is_given(common, name)) {
      into = static_cast<std::decay_t<decltype(into)>>(*from);
    }
  };
  take("threshold", o.threshold, file.threshold);
  take("simplification", o.simplification, file.simplification);
  take("robot-radius", o.robot_radius, file.robot_radius);
  take("mode", o.mode, file.mode);
  take("expanders", o.expanders, file.expanders);
  take("kernel-variance", o.kernel_variance, file.kernel_variance);
  take("kernel-length-scale", o.kernel_length_scale, file.kernel_lengthscale);
  take("beta", o.beta, file.beta);
  if (file.lipschitz && !is_given(common, "lipschitz")) {
    o.lipschitz = fmt::format("{}", *file.lipschitz);
  }
  if (o.terrain.empty() && file.filename) {
    // Beside the config file, as the program that it belongs to reads it.
    o.terrain = (std::filesystem::path(o.config).parent_path() / *file.filename).string();
  }
}

terrain::Cell cell_of(const std::string& option, const std::string& text) {
  Cell cell;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, cell.x);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ',') {
    const auto second = std::from_chars(first.ptr + 1, end, cell.y);
    if (second.ec == std::errc{} && second.ptr == end) {
      return cell;
    }
  }
  throw UsageError("--" + option + ": found '" + text +
                   "', expected a cell as X,Y with whole numbers");
}

void check(const ExploreOptions& o) {
  if (o.terrain.empty()) {
    throw UsageError("needs TERRAIN, or a config file with environment.FILENAME");
  }
  const auto one_of =
      [](const char* option, const std::string& value, const std::vector<std::string>& words) {
        if (std::find(words.begin(), words.end(), value) == words.end()) {
          std::string expected;
          for (const std::string& word : words) {
            expected += (expected.empty() ? "" : " or ") + word;
          }
          throw UsageError("--" + std::string(option) + ": found '" + value + "', expected " +
                           expected + did_you_mean(value, words));
        }
      };
  one_of("rules", o.rules, {"certified", "thesis", "published"});
  one_of("motion", o.motion, {"route", "reactive", "jump"});
  one_of("header", o.header, {"detect", "yes", "no"});
  if (!o.mode.empty()) {
    one_of("mode", o.mode, {"navigate", "explore"});
  }
  if (o.start.empty()) {
    throw UsageError("needs --start X,Y");
  }
  if (o.mode == "navigate" && o.goal.empty()) {
    throw UsageError("navigating needs --goal X,Y; --mode explore does without");
  }
  require_range("max-steps", static_cast<double>(o.max_steps), 0, 1e5);
  require_range("expanders", static_cast<double>(o.expanders), 1, 1e9);
  require_range("frames", static_cast<double>(o.frames), 0, 64);
  require_range("start-radius", static_cast<double>(o.start_radius), 0, 100);
  require_range("confidence", o.confidence, 0.5, 0.999999);
  require_range("kernel-length-scale", o.kernel_length_scale, 1e-3, 1e6);
  require_range("kernel-variance", o.kernel_variance, 1e-12, 1e18);
  require_range("noise-variance", o.noise_variance, 0.0, 1e18);
  require_range("noise-bound", o.noise_bound, 0.0, 1e18);
  require_range("beta", o.beta, 0.0, 1e6);
  require_range("simplification", o.simplification, 0.0, 1e4);
  require_range("robot-radius", o.robot_radius, 0.0, 1e4);
  require_range("travel-weight", o.travel_weight, 0.0, 1e6);
  require_range("threshold", o.threshold, -1e300, 1e300);
}

terrain::ExploreSetup explore_setup(const ExploreOptions& o,
                                    const CommonOptions& common,
                                    const Terrain& terrain) {
  terrain::ExploreSetup setup;
  setup.rules.kind = *terrain::rule_set_from(o.rules);
  setup.rules.threshold = o.threshold;
  setup.rules.beta = o.beta;
  setup.rules.expanders = static_cast<int>(std::min<std::int64_t>(o.expanders, 1'000'000'000));
  setup.rules.noise_bound = o.noise_bound;
  setup.rules.trust_model = o.trust_model;
  setup.rules.look_ahead = o.look_ahead;
  setup.rules.travel_weight = o.travel_weight;
  setup.prior = {o.kernel_mean, o.kernel_variance, o.kernel_length_scale, o.noise_variance};
  setup.start = cell_of("start", o.start);
  if (!o.goal.empty() && o.mode != "explore") {
    setup.goal = cell_of("goal", o.goal);
  }
  for (const auto& [name, cell] :
       {std::pair{"start", std::optional(setup.start)}, std::pair{"goal", setup.goal}}) {
    if (cell && !terrain.grid.contains(*cell)) {
      throw UsageError(fmt::format("--{}: ({}, {}) lies outside the terrain of {} x {} cells",
                                   name,
                                   cell->x,
                                   cell->y,
                                   terrain.grid.rows,
                                   terrain.grid.columns));
    }
  }
  setup.max_steps = static_cast<int>(o.max_steps);
  setup.motion = *terrain::motion_from(o.motion);
  setup.simplification = o.simplification;
  setup.robot_radius = o.robot_radius;
  setup.adaptive.on = o.adaptive;
  if (setup.rules.kind == RuleSet::published) {
    setup.first_cells = published_batch(terrain, setup.start, o.threshold, common.seed);
  } else {
    setup.first_cells = cells_round(terrain, setup.start, static_cast<int>(o.start_radius));
  }
  if (setup.rules.kind == RuleSet::certified) {
    set_certified(setup, o, common, terrain);
    return setup;
  }
  if (!o.lipschitz.empty()) {
    setup.rules.lipschitz = lipschitz_of(o.lipschitz);
  }
  if (setup.rules.kind == RuleSet::thesis) {
    // S_0 is what was measured and found safe.
    setup.seeds = setup.first_cells;
    setup.seeds.push_back(setup.start);
    std::erase_if(setup.seeds, [&](Cell c) { return terrain.at(c) < o.threshold; });
    if (setup.seeds.empty()) {
      throw BadData("no cell round the start is safe, and Algorithm 1 needs a safe seed set");
    }
  }
  if (terrain.at(setup.start) < o.threshold) {
    say(fmt::format(
        "warning: the start ({}, {}) stands on unsafe ground: {} is below the threshold "
        "{}.",
        setup.start.x,
        setup.start.y,
        terrain.at(setup.start),
        o.threshold));
  }
  return setup;
}

}  // namespace tcert::cli
