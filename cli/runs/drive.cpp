#include "cli/runs/drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <set>
#include <stdexcept>
#include <utility>

#include "cli/runs/data_file.hpp"
#include "cli/runs/drive_by_lines.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/corpus/write_bundle.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kLightingTiers{Lighting::dark, Lighting::indoor, Lighting::outdoor};

constexpr std::array<std::pair<EndReason, const char*>, 4> kEnds{
    {{EndReason::goal, "reached G"},
     {EndReason::collision, "collided"},
     {EndReason::wedged, "were wedged"},
     {EndReason::timeout, "ran out of time"}}};

std::vector<Lighting> lightings_of(const std::string& list) {
  std::vector<Lighting> lightings;
  for (const std::string& word : words_of(list)) {
    const auto* const found =
        std::ranges::find_if(kLightingTiers, [&](Lighting one) { return name_of(one) == word; });
    if (found == kLightingTiers.end()) {
      throw UsageError("--lightings: found '" + word + "', expected Dark, Indoor or Outdoor");
    }
    if (std::ranges::find(lightings, *found) != lightings.end()) {
      throw UsageError("--lightings: found '" + word + "' twice");
    }
    lightings.push_back(*found);
  }
  return lightings.empty() ? std::vector(kLightingTiers.begin(), kLightingTiers.end()) : lightings;
}

/// What is driven: the experiment, its trials, and the index that the first is named by.
struct Driving {
  study::DrivenExperiment experiment;
  std::vector<study::DrivenCase> cases;
  std::uint64_t first = 0;
};

/// Trials of a world that is driven by every arm under every lighting; 1 in the paper's design.
std::uint64_t trials_of_world(const DriveRequest& request, const study::DrivenExperiment& all) {
  return request.worlds ? all.arms.size() * lightings_of(request.lightings).size() : 1;
}

/// The experiment, without its cases. \throws UsageError.
Driving experiment_of(const DriveRequest& request) {
  if (is_given(request.given, "name")) {
    throw UsageError("--name is that of a policy of your own: it needs --stdio or --listen");
  }
  Driving driving;
  study::DrivenExperiment& experiment = driving.experiment;
  experiment.parameters = effective_parameters({}, request.parameters);
  experiment.seed = static_cast<std::uint64_t>(request.seed);
  experiment.native_rates = request.native_rates;
  experiment.truth = request.truth;
  const bool is_crossed = request.worlds.has_value();
  if (!is_crossed && (!request.policies.empty() || !request.lightings.empty())) {
    throw UsageError(
        "--policies and --lightings need --worlds N: without it the cells of Table 1 "
        "are driven, as often as there");
  }
  if (is_crossed && is_given(request.given, "trials")) {
    throw UsageError("--trials and --worlds: expected one of them");
  }
  experiment.rules = rules_of({true, request.rules, false});
  try {
    experiment.arms = request.policies.empty()
                          ? study::paper_arms()
                          : study::parse_arms(request.policies, experiment.parameters.speed_law);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--policies: ") + error.what());
  }
  return driving;
}

/// With the cases of some trials, counted from the first that the request asks for.
Driving driving_of(const DriveRequest& request, ItemRange trials) {
  Driving driving = experiment_of(request);
  const std::uint64_t each = trials_of_world(request, driving.experiment);
  const auto from = static_cast<std::uint64_t>(request.from);
  driving.first = from * each + trials.first;
  if (!request.worlds) {
    driving.cases = study::paper_cases(driving.first, trials.last - trials.first);
    return driving;
  }
  const std::uint64_t first_world = trials.first / each;
  const std::uint64_t last_world = (trials.last + each - 1) / each;
  std::vector<study::DrivenCase> cases = study::crossed_cases(driving.experiment.arms.size(),
                                                              lightings_of(request.lightings),
                                                              from + first_world,
                                                              last_world - first_world);
  const auto begin = cases.begin() + static_cast<std::ptrdiff_t>(trials.first - first_world * each);
  driving.cases = {begin, begin + static_cast<std::ptrdiff_t>(trials.last - trials.first)};
  return driving;
}

/// The world that --from names, under the first lighting.
DrivenDesign design_by_lines(const DriveRequest& request) {
  for (const char* const name : {"policies", "worlds", "trials"}) {
    if (is_given(request.given, name)) {
      throw UsageError(
          "--" + std::string(name) +
          " does nothing to --stdio and --listen: one trial is driven, by what another "
          "process commands");
    }
  }
  study::DrivenExperiment experiment;
  experiment.arms = study::paper_arms();
  experiment.parameters = effective_parameters({}, request.parameters);
  experiment.seed = static_cast<std::uint64_t>(request.seed);
  experiment.native_rates = request.native_rates;
  experiment.truth = request.truth;
  const std::vector<Lighting> lightings = lightings_of(request.lightings);
  if (!request.lightings.empty() && lightings.size() > 1) {
    throw UsageError("--lightings: expected one for --stdio and --listen, which drive one trial");
  }
  const Lighting lighting = lightings.front();
  const std::uint64_t world = study::world_of(lighting, static_cast<std::uint64_t>(request.from));
  DrivenDesign design = study::design_of(experiment, {1, lighting, world}, 0);
  design.algorithm = request.name;
  return design;
}

SimulatedBundle bundle_of(const Driving& driving) {
  const study::DrivenExperiment& experiment = driving.experiment;
  SimulatedBundle bundle;
  bundle.info = driven_info(experiment.seed, experiment.parameters.drive, experiment.native_rates);
  bundle.extra_columns = driven_extra_columns();
  bundle.trials = driving.cases.size();
  // The first trial of a world writes its file.
  std::vector<bool> owns(driving.cases.size());
  std::set<std::uint64_t> worlds;
  for (std::size_t i = 0; i < owns.size(); ++i) {
    owns[i] = worlds.insert(driving.cases[i].world).second;
  }
  bundle.simulate = [&driving, owns = std::move(owns)](std::uint64_t i) {
    SimulatedTrial trial =
        study::drive_case(driving.experiment, driving.cases[i], driving.first + i).trial;
    trial.owns_world = owns[i];
    return trial;
  };
  return bundle;
}

Manifest manifest_of(const DriveRequest& request) {
  Manifest manifest;
  manifest.command = "drive";
  manifest.seed = static_cast<std::uint64_t>(request.seed);
  manifest.synthetic = SyntheticLabel{static_cast<std::uint64_t>(request.seed)};
  record(written(request), manifest);
  if (const auto input = rules_input({true, request.rules, false})) {
    manifest.inputs.push_back(*input);
  }
  return manifest;
}

}  // namespace

OptionTable options_of(DriveRequest& request) {
  OptionTable table(request.given);
  table
      .add("trials",
           request.trials,
           "N",
           "of the paper's design: blocks of 660, the cells of Table 1 with their numbers")
      .within(1, 1e7);
  table
      .add("worlds",
           request.worlds,
           "N",
           "in place of it: every policy in N worlds under every lighting, each lighting in worlds "
           "of its "
           "own, the same ones for all policies")
      .within(1, 1e6);
  table.add(
      "policies",
      request.policies,
      "LIST",
      "with --worlds: M1, M2, M3, TVFH, TD*Lite, CB-V, each as it is or with a law in the loop "
      "(+squash[BETA], +clip[BETA], +barrier[GAIN], +profile[BETA]), +guards, +monitor (rules back "
      "it out), +risk[WEIGHT] (a risk field), +A1 (no memory): M3,M3+squash20+monitor,CB-V");
  table.add_input(
      "rules",
      request.rules,
      "FILE",
      "that policies with +monitor watch, in place of the default ones ('tcert help rules')");
  table.add("lightings",
            request.lightings,
            "LIST",
            "with --worlds, --stdio or --listen: Dark, Indoor, Outdoor");
  table
      .add("from",
           request.from,
           "K",
           "begin with trial K of the design, or with the Kth of the N worlds, to make the rest "
           "elsewhere")
      .within(0, 1e9);
  table.add("native-rates",
            request.native_rates,
            "streams at 83, 50 and 20 Hz, as the robot logs them, instead of 20 Hz");
  table.add("truth",
            request.truth,
            "also write logs/<trial_id>/truth.csv: true pose, speed, force and free way ahead, for "
            "'assure monitor' and 'calibrate guards'");
  table.add("stdio",
            request.stdio,
            "one trial that another process drives: a line of what is sensed on stdout, a line "
            "'speed_mps,yaw_rate_rps' on stdin, at each control step");
  table.add("listen",
            request.listen,
            "WHERE",
            "the same over a socket, unix:PATH, that the other process connects to");
  table.add("name",
            request.name,
            "WORD",
            "with --stdio or --listen: what your policy is called in trials.csv");
  add_common(table, request);
  table.parameters(request.parameters);
  table.config_file();
  return table;
}

std::uint64_t trials_of(const DriveRequest& request) {
  if (request.stdio || !request.listen.empty()) {
    throw UsageError("--stdio and --listen drive one trial, which has no pieces");
  }
  const std::uint64_t worlds = static_cast<std::uint64_t>(request.worlds.value_or(request.trials));
  return worlds * trials_of_world(request, experiment_of(request).experiment);
}

void make_trials(const DriveRequest& request,
                 ItemRange trials,
                 const std::filesystem::path& folder) try {
  const Driving driving = driving_of(request, trials);
  write_simulated_bundle(folder, bundle_of(driving), {}, false);
} catch (const std::invalid_argument& error) {
  throw UsageError(error.what());
}

// Parameters that contradict each other show when a policy or a world is made of them.
ExitCode drive(const DriveRequest& request, Progress& progress) try {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output DIR");
  }
  if (request.stdio && !request.listen.empty()) {
    throw UsageError("--stdio and --listen: expected one of them");
  }
  if (request.stdio || !request.listen.empty()) {
    return drive_by_lines(
        design_by_lines(request), request.listen, output, manifest_of(request), progress);
  }
  const Driving driving = driving_of(request, {0, trials_of(request)});
  const ThreadLimit limit(request.threads);
  ResultFolder result(output, "drive");
  SimulatedBundle bundle = bundle_of(driving);
  std::array<std::atomic<std::uint64_t>, kEnds.size()> ended{};
  bundle.simulate = [&ended, drive_one = std::move(bundle.simulate)](std::uint64_t i) {
    SimulatedTrial trial = drive_one(i);
    for (std::size_t end = 0; end < kEnds.size(); ++end) {
      ended[end] += trial.row.end_reason == kEnds[end].first ? 1 : 0;
    }
    return trial;
  };
  {
    Stage stage(progress, "driving", bundle.trials);
    write_simulated_bundle(
        result.staging(),
        bundle,
        [&](std::uint64_t done, std::uint64_t /*total*/) { stage.reach(done); },
        true);
  }
  result.commit(manifest_of(request));
  std::string ends;
  for (std::size_t end = 0; end < kEnds.size(); ++end) {
    ends += fmt::format("{}{} {}", end == 0 ? "" : ", ", ended[end].load(), kEnds[end].second);
  }
  progress.sum_up(fmt::format("{} {} trials driven in {}: {}.",
                              to_string(SyntheticLabel{driving.experiment.seed}),
                              bundle.trials,
                              output,
                              ends));
  return exit_done;
} catch (const std::invalid_argument& error) {
  throw UsageError(error.what());
}

bool is_there(const DriveRequest& request) {
  return is_current(request.output.path, manifest_of(request));
}

}  // namespace tcert::cli
