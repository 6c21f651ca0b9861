#include "cli/runs/gate.hpp"

#include <memory>

#include "analysis/study/gate/gate_study.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/thread_limit.hpp"
#include "reports/features_table.hpp"
#include "reports/gate_report.hpp"

namespace tcert::cli {
OptionTable options_of(GateRequest& request) {
  OptionTable table(request.given);
  table.argument({"BUNDLE", &request.bundle, true, OptionRole::input});
  table.add("level", request.level, "P", "of the intervals").within(1e-9, 1.0 - 1e-9);
  table.add("replicates", request.replicates, "R", "of the bootstrap; 0 leaves it out")
      .within(0, 1e6);
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  add_common(table, request);
  return table;
}

ExitCode gate(const GateRequest& request, Progress& progress) {
  const OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  if (!request.output.path.empty()) {
    require_apart(request.bundle, request.output.path);
  }
  ReportOutput output(request.output, "gate");
  const double approach_m = effective_robot(opened.bundle.info, opened.parameters).body_width_m;
  std::vector<study::GateRow> rows;
  const auto extra = [&](const study::StudiedTrial& trial) -> std::function<void()> {
    const study::GateRow row{
        trial.row->trial_id, trial.row->success, study::gate_pass(trial.series.ticks, approach_m)};
    return [&rows, row] { rows.push_back(row); };
  };
  const CertifySummary summary =
      certify_trials(opened, request.threads, progress, nullptr, {}, {}, extra);
  study::EvenChanceOptions options;
  options.level = request.level;
  options.replicates = static_cast<std::size_t>(request.replicates);
  options.seed = static_cast<std::uint64_t>(request.seed);
  const ThreadLimit limit(request.threads);
  FitReport result = gate_report(study::gate_study(std::move(rows), options));
  result.synthetic = synthetic_label(opened.bundle.info);
  Manifest manifest = manifest_of("gate", opened, written(request), summary);
  manifest.seed = options.seed;
  const bool failed = statistics::has_error(result.conditions);
  output.deliver(std::move(result), request.table, std::move(manifest), progress);
  return failed ? exit_bad_data : conclude(summary, opened, progress);
}

}  // namespace tcert::cli
