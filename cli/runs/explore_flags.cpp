#include "cli/runs/explore_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <terrain/limits.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"

namespace tcert::cli {
namespace {

/// A flag that acts under some rule sets alone.
struct Use {
  std::string_view option;
  bool certified;
  bool thesis;
  bool published;
};
constexpr std::array kUses{Use{"noise-bound", true, false, false},
                           Use{"confidence", true, false, false},
                           Use{"look-ahead", true, false, false},
                           Use{"travel-weight", true, false, false},
                           Use{"trust-model", true, false, false},
                           Use{"start-radius", true, true, false}};

[[nodiscard]] std::string names_of(const Use& use) {
  std::string names;
  for (const auto& [acts, name] : {std::pair{use.certified, "certified"},
                                   {use.thesis, "thesis"},
                                   {use.published, "published"}}) {
    if (acts) {
      names += (names.empty() ? "" : " or ") + std::string(name);
    }
  }
  return names;
}

void check_uses(const ExploreRequest& o, Progress& progress) {
  for (const Use& use : kUses) {
    const bool acts = o.rules == "certified" ? use.certified
                      : o.rules == "thesis"  ? use.thesis
                                             : use.published;
    if (!acts && is_given(o.given, use.option)) {
      throw UsageError(
          fmt::format("--{0} has no effect under --rules {1}: leave it out, or take "
                      "--rules {2}",
                      use.option,
                      o.rules,
                      names_of(use)));
    }
  }
  if (is_given(o.given, "travel-weight") && !o.look_ahead) {
    throw UsageError("--travel-weight has no effect without --look-ahead");
  }
  if (is_given(o.given, "simplification") && o.rules != "published" && o.motion != "reactive") {
    throw UsageError(
        fmt::format("--simplification has no effect under --rules {} with --motion {}: "
                    "leave it out, or take --rules published or --motion reactive",
                    o.rules,
                    o.motion));
  }
  if (is_given(o.given, "lipschitz") && o.rules == "published") {
    progress.say(
        "note: under --rules published --lipschitz acts on the expanders alone: the safe set is "
        "the "
        "model's.");
  }
  if (is_given(o.given, "robot-radius") && o.motion != "reactive") {
    progress.say(fmt::format(
        "note: --robot-radius keeps the robot's body off the borders in the mapped plane "
        "of --motion reactive alone; under --motion {} it has no effect. Under either "
        "motion what is certified is cells, not the ground under a body.",
        o.motion));
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
  require_limit("start-radius", static_cast<double>(o.start_radius));
  require_limit("max-steps", static_cast<double>(o.max_steps));
  require_limit("frames", static_cast<double>(o.frames));
  if (!o.lipschitz.empty() && o.lipschitz != "auto") {
    (void)lipschitz_of(o);
  }
}

}  // namespace

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

void check(const ExploreRequest& o, Progress& progress) {
  if (o.terrain.empty()) {
    throw UsageError("needs TERRAIN, or a config file with environment.FILENAME");
  }
  require_word("rules", o.rules, {"certified", "thesis", "published"});
  require_word("motion", o.motion, {"route", "reactive", "jump"});
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
