#include "cli/explore_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <terrain/rules.hpp>

#include "cli/explore_flags.hpp"
#include "cli/output.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Explore a terrain that is felt one cell at a time: measure, grow the ground that is certified
safe, go to the next cell, until the goal is joined or no cell can make the ground grow.

TERRAIN is a rectangle of numbers, higher is safer; x counts its lines, y its columns, from 0. Or a
list of points x,y,value on an evenly spaced lattice: x and y count its first and second coordinate
upwards. Or an ESRI ASCII grid (.asc): x counts its rows from north to south, y its columns from west
to east. All lengths, L and length scales are in cells, whatever a cell measures. Cells without a
number, beyond +-1e30, or of a nodata value (--nodata) are gaps: nobody measures or goes there.

--config reads the published configuration file ([environment] THRESHOLD = 1000, ...; STARTING_X and
GOAL_X are --start and --goal, FRAMECOUNT is --frames); flags go first. --rules: 'certified'
certifies by measurements and the Lipschitz constant alone; 'thesis' is Algorithm 1 as printed;
'published' is the published program. A flag that the rules would not look at is an error.

--trust-model lets the model certify too, from a band of sqrt(beta) sd; that proves nothing. Random
terrains of 300 in which it held an unsafe cell safe, L as given: beta 3 (1.73 sd) 145, 9 (3 sd) 72,
16 (4 sd) 11, 25 (5 sd, the default with --trust-model) 2, 36 (6 sd) 0.

Exit codes: 0 the goal is reached, or without a goal all is explored; otherwise, the result written
all the same, 4 not reachable at this threshold (or past the obstacles and gaps), 5 only the
Lipschitz constant (or the rule set) forbids it, 6 the goal is certified and joined but less than
--simplification cells within the outline (published rules), 7 the limit of --max-steps, 8 stranded
or nothing safe. 2, 65 and 66: wrong flags, a start, goal or terrain that cannot be, no such file.

With --output DIR: DIR/series.csv (one row a step), DIR/path.csv, DIR/frames/frame_*.svg and
DIR/manifest.json. Without it: the summary alone.

Usage: tcert explore TERRAIN --start X,Y [--goal X,Y] [options]

Example:
  tcert simulate terrain --output terrain.csv --seed 3
  tcert explore terrain.csv --start 300,200 --goal 420,260 --lipschitz 18 --output run
  tcert explore terrain.csv --config config.toml --rules published --header yes
  tcert explore dem.asc --start 20,30 --goal 10,50 --threshold 1000 --lipschitz 25 --nodata -9999
  tcert explore terrain.csv --start 300,200 --mode explore --max-steps 100 --lipschitz auto

Cost: 5 to 30 ms a step at 240,000 cells, and 60 MB at 500 measurements.
)";

}  // namespace

CommandLine explore_command_line(ExploreOptions& o) {
  CommandLine line{"explore",
                   kText,
                   uses_output | uses_seed,
                   po::options_description("Options"),
                   {{"TERRAIN", &o.terrain, false, OptionRole::input}}};
  const auto text = [](std::string& value, const char* name) {
    return po::value(&value)->value_name(name)->default_value(value);
  };
  const auto number = [](double& value, const char* name) {
    return po::value(&value)->value_name(name)->default_value(value);
  };
  const auto whole = [](std::int64_t& value, const char* name) {
    return po::value(&value)->value_name(name)->default_value(value);
  };
  line.own.add_options()("config", input(o.config, "FILE"), "published configuration file (INI)")(
      "rules", text(o.rules, "RULES"), "certified, thesis or published")(
      "start", text(o.start, "X,Y"), "cell where the robot stands")(
      "goal", text(o.goal, "X,Y"), "cell to be reached; none: explore")(
      "mode", text(o.mode, "MODE"), "navigate or explore; by default navigate if there is a goal")(
      "header",
      text(o.header, "WHEN"),
      "the first line is no data: yes, no, or auto: it has names, or 0, 1, 2, ... or other even "
      "steps far from the values below")(
      "terrain-format", text(o.format, "HOW"), "of TERRAIN and obstacles: auto, grid, xyz or esri")(
      "nodata",
      text(o.nodata, "V"),
      "value that means nothing is known; auto: -9999, -32768 and their kind if far outside the "
      "other values, and all beyond +-1e30; none: none")(
      "threshold", number(o.threshold, "H"), "ground is safe at values of at least this")(
      "lipschitz",
      text(o.lipschitz, "L"),
      "largest slope per cell: give it if it is known; 'auto' is an estimate, several times "
      "too wide from one place, so that goals may not be reached (certified rules); published "
      "rules make the safe set without it")(
      "confidence",
      number(o.confidence, "P"),
      "that no estimate of the Lipschitz constant in the run is too low")(
      "beta",
      number(o.beta, "B"),
      "half-width of the model's band: sqrt(B) sd; published: B sd; 25 with --trust-model")(
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
      "cells round the start that are measured first (certified and thesis rules; published draws "
      "50 by --seed)")(
      "motion", text(o.motion, "HOW"), "between measurements: route, reactive or jump")(
      "simplification",
      number(o.simplification, "CELLS"),
      "tolerance of outlines (reactive motion), and how deep within them samples and goal lie "
      "(published rules)")("robot-radius",
                           number(o.robot_radius, "CELLS"),
                           "erosion of the local free space of reactive motion, in the mapped "
                           "plane; what is certified is cells, not the ground under a body")(
      "look-ahead",
      po::bool_switch(&o.look_ahead),
      "choose by where the ground is expected to reach, the way counted (certified rules)")(
      "travel-weight", number(o.travel_weight, "W"), "of the way in --look-ahead")(
      "adaptive", po::bool_switch(&o.adaptive), "choose the length scale by likelihood on the way")(
      "trust-model",
      po::bool_switch(&o.trust_model),
      "the model's lower bound certifies too: fewer measurements, no proof; needs --beta 25 or "
      "more "
      "(certified rules)")(
      "obstacles",
      input(o.obstacles, "FILE"),
      "second layer, a terrain file of the same size: cells that are not 0, or gaps, are blocked")(
      "max-steps", whole(o.max_steps, "N"), "measurements at most")(
      "frames", whole(o.frames, "N"), "pictures, evenly spaced over the run");
  return line;
}

void apply_config(ExploreOptions& o, const CommonOptions& common) {
  if (o.config.empty()) {
    return;
  }
  const TerrainConfig file = read_terrain_config(o.config);
  for (const std::string& note : file.notes) {
    say(o.config + ": " + note);
  }
  const auto take = [&](const char* name, auto& into, const auto& from) {
    if (from && !is_given(common, name)) {
      // Whole numbers and bounds were checked as they were read.
      into = static_cast<std::decay_t<decltype(into)>>(*from);
    }
  };
  take("threshold", o.threshold, file.threshold);
  take("simplification", o.simplification, file.simplification);
  take("robot-radius", o.robot_radius, file.robot_radius);
  take("expanders", o.expanders, file.expanders);
  take("kernel-variance", o.kernel_variance, file.kernel_variance);
  take("kernel-length-scale", o.kernel_length_scale, file.kernel_lengthscale);
  take("beta", o.beta, file.beta);
  take("frames", o.frames, file.frames);
  take("start", o.start, file.start);
  o.beta_is_told = is_given(common, "beta") || file.beta.has_value();
  if (file.lipschitz && !is_given(common, "lipschitz")) {
    o.lipschitz = fmt::format("{}", *file.lipschitz);
  }
  // A goal by flag is to be gone to, and exploring by flag needs none.
  if (!is_given(common, "goal")) {
    take("mode", o.mode, file.mode);
    if (o.mode != "explore") {
      take("goal", o.goal, file.goal);
    }
  }
  if (o.terrain.empty() && file.filename) {
    // Beside the config file, as the program that it belongs to reads it.
    o.terrain = (std::filesystem::path(o.config).parent_path() / *file.filename).string();
  }
}

void settle_beta(ExploreOptions& o, const CommonOptions& common) {
  if (!o.trust_model) {
    return;
  }
  if (!o.beta_is_told && !is_given(common, "beta")) {
    o.beta = terrain::kTrustedBeta;
  } else if (o.beta < terrain::kTrustedBeta) {
    say(fmt::format(
        "warning: --trust-model certifies by a band of {:.3g} sd (--beta {:g}); at less "
        "than {:.3g} sd (--beta {:g}) it holds unsafe cells safe: see --help",
        std::sqrt(o.beta),
        o.beta,
        std::sqrt(terrain::kTrustedBeta),
        terrain::kTrustedBeta));
  }
}

}  // namespace tcert::cli
