#include "cli/runs/explore.hpp"

namespace tcert::cli {

void add_explore_options(OptionTable& table, ExploreRequest& request) {
  table.add_input("config", request.config, "FILE", "published configuration file (INI)");
  table.add("rules", request.rules, "RULES", "certified, band, thesis or published");
  table.add("start", request.start, "X,Y", "cell where the robot stands");
  table.add("goal",
            request.goal,
            "X,Y",
            "cell to be reached, or several in turn with ; between; none: explore");
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
      "largest slope per cell: give it if it is known; 'auto' is a bound that falls as more is "
      "measured (certified rules); published rules make the safe set without it, band has none");
  table.add("confidence",
            request.confidence,
            "P",
            "that no bound of the terrain's variance in the run, and so none of the Lipschitz "
            "constant, is too low (certified rules with auto, band)");
  table.add(
      "noise-sd",
      request.noise_sd,
      "SD",
      "of a measurement's Gaussian error, for these bounds and the band, which are too low if it "
      "is overstated; certified rules take from it the --noise-bound that all measurements keep "
      "at --confidence");
  table.add("gradient-prior",
            request.gradient_prior,
            "SD,PLACES",
            "standard deviation of the slope along one axis on earlier ground of this kind, and so "
            "many independent places it is worth, for these bounds");
  table.add("least-length-scale",
            request.least_length_scale,
            "CELLS",
            "band: the terrain's own is no shorter; by default half of --kernel-length-scale");
  table.add(
      "beta",
      request.beta,
      "B",
      "half-width of the model's band: sqrt(B) sd; published: B sd; 25 with --trust-model and "
      "under band");
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
  table.add_input("known",
                  request.known,
                  "FILE",
                  "measurements of an earlier run, a CSV with columns x, y and value: its "
                  "measurements.csv");
  table.add("motion",
            request.motion,
            "HOW",
            "between measurements: pursuit of the route in line of sight (certified rules and "
            "band, unless given), route (other rules), reactive or jump");
  table.add(
      "sub-goal-depth",
      request.sub_goal_depth,
      "CELLS",
      "reactive motion: so deep within the ground the controller drives, and a route goes the "
      "rest; published rules have --simplification for it");
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
            "plane; what must be certified to stand is --body");
  table.add(
      "body",
      request.body,
      "LENGTHS",
      "stand and go only where all ground under the body is certified: R, a disc's radius in "
      "cells, or LENGTH,WIDTH[,YAW] of a box, with its yaw in degrees from x towards y, which "
      "it keeps");
  table.add(
      "selection",
      request.selection,
      "HOW",
      "of the next cell (certified rules, band): horizon, a sequence of expected measurements "
      "(certified rules, unless given), look-ahead, one, pareto, growth against cost (band, "
      "unless given), or thesis, the widest interval");
  table.add("look-ahead", request.look_ahead, "the same as --selection look-ahead");
  table.add("horizon", request.horizon, "N", "measurements that --selection horizon looks ahead");
  table.add("travel-weight",
            request.travel_weight,
            "W",
            "of the way to a cell, by all selections but the thesis'");
  table.add("growth-weight",
            request.growth_weight,
            "W",
            "of the probability of growth in --selection pareto, 0 to 1");
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
  table.add(
      "units",
      request.units,
      "WORD",
      "of lengths, slopes and places that are given by flag: cells, or metres of the map that "
      "an ESRI grid, a list of points or --cell-size says (start radius and kernel defaults "
      "stay in cells)");
  table
      .add("cell-size",
           request.cell_size,
           "M",
           "metres from one line of a rectangle to the next, of a file that does not say so")
      .within(1e-6, 1e6);
  table.add(
      "rasters",
      request.rasters,
      "FORMATS",
      "what is known of every cell at the end, as DIR/rasters/*: asc (ESRI ASCII), csv (x, y, "
      "value), png, comma between");
  table.add("baseline",
            request.baseline,
            "METHOD",
            "what the method is compared with in its place: straight, a walk to the goal, or "
            "sparse-rrt, a sparse process seen from afar under RRT* (--seed)");
  table.add("max-steps", request.max_steps, "N", "measurements at most");
  table.add("frames", request.frames, "N", "pictures, evenly spaced over the run");
}

OptionTable options_of(ExploreRequest& request) {
  OptionTable table(request.given);
  table.argument({"TERRAIN", &request.terrain, false, OptionRole::input});
  add_explore_options(table, request);
  add_common(table, request);
  return table;
}

}  // namespace tcert::cli
