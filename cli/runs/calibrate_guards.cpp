#include "cli/runs/calibrate_guards.hpp"

#include <functional>
#include <map>
#include <utility>

#include "analysis/study/assurance/guard_fit.hpp"
#include "analysis/study/replay/replay_trial.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/replay_options.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/thread_limit.hpp"
#include "datasets/driven/truth_stream.hpp"
#include "reports/features_table.hpp"
#include "reports/guard_fit_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kMostChoices = 10'000;

std::vector<double> values_of(const char* option,
                              const std::string& list,
                              double low,
                              double high) {
  std::vector<double> values = numbers_of(option, list);
  for (const double value : values) {
    require_range(option, value, low, high);
  }
  if (values.empty()) {
    throw UsageError("--" + std::string(option) + ": expected a number");
  }
  return values;
}

std::vector<study::GuardChoice> choices_of(const CalibrateGuardsRequest& request,
                                           const study::ParameterSet& parameters) {
  std::vector<study::GuardChoice> choices =
      study::guard_choices({parameters.speed_law, parameters.guards},
                           speed_laws_of(request.laws),
                           values_of("betas", request.betas, 1e-6, 1e6),
                           values_of("epsilons", request.epsilons, 0.0, 1e4),
                           values_of("forces", request.forces, 1e-6, 1e9));
  if (choices.empty() || choices.size() > kMostChoices) {
    throw UsageError("the lists make " + std::to_string(choices.size()) +
                     " choices, expected from 1 to " + std::to_string(kMostChoices));
  }
  return choices;
}

}  // namespace

OptionTable options_of(CalibrateGuardsRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, {"guards"}});
  table.argument({"BUNDLE", &request.bundle, true, OptionRole::input});
  table.add(
      "laws", request.laws, "LIST", "speed laws to choose from: squash, clip, barrier, profile");
  table.add("betas", request.betas, "LIST", "sensitivities s of the law, in 1/m");
  table.add("epsilons", request.epsilons, "LIST", "robust margins at which G3 halts, in m");
  table.add("forces", request.forces, "LIST", "F_min of the force envelope G2, in N");
  table
      .add("most-lost",
           request.most_lost,
           "P",
           "share of the unguarded progress that may be lost, and of trials that may stall")
      .within(0.0, 1.0);
  table
      .add("most-unsafe",
           request.most_unsafe,
           "P",
           "unsafe share of a new day's time that epsilon is to keep to")
      .within(1e-6, 1.0);
  table.add("folds", request.folds, "N", "of whole days").within(2, 1000);
  add_tracking_error_option(table, request.tracking_error);
  table.add("table", request.table, "NAME", "only this table");
  add_common(table, request);
  return table;
}

ExitCode calibrate_guards(const CalibrateGuardsRequest& request, Progress& progress) {
  const OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  if (!request.output.path.empty()) {
    require_apart(request.bundle, request.output.path);
  }
  std::vector<study::GuardChoice> choices = choices_of(request, opened.parameters);
  const Robot robot = study::with_overrides(opened.bundle.info.robot, opened.parameters.robot);
  const GuardSetup setup =
      study::actions_of(
          robot,
          opened.parameters,
          opened.parameters.speed_law,
          tracking_error_table(request.tracking_error, request.logs.decimal_comma, progress))
          .guards;
  ReportOutput output(request.output, "calibrate");
  std::vector<study::GuardedPath> paths;
  std::map<std::string, std::size_t> days;
  std::vector<table::Diagnostic> problems;
  const auto extra = [&](const study::StudiedTrial& trial) -> std::function<void()> {
    TruthResult truth = read_truth(opened.bundle, trial.row->trial_id);
    std::optional<study::GuardedPath> path;
    if (truth.samples) {
      path = study::guarded_path(trial.ticks, trial.series.ticks, *truth.samples, 0);
    }
    return [&,
            day = trial.row->day,
            path = std::move(path),
            said = std::move(truth.diagnostics)]() mutable {
      std::ranges::move(said, std::back_inserter(problems));
      if (path) {
        path->day = days.emplace(day, days.size()).first->second;
        paths.push_back(std::move(*path));
      }
    };
  };
  const CertifySummary summary =
      certify_trials(opened, request.threads, progress, nullptr, {false}, {}, extra);
  progress.say(problems);
  if (paths.empty()) {
    throw BadData(
        "'" + request.bundle +
        "': no trial has logs/<trial_id>/truth.csv, which says when it was unsafe; 'tcert "
        "drive --truth' writes it");
  }
  study::GuardFitOptions options;
  options.most_lost = request.most_lost;
  options.risk = request.most_unsafe;
  options.stall_m = opened.parameters.replay.stall_m;
  options.declared = {opened.parameters.speed_law, opened.parameters.guards};
  options.folds = static_cast<std::size_t>(request.folds);
  const ThreadLimit limit(request.threads);
  const study::GuardFit fit = study::fit_guards(
      paths, days.size(), setup, std::move(choices), opened.parameters.unsafe, options);
  FitReport report = guard_fit_report(fit, options, request.tracking_error);
  report.synthetic = synthetic_label(opened.bundle.info);
  Manifest manifest = manifest_of("calibrate", opened, written(request), summary);
  if (const auto input = tracking_error_input(request.tracking_error)) {
    manifest.inputs.push_back(*input);
  }
  output.deliver(std::move(report), request.table, std::move(manifest), progress);
  say_one_file(request.output, progress);
  return conclude(summary, opened, progress);
}

}  // namespace tcert::cli
