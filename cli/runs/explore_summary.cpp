#include "cli/runs/explore_summary.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tcert::cli {
namespace {

using terrain::End;
using terrain::ExploreResult;
using terrain::ExploreSetup;

/// What stands between the robot and the goal, by the end that was found.
[[nodiscard]] std::string reason(const ExploreResult& result, const ExploreSetup& setup) {
  switch (result.end) {
    case End::not_reachable:
      return "is not reachable at this threshold: no way from the start keeps it";
    case End::past_obstacles:
      return "is not reachable at this threshold: ways that keep it lead through obstacles or gaps";
    case End::only_body:
      return "is reachable at this threshold, but not by this body: ways that keep it are too "
             "narrow";
    case End::only_lipschitz:
      return fmt::format(
          "is reachable at this threshold, but not by what L = {:.6g}{} certifies; {}",
          result.last().lipschitz,
          setup.rules.noise_bound > 0.0 ? " and the noise bound" : "",
          setup.confidence > 0.0
              ? "this L was bounded from the measurements: give the terrain's own "
                "(--lipschitz), or measure more round the start (--start-radius)"
              : "a smaller L that still bounds the terrain's slopes, or a lower "
                "threshold, may do it");
    case End::only_rules:
      return fmt::format("is reachable at this threshold, but not by the rule set '{}'",
                         terrain::to_string(setup.rules.kind));
    case End::step_limit:
      return "was not reached in so many measurements (--max-steps)";
    default:
      return {};
  }
}

/// Where a robot is stranded, and what may have held it.
[[nodiscard]] std::string where_it_strands(const ExploreResult& result, const ExploreSetup& setup) {
  const bool has_body = setup.body.kind != terrain::Body::Kind::point;
  const bool has_begun = result.steps.size() > 1;
  const terrain::Position& at = result.path.back();
  return fmt::format(
      "the {} ({}, {}) {}: {} cells are certified{}\n",
      has_begun ? "robot stands at" : "start",
      at.x(),
      at.y(),
      has_body ? "has ground under the body that is not certified, or the map's edge"
               : "is not certified any more, by what was measured since",
      result.last().safe,
      has_body && !has_begun ? "; --start-radius measures more round the start" : "");
}

[[nodiscard]] std::string how_it_ended(const ExploreResult& result, const ExploreSetup& setup) {
  std::string text = fmt::format("end: {}\n", terrain::to_string(result.end));
  if (result.end == End::stranded) {
    text += where_it_strands(result, setup);
  }
  if (!setup.goal) {
    return text;
  }
  if (!setup.more_goals.empty()) {
    text +=
        fmt::format("goals reached: {} of {}\n", result.goals_reached, setup.more_goals.size() + 1);
  }
  if (result.end == End::goal_at_edge) {
    return text + fmt::format(
                      "the goal ({}, {}) is certified and joined, but less than {:g} cells "
                      "(--simplification) within the outline, where the published rules do "
                      "not end\n",
                      result.goal.x,
                      result.goal.y,
                      setup.simplification);
  }
  const std::string why = reason(result, setup);
  if (!why.empty()) {
    text += fmt::format(
        "the goal ({}, {}) {}: {} cells are certified, and the frontier stands at ({}, {}), {:.1f} "
        "cells from the goal\n",
        result.goal.x,
        result.goal.y,
        why,
        result.last().safe,
        result.frontier.x(),
        result.frontier.y(),
        (terrain::position(result.goal) - result.frontier).norm());
  }
  return text;
}

[[nodiscard]] std::string certificate(const ExploreResult& result) {
  const auto& value = result.last().certificate;
  if (!value && (result.end == End::reached || result.end == End::goal_at_edge)) {
    return "certificate: NA (the start is not on certified ground)\n";
  }
  if (!value) {
    return "certificate: NA (start and goal are not joined over certified ground)\n";
  }
  return std::isfinite(*value)
             ? fmt::format("certificate: {:.6g}\n", *value)
             : "certificate: NA (the rules give no lower bound of the ground on the way)\n";
}

}  // namespace

ExitCode exit_code_of(End end) noexcept {
  switch (end) {
    case End::reached:
    case End::explored:
      return exit_done;
    case End::not_reachable:
    case End::past_obstacles:
    case End::only_body:
      return exit_not_reachable;
    case End::exhausted:
    case End::only_lipschitz:
    case End::only_rules:
      return exit_only_rules;
    case End::goal_at_edge:
      return exit_at_edge;
    case End::step_limit:
      return exit_step_limit;
    case End::empty_safe_set:
    case End::stranded:
      break;
  }
  return exit_stranded;
}

std::string explore_summary(const ExploreResult& result, const ExploreSetup& setup, double cell_m) {
  const terrain::ExploreStep& last = result.last();
  std::string text = how_it_ended(result, setup);
  text += fmt::format(
      "rules: {}\nmeasurements: {}{} first, {} after\nsafe cells: {}\ntravelled: {:.1f} cells{}\n",
      terrain::to_string(setup.rules.kind),
      setup.known.empty() ? "" : fmt::format("{} known, ", setup.known.size()),
      setup.first_cells.size() + 1,
      result.steps.size() - 1,
      last.safe,
      last.travelled,
      cell_m > 0.0 ? fmt::format(", {:.1f} m", last.travelled * cell_m) : std::string());
  if (setup.goal) {
    text += certificate(result);
  }
  if (setup.rules.kind == terrain::RuleSet::band) {
    text += fmt::format(
        "assumed: a Gaussian field of length scale {:g} cells or more, certified by a band of {:g} "
        "sd\n",
        setup.prior.length_scale,
        setup.rules.band());
  } else {
    text += fmt::format("Lipschitz constant: {:.6g}\n", last.lipschitz);
  }
  text += fmt::format(
      "unsafe cells held to be safe, at most: {}\nsteps "
      "onto unsafe cells: {}\n",
      result.most_unsafe_certified,
      last.unsafe_visits);
  if (setup.motion == terrain::Motion::reactive) {
    text += fmt::format(
        "ways on which the controller arrived: {} of {}; a route finished the others\ngone by the "
        "controller: {:.1f} cells, by routes: {:.1f} cells\n",
        result.ways - result.controller_fallbacks,
        result.ways,
        result.controller_cells,
        result.route_cells);
  }
  return text;
}

}  // namespace tcert::cli
