#include "cli/runs/import_barn.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/runs/barn_trials.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/import/import_barn.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {
namespace {

std::vector<std::string> trial_files(const ImportBarnRequest& request) {
  if (request.trials.empty()) {
    throw UsageError("needs --trials FILE");
  }
  std::vector<std::string> files = request.trials;
  files.insert(files.end(), request.more_trials.begin(), request.more_trials.end());
  return files;
}

std::string in_quotes(const std::vector<std::string>& files) {
  return "'" + files.front() + "'" +
         (files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : "");
}

void require_known(const std::vector<std::string>& wanted, const std::vector<std::string>& known) {
  if (!wanted.empty() && known.empty()) {
    throw UsageError("--planners: the trials have no column planner");
  }
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UsageError("--planners: no trial of '" + name + "'" + did_you_mean(name, known));
    }
  }
}

void sum_up(const BarnSummary& s, Progress& progress) {
  std::string groups;
  for (const auto& [name, rows] : s.groups) {
    groups += fmt::format("{}{} {}", groups.empty() ? "" : ", ", name, rows);
  }
  progress.sum_up(fmt::format("{} of {} trials written: {} successes, {} worlds, {} {}s ({})",
                              s.written,
                              s.read,
                              s.successes,
                              s.worlds,
                              s.groups.size(),
                              s.group,
                              groups));
  progress.sum_up(fmt::format(
      "left out: {} with errors, {} of planners not asked for, {} of another port, {} in "
      "worlds with moving obstacles, {} in worlds without metrics",
      s.bad,
      s.not_asked_for,
      s.other_ports,
      s.moving,
      s.unmeasured));
}

}  // namespace

OptionTable options_of(ImportBarnRequest& request) {
  OptionTable table(request.given);
  table.argument({"FORMAT", &request.format, true, OptionRole::shapes, {"barn"}});
  table.rest(request.more_trials);
  table.add_inputs("trials",
                   request.trials,
                   "FILE",
                   "outcomes: result text (dwa_out.txt), trials.csv or mlda_dated.csv; repeatable");
  table.add("planner",
            request.planner,
            "NAME",
            "whose trials result text holds; else by the file: dwa of dwa_out.txt");
  table.add_input("metrics", request.metrics, "FILE", "difficulty_metrics.csv");
  table.add(
      "planners", request.planners, "NAMES", "keep these, comma between; all if it is not given");
  table.add("same-port", request.same_port, "leave out ros2_maity and mppi_ros2");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode import_barn(const ImportBarnRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output FILE");
  }
  require_own_file(output);
  const std::vector<std::string> files = trial_files(request);
  const BarnTrials trials = read_barn_trials(files, request.planner, progress);
  const BarnTable metrics = read_barn_table("metrics", request.metrics, progress);
  BarnImportOptions barn;
  barn.planners = words_of(request.planners);
  if (!request.planners.empty() && (',' + request.planners + ',').find(",,") != std::string::npos) {
    throw UsageError("--planners: found '" + request.planners + "', expected names, comma between");
  }
  barn.other_ports = !request.same_port;
  require_known(barn.planners, planners_of(trials.tables));
  if (request.same_port && planners_of(trials.tables).empty()) {
    throw UsageError("--same-port: the trials have no column planner");
  }
  const BarnImportResult result = tcert::import_barn(trials.tables, metrics, barn);
  progress.say(result.diagnostics);
  sum_up(result.summary, progress);
  if (!result.csv) {
    const bool measured = result.summary.unmeasured == 0;
    throw BadData(measured ? "no trial of " + in_quotes(files) + " can be used"
                           : "'" + request.metrics + "' has no metrics for the worlds of " +
                                 in_quotes(files));
  }
  Manifest manifest;
  manifest.command = "import barn";
  record(written(request), manifest);
  for (const std::string& file : files) {
    manifest.inputs.push_back({name_of(file), digest_file(file)});
  }
  manifest.inputs.push_back({name_of(request.metrics), digest_file(request.metrics)});
  write_with_manifest(output, *result.csv, std::move(manifest));
  return trials.has_errors || table::has_error(result.diagnostics) ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
