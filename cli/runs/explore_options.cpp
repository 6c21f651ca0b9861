#include "cli/runs/explore.hpp"

namespace tcert::cli {

OptionTable options_of(ExploreRequest& request) {
  OptionTable table(request.given);
  table.argument({"TERRAIN", &request.terrain, false, OptionRole::input});
  table.add_input("config", request.config, "FILE", "published configuration file (INI)");
  table.add("rules", request.rules, "RULES", "certified, thesis or published");
  table.add("start", request.start, "X,Y", "cell where the robot stands");
  table.add("goal", request.goal, "X,Y", "cell to be reached; none: explore");
  table.add(
      "mode", request.mode, "MODE", "navigate or explore; by default navigate if there is a goal");
  table.add(
      "header",
      request.header,
      "WHEN",
      "the first line is no data: yes, no, or auto: it has names, or 0, 1, 2, ... or other even "
      "steps far from the values below");
  table.add(
      "terrain-format", request.format, "HOW", "of TERRAIN and obstacles: auto, grid, xyz or esri");
  table.add(
      "nodata",
      request.nodata,
      "V",
      "value that means nothing is known; auto: -9999, -32768 and their kind if far outside the "
      "other values, and all beyond +-1e30; none: none");
  table.add("threshold", request.threshold, "H", "ground is safe at values of at least this");
  table.add(
      "lipschitz",
      request.lipschitz,
      "L",
      "largest slope per cell: give it if it is known; 'auto' is an estimate, several times "
      "too wide from one place, so that goals may not be reached (certified rules); published "
      "rules make the safe set without it");
  table.add("confidence",
            request.confidence,
            "P",
            "that no estimate of the Lipschitz constant in the run is too low");
  table.add("beta",
            request.beta,
            "B",
            "half-width of the model's band: sqrt(B) sd; published: B sd; 25 with --trust-model");
  table.add(
      "expanders", request.expanders, "N", "so many expanders nearest to the goal are considered");
  table.add(
      "kernel-variance",
      request.kernel_variance,
      "V",
      "of the model; certified rules take it from the Lipschitz constant unless it is a flag");
  table.add("kernel-length-scale", request.kernel_length_scale, "CELLS", "of the model");
  table.add("kernel-mean",
            request.kernel_mean,
            "M",
            "prior mean; certified rules take the value at the start unless it is a flag");
  table.add("noise-variance",
            request.noise_variance,
            "V",
            "of a measurement, in the model; at least 1e-10 of the kernel's is taken");
  table.add(
      "noise-bound", request.noise_bound, "E", "largest error of a measurement (certified rules)");
  table.add(
      "start-radius",
      request.start_radius,
      "CELLS",
      "cells round the start that are measured first (certified and thesis rules; published draws "
      "50 by --seed)");
  table.add("motion", request.motion, "HOW", "between measurements: route, reactive or jump");
  table.add(
      "simplification",
      request.simplification,
      "CELLS",
      "tolerance of outlines (reactive motion), and how deep within them samples and goal lie "
      "(published rules)");
  table.add("robot-radius",
            request.robot_radius,
            "CELLS",
            "erosion of the local free space of reactive motion, in the mapped "
            "plane; what is certified is cells, not the ground under a body");
  table.add("look-ahead",
            request.look_ahead,
            "choose by where the ground is expected to reach, the way counted (certified rules)");
  table.add("travel-weight", request.travel_weight, "W", "of the way in --look-ahead");
  table.add("adaptive", request.adaptive, "choose the length scale by likelihood on the way");
  table.add(
      "trust-model",
      request.trust_model,
      "the model's lower bound certifies too: fewer measurements, no proof; needs --beta 25 or "
      "more (certified rules)");
  table.add_input(
      "obstacles",
      request.obstacles,
      "FILE",
      "second layer, a terrain file of the same size: cells that are not 0, or gaps, are blocked");
  table.add("max-steps", request.max_steps, "N", "measurements at most");
  table.add("frames", request.frames, "N", "pictures, evenly spaced over the run");
  add_common(table, request);
  return table;
}

}  // namespace tcert::cli
