#include "cli/runs/replay.hpp"

#include <memory>
#include <optional>
#include <table/csv_write.hpp>

#include "cli/runs/certify_trials.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/result_folder.hpp"
#include "reports/audit.hpp"
#include "reports/features_table.hpp"
#include "reports/replay_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

std::string name_of(const SpeedLaw& law) {
  std::string name(study::to_string(law.kind));
  name += '_';
  table::append_number(name, law.beta_per_m);
  return name;
}

/// A config file or flags name the law or its sensitivity, and --laws and --betas do not.
bool is_law_configured(const ReplayRequest& request) {
  if (is_given(request.given, "laws") || is_given(request.given, "betas")) {
    return false;
  }
  const ParameterChanges& changes = request.logs.parameters;
  for (const Settings* const settings : {&changes.of_file, &changes.of_flags}) {
    for (const auto& [key, value] : *settings) {
      if (key == "speed_law" || key == "beta_per_m") {
        return true;
      }
    }
  }
  return false;
}

/// Cells before those of the audit log.
std::string audit_prefix(const study::ReplayRecord& record,
                         const std::optional<SyntheticLabel>& label) {
  std::string prefix;
  if (label) {
    prefix += (label->seed ? std::to_string(*label->seed) : "") + ',';
  }
  table::append_text(prefix, record.trial.trial_id);
  prefix += ',' + std::string(study::to_string(record.law.kind)) + ',';
  table::append_number(prefix, record.law.beta_per_m);
  return prefix + ',';
}

/// The files of a replay, written as trials come in.
class ReplayFiles {
 public:
  ReplayFiles(const ResultFolder& folder,
              const OpenedBundle& opened,
              const study::ReplaySetup& setup,
              bool series)
      : folder_(folder),
        parameters_(opened.parameters),
        robot_(study::with_overrides(opened.bundle.info.robot, opened.parameters.robot)),
        label_(synthetic_label(opened.bundle.info)),
        series_(series),
        risk_(setup.risk),
        rules_(names_of(setup.rules)),
        table_(replay_table()),
        replays_(folder.staging() / "replay.csv"),
        audit_(folder.staging() / "audit.csv") {
    table_.synthetic = label_;
    std::string header;
    append_csv_header(header, table_);
    replays_.write(header);
    audit_.write((label_ ? "synthetic_seed," : "") + std::string("trial_id,speed_law,beta_per_m,") +
                 audit_header());
  }

  /// Thread-safe: what is to be written of a trial, and the series at once.
  [[nodiscard]] std::string audit_of(const study::StudiedTrial& trial,
                                     const std::vector<study::ReplayedTrial>& replayed) const {
    std::string audit;
    for (const study::ReplayedTrial& one : replayed) {
      const std::string prefix = audit_prefix(one.record, label_);
      for (std::size_t i = 0; i < trial.ticks.size(); ++i) {
        append_audit_rows(audit,
                          trial.ticks[i],
                          trial.series.ticks[i],
                          one.acted[i],
                          parameters_.guards,
                          rules_,
                          prefix);
      }
      if (series_) {
        write_series(trial, one);
      }
    }
    return audit;
  }

  void add(const std::vector<study::ReplayRecord>& records, const std::string& audit) {
    std::string rows;
    for (const study::ReplayRecord& record : records) {
      append_csv_row(rows, table_, replay_row(record));
    }
    replays_.write(rows);
    audit_.write(audit);
  }

  void close() {
    replays_.close();
    audit_.close();
  }

 private:
  void write_series(const study::StudiedTrial& trial, const study::ReplayedTrial& one) const {
    SeriesFormat format{one.record.law, false, label_, true};
    format.risk = risk_;
    format.rules = rules_;
    format.validity = parameters_.certificate.obstacle_speed_mps > 0.0;
    std::string text = series_header(format, robot_);
    for (std::size_t i = 0; i < trial.ticks.size(); ++i) {
      const auto& yaw_rates = trial.ticks.yaw_rate_cmd_rps;
      append_series_row(text,
                        trial.ticks[i],
                        trial.series.ticks[i],
                        {},
                        format,
                        one.acted[i],
                        yaw_rates.empty() ? kMissing : yaw_rates[i]);
    }
    folder_.write(
        std::filesystem::path("series") / name_of(one.record.law) / (trial.row->trial_id + ".csv"),
        text);
  }

  const ResultFolder& folder_;
  const study::ParameterSet& parameters_;
  Robot robot_;
  std::optional<SyntheticLabel> label_;
  bool series_;
  bool risk_;
  std::vector<std::string> rules_;
  Table table_;
  ResultFile replays_;
  ResultFile audit_;
};

}  // namespace

OptionTable options_of(ReplayRequest& request) {
  OptionTable table(request.given);
  table.argument({"BUNDLE", &request.bundle, true, OptionRole::input});
  add_replay_law_options(table, request.laws);
  add_monitor_options(table, request.monitor);
  table.add("replan",
            request.replan,
            "ask for a new route by D* Lite whenever a guard begins to trip; counts replans, route "
            "changes and expansions, and those of a search from scratch");
  table.add("series", request.series, "also write margins and speeds, tick by tick");
  add_common(table, request);
  return table;
}

ExitCode replay(const ReplayRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty() && request.series) {
    throw UsageError("--series needs --output");
  }
  const OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  study::ReplaySetup setup =
      replay_setup(request.laws, opened.parameters, request.logs.decimal_comma, progress);
  if (is_law_configured(request)) {
    setup.laws = {opened.parameters.speed_law};
  }
  setup.replan = request.replan;
  setup.rules = rules_of(request.monitor);
  setup.risk = request.monitor.risk;
  if (setup.replan && !opened.bundle.info.course.goal) {
    throw UsageError("--replan needs a bundle with a goal");
  }
  std::optional<ResultFolder> folder;
  std::optional<ReplayFiles> files;
  if (!output.empty()) {
    require_apart(request.bundle, output);
    if (!request.laws.tracking_error.empty()) {
      require_apart(request.laws.tracking_error, output);
    }
    require_apart(request.monitor, output);
    folder.emplace(output, "replay");
    files.emplace(*folder, opened, setup, request.series);
  }
  ReplayTotals totals;
  const auto extra = [&](const study::StudiedTrial& trial) -> std::function<void()> {
    const auto replayed = study::replay_trial(trial, opened.bundle.info, opened.parameters, setup);
    auto records = std::make_shared<std::vector<study::ReplayRecord>>();
    for (const study::ReplayedTrial& one : replayed) {
      records->push_back(one.record);
    }
    auto audit = std::make_shared<std::string>(files ? files->audit_of(trial, replayed) : "");
    return [&, records, audit] {
      for (const study::ReplayRecord& record : *records) {
        totals.add(record);
      }
      if (files) {
        files->add(*records, *audit);
      }
    };
  };
  const CertifySummary summary = certify_trials(
      opened, request.threads, progress, folder ? &*folder : nullptr, {false}, {}, extra);
  Table table = totals.table();
  table.synthetic = synthetic_label(opened.bundle.info);
  table.n = static_cast<std::int64_t>(summary.trials);
  if (!folder) {
    show_found(table, totals.findings(), request.output, progress);
    return conclude(summary, opened, progress);
  }
  files->close();
  folder->write("replay_totals.csv", render(table, TableFormat::csv));
  Manifest manifest = manifest_of("replay", opened, written(request), summary);
  for (const auto& input :
       {tracking_error_input(request.laws.tracking_error), rules_input(request.monitor)}) {
    if (input) {
      manifest.inputs.push_back(*input);
    }
  }
  folder->commit(std::move(manifest));
  sum_up(totals.findings(), progress);
  return conclude(summary, opened, progress);
}

}  // namespace tcert::cli
