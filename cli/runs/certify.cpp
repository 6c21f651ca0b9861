#include "cli/runs/certify.hpp"

#include <utility>

#include "cli/runs/certify_trials.hpp"
#include "cli/runs/certify_truth.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/shared_options.hpp"
#include "reports/certify_findings.hpp"
#include "reports/features_table.hpp"
#include "reports/study_table.hpp"

namespace tcert::cli {
namespace {

/// Keeps the failed trials for say_issued_failures, if truth was asked for.
class Failures {
 public:
  explicit Failures(bool wanted) : wanted_(wanted) {}

  void add(const study::TrialRecord& trial) {
    if (wanted_ && !trial.row.trial.success.value_or(true)) {
      trials_.push_back(trial);
    }
  }
  void say(Progress& progress) const {
    if (wanted_) {
      say_issued_failures(trials_, progress);
    }
  }

 private:
  bool wanted_;
  std::vector<study::TrialRecord> trials_;
};

ExitCode certify_to_text(const OpenedBundle& opened,
                         const CertifyRequest& request,
                         Progress& progress) {
  Failures failures(request.truth);
  Table table = features_table(opened.bundle);
  study::StudyRecord study;
  const CertifySummary summary = certify_trials(
      opened, request.threads, progress, nullptr, {}, [&](study::TrialRecord&& trial) {
        table.add_row(features_row(trial));
        failures.add(trial);
        study.add(std::move(trial));
      });
  table.n = static_cast<std::int64_t>(summary.trials);
  show_found(table, certify_findings(study.rows()), request.output, progress);
  failures.say(progress);
  say_values(summary, progress);
  return conclude(summary, opened, progress);
}

}  // namespace

OptionTable options_of(CertifyRequest& request) {
  OptionTable table(request.given);
  table.argument({"BUNDLE", &request.bundle, true, OptionRole::input});
  table.add("ticks",
            request.ticks,
            "also write DIR/ticks/<trial_id>.csv, which 'live' reads and a bundle takes as "
            "logs/<trial_id>/ticks.csv");
  table.add("no-series", request.no_series, "leave DIR/series and DIR/edges out, to save space");
  table.add(
      "ray-margins", request.ray_margins, "one more column a ray in the series: its own margin");
  table.add("witness",
            request.witness,
            "look for a witness of each trial, a path that proves its margin, whatever 'clearance' "
            "is; write DIR/witness/<trial_id>.json, which 'verify' checks, and its margin into "
            "certificates.csv (witness_m)");
  table.add(
      "witness-edges",
      request.witness_edges,
      "as --witness, and a path along each edge of the corridor graph, in a failed trial too: "
      "into the same file, its margin into DIR/edges (proved_m), how many there are and what "
      "they prove in a chain into certificates.csv (edges_proved, chain_m)");
  table.add("truth",
            request.truth,
            "two more columns in the features: T of each trial's known world, at least and at most "
            "(truth_lower_m, truth_upper_m); failed trials with a certificate are listed");
  add_common(table, request);
  return table;
}

ExitCode certify(const CertifyRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty() && (request.ticks || request.no_series || request.ray_margins ||
                         request.witness || request.witness_edges)) {
    throw UsageError(
        "--ticks, --no-series, --ray-margins, --witness and --witness-edges need --output");
  }
  OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  if (opened.parameters.witness.witness_every > 0 &&
      opened.parameters.certificate.clearance != ClearanceReading::witness) {
    progress.say("witness_every does nothing without clearance=witness: T_t is that of the ticks");
  }
  if (request.truth) {
    add_truth(opened, request.threads, progress);
  }
  if (output.empty()) {
    return certify_to_text(opened, request, progress);
  }
  require_apart(request.bundle, output);
  ResultFolder folder(output, "certify");
  Failures failures(request.truth);
  study::StudyRecord study;
  const CertifySummary summary = certify_trials(opened,
                                                request.threads,
                                                progress,
                                                &folder,
                                                {!request.no_series,
                                                 request.ticks,
                                                 request.ray_margins,
                                                 request.witness || request.witness_edges,
                                                 request.witness_edges},
                                                [&](study::TrialRecord&& trial) {
                                                  failures.add(trial);
                                                  study.add(std::move(trial));
                                                });
  std::vector<Table> tables = study_tables(study);
  const Table findings = certify_findings(study.rows());
  tables.push_back(findings);
  for (Table& table : tables) {
    table.synthetic = synthetic_label(opened.bundle.info);
    write_table(table, folder);
  }
  folder.commit(manifest_of("certify", opened, written(request), summary));
  failures.say(progress);
  say_values(summary, progress);
  sum_up(findings, progress);
  return conclude(summary, opened, progress);
}

}  // namespace tcert::cli
