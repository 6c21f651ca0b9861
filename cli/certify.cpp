#include <optional>
#include <utility>

#include "cli/certify_run.hpp"
#include "cli/certify_truth.hpp"
#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/report_output.hpp"
#include "reports/features_table.hpp"
#include "reports/study_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Certify the trials of a bundle: the certificate at every tick, and each trial's features.

With --output DIR: DIR/series/<trial_id>.csv (one row a tick), DIR/edges/<trial_id>.csv (one row an
edge of the corridor graph), DIR/features.csv and DIR/certificates.csv (one row a trial), the tables
of the study (table1, speed, latency) in every format, DIR/diagnostics.csv, DIR/manifest.json.
Without it: the features on stdout.

Usage: tcert certify BUNDLE [options]

Example:
  tcert certify corpus --output results
  tcert certify corpus --trials 't00000*' --set memory_weight_m=0 --format csv

Cost: one pass over the logs, a few trials in memory at a time; the series take about as much space
as logs at 20 Hz (--no-series leaves them out).
)";

struct CertifyOptions {
  bool ticks = false;
  bool no_series = false;
  bool ray_margins = false;
  bool truth = false;
  std::string bundle;
};

CommandLine command_line(CertifyOptions& o) {
  CommandLine line{
      "certify",
      kText,
      uses_parameters | uses_output | uses_format | uses_threads | uses_trials | uses_logs,
      po::options_description("Options"),
      {{"BUNDLE", &o.bundle, true, OptionRole::input}}};
  line.own.add_options()("ticks",
                         po::bool_switch(&o.ticks),
                         "also write DIR/ticks/<trial_id>.csv, which 'live' reads and a bundle "
                         "takes as logs/<trial_id>/ticks.csv")(
      "no-series",
      po::bool_switch(&o.no_series),
      "leave DIR/series and DIR/edges out, to save space")(
      "ray-margins",
      po::bool_switch(&o.ray_margins),
      "one more column a ray in the series: its own margin")(
      "truth",
      po::bool_switch(&o.truth),
      "two more columns in the features: T of each trial's known world, at least and at most "
      "(truth_lower_m, truth_upper_m); failed trials with a certificate are listed");
  return line;
}

/// Keeps the failed trials for say_issued_failures, if truth was asked for.
class Failures {
 public:
  explicit Failures(bool wanted) : wanted_(wanted) {}

  void add(const study::TrialRecord& trial) {
    if (wanted_ && !trial.row.trial.success.value_or(true)) {
      trials_.push_back(trial);
    }
  }
  void say() const {
    if (wanted_) {
      say_issued_failures(trials_);
    }
  }

 private:
  bool wanted_;
  std::vector<study::TrialRecord> trials_;
};

int certify_to_stdout(const OpenedBundle& opened, const CommonOptions& common, bool truth) {
  Failures failures(truth);
  Table table = features_table(opened.bundle);
  const CertifySummary summary =
      certify_trials(opened, common, nullptr, {}, [&](study::TrialRecord&& trial) {
        table.add_row(features_row(trial));
        failures.add(trial);
      });
  table.n = static_cast<std::int64_t>(summary.trials);
  print(render(table, common.table_format()));
  failures.say();
  return report(summary, opened, common);
}

int run(Arguments arguments) {
  CertifyOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (common.output.empty() && (options.ticks || options.no_series || options.ray_margins)) {
    throw UsageError("--ticks, --no-series and --ray-margins need --output");
  }
  OpenedBundle opened = open_for(options.bundle, common);
  if (options.truth) {
    add_truth(opened, common);
  }
  if (common.output.empty()) {
    return certify_to_stdout(opened, common, options.truth);
  }
  require_apart(options.bundle, common.output);
  ResultFolder folder(common.output, "certify");
  Failures failures(options.truth);
  study::StudyRecord study;
  const CertifySummary summary =
      certify_trials(opened,
                     common,
                     &folder,
                     {!options.no_series, options.ticks, options.ray_margins},
                     [&](study::TrialRecord&& trial) {
                       failures.add(trial);
                       study.add(std::move(trial));
                     });
  for (Table& table : study_tables(study)) {
    table.synthetic = synthetic_label(opened.bundle.info);
    write_table(table, folder);
  }
  folder.commit(manifest_of("certify", opened, common, summary));
  failures.say();
  return report(summary, opened, common);
}

}  // namespace

const Command kCertify = {"certify", "certify the trials of a bundle, tick by tick", run};

}  // namespace tcert::cli
