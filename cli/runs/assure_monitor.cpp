#include "cli/runs/assure_monitor.hpp"

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <utility>

#include "analysis/study/assurance/assurance.hpp"
#include "analysis/study/replay/replay_trial.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/result_folder.hpp"
#include "datasets/driven/truth_stream.hpp"
#include "datasets/perturb/read_injections.hpp"
#include "reports/assurance_report.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

std::vector<study::InjectedFault> faults_of(const perturb::InjectionsResult& injections,
                                            const std::string& trial_id) {
  std::vector<study::InjectedFault> faults;
  const auto found = injections.of_trial.find(trial_id);
  if (found != injections.of_trial.end()) {
    for (const perturb::InjectionRow& row : found->second) {
      faults.push_back({row.kind, {row.start_s, row.end_s}});
    }
  }
  return faults;
}

}  // namespace

OptionTable options_of(AssureMonitorRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, {"monitor"}});
  table.argument({"BUNDLE", &request.bundle, true, OptionRole::input});
  table.add_input("rules",
                  request.rules,
                  "FILE",
                  "watch those of a file in place of the default ones ('tcert help rules')");
  table.add("risk",
            request.risk,
            "hold what the risk field states of the way ahead against the truth, too");
  add_tracking_error_option(table, request.tracking_error);
  table
      .add("claim",
           request.claim,
           "P",
           "share of unsafe episodes that are claimed to be detected (the paper's 0.9)")
      .within(0.0, 1.0);
  table.add("table", request.table, "NAME", "only this table: monitors, faults, episodes, alarms");
  add_common(table, request);
  return table;
}

ExitCode assure_monitor(const AssureMonitorRequest& request, Progress& progress) {
  const MonitorOptions monitor{true, request.rules, false};
  const OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  const std::string& output_path = request.output.path;
  if (!output_path.empty()) {
    require_apart(request.bundle, output_path);
    require_apart(monitor, output_path);
  }
  if (request.risk && opened.parameters.risk.ahead_m > kTruthAhead) {
    throw UsageError(
        fmt::format("--risk: risk_ahead_m is {:g}, and truth.csv knows of {:g} m ahead",
                    opened.parameters.risk.ahead_m,
                    kTruthAhead));
  }
  const std::vector<Rule> rules = rules_of(monitor);
  const TrackingErrorTable tracking_error =
      tracking_error_table(request.tracking_error, request.logs.decimal_comma, progress);
  const perturb::InjectionsResult injections = perturb::read_injections(opened.bundle);
  progress.say(injections.diagnostics);
  if (table::has_error(injections.diagnostics)) {
    throw BadData("'" + request.bundle + "': its injections.csv cannot be used");
  }
  ReportOutput output(request.output, "assure");
  const Robot robot = study::with_overrides(opened.bundle.info.robot, opened.parameters.robot);
  std::vector<study::AssuredTrial> trials;
  std::vector<table::Diagnostic> problems;
  const auto extra = [&](const study::StudiedTrial& trial) -> std::function<void()> {
    ActionSetup setup =
        study::actions_of(robot, opened.parameters, opened.parameters.speed_law, tracking_error);
    setup.rules = rules;
    if (request.risk) {
      setup.risk = opened.parameters.risk;
    }
    TickActions actions(std::move(setup));
    const auto acted = study::act_trial(actions, trial.ticks, trial.series.ticks);
    TruthResult truth = read_truth(opened.bundle, trial.row->trial_id);
    study::AssuredTrial assured = study::assure_trial(trial.ticks,
                                                      acted,
                                                      rules.size(),
                                                      truth.samples,
                                                      opened.parameters.unsafe,
                                                      opened.parameters.risk.ahead_m,
                                                      faults_of(injections, trial.row->trial_id));
    assured.trial_id = trial.row->trial_id;
    assured.cluster = trial.row->day.empty() ? trial.row->trial_id : trial.row->day;
    return [&, assured = std::move(assured), said = std::move(truth.diagnostics)]() mutable {
      trials.push_back(std::move(assured));
      std::ranges::move(said, std::back_inserter(problems));
    };
  };
  const CertifySummary summary =
      certify_trials(opened, request.threads, progress, nullptr, {false}, {}, extra);
  progress.say(problems);
  const std::vector<std::string> names = names_of(rules);
  study::AssuranceOptions options;
  options.claim = request.claim;
  options.seed = static_cast<std::uint64_t>(request.seed);
  FitReport report = assurance_report(study::assurance_of(trials, names, options), trials, names);
  report.synthetic = synthetic_label(opened.bundle.info);
  Manifest manifest = manifest_of("assure", opened, written(request), summary);
  manifest.seed = options.seed;
  for (const auto& input : {tracking_error_input(request.tracking_error), rules_input(monitor)}) {
    if (input) {
      manifest.inputs.push_back(*input);
    }
  }
  output.deliver(std::move(report), request.table, std::move(manifest), progress);
  say_one_file(request.output, progress);
  return conclude(summary, opened, progress);
}

}  // namespace tcert::cli
