#include <memory>
#include <optional>
#include <table/csv_write.hpp>

#include "cli/certify_run.hpp"
#include "cli/errors.hpp"
#include "cli/guard_options.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/replay_options.hpp"
#include "cli/result_folder.hpp"
#include "reports/audit.hpp"
#include "reports/features_table.hpp"
#include "reports/replay_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Drive the logged trials again at gated speed: same path, every interval re-timed by the margin.

Each trial is replayed at every law of --laws and beta of --betas, guards G1-G3 on. Where the law or
a guard halts over 5 cm of path or more the run stalls, and its success is lost; shorter stretches
are crept through.

With --output DIR: DIR/replay.csv (one row a trial, law and beta; 'hypotheses h3 --replays' reads
it), DIR/audit.csv (every guard that began or ceased to trip, with its cause), DIR/replay_totals.csv,
with --series DIR/series/<law>_<beta>/<trial_id>.csv (margins and speeds, tick by tick), what
'certify --no-series' writes, and DIR/manifest.json. Without it: the totals on stdout.

Usage: tcert replay BUNDLE [options]

Example:
  tcert replay corpus --output replays
  tcert replay corpus --trials 't00000*' --laws clip --betas 10 --replan --set guard_mode=watch

Cost: that of 'tcert certify', and about as much again with --replan.
)";

struct ReplayCommandOptions {
  std::string bundle;
  ReplayLawOptions laws;
  bool replan = false;
  bool series = false;
};

CommandLine command_line(ReplayCommandOptions& o) {
  CommandLine line{
      "replay",
      kText,
      uses_parameters | uses_output | uses_format | uses_threads | uses_trials | uses_logs,
      po::options_description("Options"),
      {{"BUNDLE", &o.bundle, true, OptionRole::input}}};
  add_replay_law_options(line.own, o.laws);
  line.own.add_options()(
      "replan",
      po::bool_switch(&o.replan),
      "ask for a new route by D* Lite whenever a guard begins to trip; counts replans, route "
      "changes and expansions, and those of a search from scratch")(
      "series", po::bool_switch(&o.series), "also write margins and speeds, tick by tick");
  return line;
}

std::string name_of(const SpeedLaw& law) {
  std::string name(study::to_string(law.kind));
  name += '_';
  table::append_number(name, law.beta_per_m);
  return name;
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
  ReplayFiles(const ResultFolder& folder, const OpenedBundle& opened, bool series)
      : folder_(folder),
        parameters_(opened.parameters),
        robot_(study::with_overrides(opened.bundle.info.robot, opened.parameters.robot)),
        label_(synthetic_label(opened.bundle.info)),
        series_(series),
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
                          one.guarded[i],
                          parameters_.guards,
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
    const SeriesFormat format{one.record.law, false, label_, true};
    std::string text = series_header(format, robot_);
    for (std::size_t i = 0; i < trial.ticks.size(); ++i) {
      const auto& yaw_rates = trial.ticks.yaw_rate_cmd_rps;
      append_series_row(text,
                        trial.ticks[i],
                        trial.series.ticks[i],
                        {},
                        format,
                        one.guarded[i],
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
  Table table_;
  ResultFile replays_;
  ResultFile audit_;
};

int run(Arguments arguments) {
  ReplayCommandOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (common.output.empty() && options.series) {
    throw UsageError("--series needs --output");
  }
  const OpenedBundle opened = open_for(options.bundle, common);
  study::ReplaySetup setup = replay_setup(options.laws, opened.parameters, common);
  setup.replan = options.replan;
  if (setup.replan && !opened.bundle.info.course.goal) {
    throw UsageError("--replan needs a bundle with a goal");
  }
  std::optional<ResultFolder> folder;
  std::optional<ReplayFiles> files;
  if (!common.output.empty()) {
    require_apart(options.bundle, common.output);
    folder.emplace(common.output, "replay");
    files.emplace(*folder, opened, options.series);
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
  const CertifySummary summary =
      certify_trials(opened, common, folder ? &*folder : nullptr, {false}, {}, extra);
  Table table = totals.table();
  table.synthetic = synthetic_label(opened.bundle.info);
  table.n = static_cast<std::int64_t>(summary.trials);
  if (!folder) {
    print(render(table, common.table_format()));
    return report(summary, opened, common);
  }
  files->close();
  folder->write("replay_totals.csv", render(table, TableFormat::csv));
  Manifest manifest = manifest_of("replay", opened, common, summary);
  if (const auto input = tracking_error_input(options.laws.tracking_error)) {
    manifest.inputs.push_back(*input);
  }
  folder->commit(std::move(manifest));
  return report(summary, opened, common);
}

}  // namespace

const Command kReplay = {"replay", "drive logged trials again at gated speed", run};

}  // namespace tcert::cli
