#include "cli/runs/explore_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <terrain/limits.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/explore_rasters.hpp"
#include "cli/runs/progress.hpp"

namespace tcert::cli {
namespace {

/// A flag that acts under some rule sets alone.
struct Use {
  std::string_view option;
  std::vector<std::string_view> rules;
};

[[nodiscard]] std::vector<Use> uses() {
  return {{"noise-bound", {"certified"}},
          {"lipschitz", {"certified", "thesis", "published"}},
          {"confidence", {"certified", "band"}},
          {"noise-sd", {"certified", "band"}},
          {"gradient-prior", {"certified", "band"}},
          {"least-length-scale", {"band"}},
          {"selection", {"certified", "band"}},
          {"look-ahead", {"certified", "band"}},
          {"horizon", {"certified", "band"}},
          {"travel-weight", {"certified", "band"}},
          {"growth-weight", {"certified", "band"}},
          {"trust-model", {"certified"}},
          {"kernel-mean", {"certified", "thesis", "published"}},
          {"kernel-variance", {"certified", "thesis", "published"}},
          {"noise-variance", {"certified", "thesis", "published"}},
          {"start-radius", {"certified", "band", "thesis"}}};
}

[[nodiscard]] std::string names_of(const Use& use) {
  std::string names;
  for (const std::string_view name : use.rules) {
    names += (names.empty() ? "" : " or ") + std::string(name);
  }
  return names;
}

/// Flags that need another one.
void check_pairs(const ExploreRequest& o) {
  const std::string selection = selection_of(o);
  if (o.look_ahead && is_given(o.given, "selection") && o.selection != "look-ahead") {
    throw UsageError("--look-ahead is --selection look-ahead: leave out one of them");
  }
  if (is_given(o.given, "travel-weight") && selection == "thesis") {
    throw UsageError("--travel-weight has no effect under --selection thesis");
  }
  if (is_given(o.given, "horizon") && selection != "horizon") {
    throw UsageError("--horizon has no effect without --selection horizon");
  }
  if (is_given(o.given, "growth-weight") && selection != "pareto") {
    throw UsageError("--growth-weight has no effect without --selection pareto");
  }
  const bool reactive = motion_of(o) == "reactive";
  if (is_given(o.given, "sub-goal-depth") && (!reactive || o.rules == "published")) {
    throw UsageError(
        "--sub-goal-depth has no effect without --motion reactive, nor under --rules published, "
        "which have --simplification for it");
  }
  if (is_given(o.given, "simplification") && o.rules != "published" && !reactive) {
    throw UsageError(
        fmt::format("--simplification has no effect under --rules {} with --motion {}: "
                    "leave it out, or take --rules published or --motion reactive",
                    o.rules,
                    motion_of(o)));
  }
  const bool estimates = o.rules == "band" || o.lipschitz.empty() || o.lipschitz == "auto";
  if (is_given(o.given, "gradient-prior") && !estimates) {
    throw UsageError("--gradient-prior has no effect with a --lipschitz that is given");
  }
}

void check_uses(const ExploreRequest& o, Progress& progress) {
  for (const Use& use : uses()) {
    const bool acts = std::find(use.rules.begin(), use.rules.end(), o.rules) != use.rules.end();
    if (!acts && is_given(o.given, use.option)) {
      throw UsageError(
          fmt::format("--{0} has no effect under --rules {1}: leave it out, or take "
                      "--rules {2}",
                      use.option,
                      o.rules,
                      names_of(use)));
    }
  }
  check_pairs(o);
  if (is_given(o.given, "lipschitz") && o.rules == "published") {
    progress.say(
        "note: under --rules published --lipschitz acts on the expanders alone: the safe set is "
        "the "
        "model's.");
  }
  if (is_given(o.given, "robot-radius") && motion_of(o) != "reactive") {
    progress.say(fmt::format(
        "note: --robot-radius keeps the robot's body off the borders in the mapped plane "
        "of --motion reactive alone; under --motion {} it has no effect. --body makes that the "
        "ground under the body is certified.",
        motion_of(o)));
  }
  if (is_given(o.given, "seed") && o.rules != "published") {
    progress.say(
        fmt::format("note: --seed has no effect under --rules {}: nothing is drawn.", o.rules));
  }
}

void require_word(const char* option,
                  const std::string& value,
                  const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), value) != words.end()) {
    return;
  }
  std::string expected;
  for (const std::string& word : words) {
    expected += (expected.empty() ? "" : " or ") + word;
  }
  throw UsageError("--" + std::string(option) + ": found '" + value + "', expected " + expected +
                   did_you_mean(value, words));
}

void require_limit(std::string_view option, double value) {
  const terrain::Limit limit = terrain::limit_of(option);
  require_range(option, value, limit.low, limit.high);
}

}  // namespace

void check_limits(const ExploreRequest& o) {
  require_limit("threshold", o.threshold);
  require_limit("beta", o.beta);
  require_limit("expanders", static_cast<double>(o.expanders));
  require_limit("kernel-mean", o.kernel_mean);
  require_limit("kernel-variance", o.kernel_variance);
  require_limit("kernel-length-scale", o.kernel_length_scale);
  require_limit("noise-variance", o.noise_variance);
  require_limit("noise-bound", o.noise_bound);
  require_limit("confidence", o.confidence);
  require_limit("simplification", o.simplification);
  require_limit("robot-radius", o.robot_radius);
  require_limit("travel-weight", o.travel_weight);
  require_limit("horizon", static_cast<double>(o.horizon));
  require_limit("growth-weight", o.growth_weight);
  require_limit("noise-sd", o.noise_sd);
  require_limit("sub-goal-depth", o.sub_goal_depth);
  if (o.least_length_scale) {
    require_range("least-length-scale",
                  *o.least_length_scale,
                  terrain::limit_of("kernel-length-scale").low,
                  terrain::limit_of("kernel-length-scale").high);
  }
  require_limit("start-radius", static_cast<double>(o.start_radius));
  require_limit("max-steps", static_cast<double>(o.max_steps));
  require_limit("frames", static_cast<double>(o.frames));
  if (!o.lipschitz.empty() && o.lipschitz != "auto") {
    (void)lipschitz_of(o);
  }
}

double lipschitz_of(const ExploreRequest& o) {
  const std::string& text = o.lipschitz;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const terrain::Limit limit = terrain::limit_of("lipschitz");
  if (error != std::errc{} || end != text.data() + text.size() ||
      !terrain::is_within(limit, value)) {
    throw UsageError(
        fmt::format("--lipschitz: found '{}', expected a number above 0, from {:g} to {:g}{}",
                    text,
                    limit.low,
                    limit.high,
                    o.rules == "certified" ? ", or auto"
                    : text == "auto"       ? "; only --rules certified estimates it"
                                           : ""));
  }
  return value;
}

std::string motion_of(const ExploreRequest& o) {
  const bool certifies = o.rules == "certified" || o.rules == "band";
  return !o.motion.empty() ? o.motion : certifies ? "pursuit" : "route";
}

std::string selection_of(const ExploreRequest& o) {
  if (!o.selection.empty()) {
    return o.selection;
  }
  return o.look_ahead             ? "look-ahead"
         : o.rules == "certified" ? "horizon"
         : o.rules == "band"      ? "pareto"
                                  : "thesis";
}

void check(const ExploreRequest& o, Progress& progress) {
  if (o.terrain.empty()) {
    throw UsageError("needs TERRAIN, or a config file with environment.FILENAME");
  }
  require_word("rules", o.rules, {"certified", "band", "thesis", "published"});
  require_word("motion", motion_of(o), {"pursuit", "route", "reactive", "jump"});
  require_word("units", o.units, {"cells", "metres"});
  if (!o.baseline.empty()) {
    require_word("baseline", o.baseline, {"straight", "sparse-rrt"});
  }
  if (!o.rasters.empty() && o.output.path.empty()) {
    throw UsageError("--rasters needs --output DIR to write them to");
  }
  (void)raster_formats_of(o.rasters);
  require_word("selection", selection_of(o), {"horizon", "look-ahead", "pareto", "thesis"});
  if (!o.mode.empty()) {
    require_word("mode", o.mode, {"navigate", "explore"});
  }
  if (o.start.empty()) {
    throw UsageError("needs --start X,Y, or a config file with robot.STARTING_X and STARTING_Y");
  }
  if (o.mode == "navigate" && o.goal.empty()) {
    throw UsageError("navigating needs --goal X,Y; --mode explore does without");
  }
  if (o.mode == "explore" && is_given(o.given, "goal")) {
    throw UsageError("--goal has no effect under --mode explore: leave out one of them");
  }
  check_uses(o, progress);
  if (o.lipschitz == "auto" && o.rules != "certified") {
    (void)lipschitz_of(o);
  }
  check_limits(o);
}

}  // namespace tcert::cli
