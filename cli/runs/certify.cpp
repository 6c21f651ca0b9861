#include "cli/runs/certify.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

#include "analysis/study/trials/certified_ground.hpp"
#include "cli/runs/certify_trials.hpp"
#include "cli/runs/certify_truth.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/shared_options.hpp"
#include "cli/runs/terrain_input.hpp"
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

/// None of a request without one. \throws NoInput, BadData, UsageError.
std::optional<study::CertifiedGround> ground_of(const CertifyRequest& request,
                                                const OpenedBundle& opened,
                                                Progress& progress) {
  if (request.ground.empty()) {
    return std::nullopt;
  }
  const TerrainGrid safe = read_terrain_or_throw(request.ground, {}, progress);
  try {
    return study::CertifiedGround(
        safe, effective_robot(opened.bundle.info, opened.parameters).body_width_m);
  } catch (const std::invalid_argument& error) {
    throw BadData("'" + request.ground + "': " + error.what());
  }
}

ExitCode certify_to_text(const OpenedBundle& opened,
                         const CertifyRequest& request,
                         const CertifyFiles& files,
                         Progress& progress) {
  Failures failures(request.truth);
  Table table = features_table(opened.bundle);
  study::StudyRecord study;
  const CertifySummary summary = certify_trials(
      opened, request.threads, progress, nullptr, files, [&](study::TrialRecord&& trial) {
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
  table.add(
      "submaps",
      request.submaps,
      "write DIR/submaps/<trial_id>.csv, what a trial tells other robots, for 'federate': its "
      "corridor graph with a margin an edge, the proved one with --witness-edges");
  table.add("truth",
            request.truth,
            "two more columns in the features: T of each trial's known world, at least and at most "
            "(truth_lower_m, truth_upper_m); failed trials with a certificate are listed");
  table.add_input(
      "ground",
      request.ground,
      "FILE",
      "ground that is certified, as rasters/safe.asc of 'explore' on the course's map in "
      "metres: ticks whose body is not on it do not count, and the path is broken there");
  add_common(table, request);
  return table;
}

ExitCode certify(const CertifyRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty() && (request.ticks || request.no_series || request.ray_margins ||
                         request.witness || request.witness_edges || request.submaps)) {
    throw UsageError(
        "--ticks, --no-series, --ray-margins, --witness, --witness-edges and --submaps need "
        "--output");
  }
  if (!request.ground.empty() && (request.witness || request.witness_edges)) {
    throw UsageError("--ground has no effect on witnesses, which are found in the whole log");
  }
  OpenedBundle opened = open_for(request.bundle, request.logs, progress);
  if (opened.parameters.certificate.obstacle_speed_mps > 0.0 &&
      (request.submaps || request.witness || request.witness_edges)) {
    throw UsageError(
        "--submaps, --witness and --witness-edges: with obstacle_speed_mps above 0 a margin holds "
        "for a time, and submaps and witnesses say nothing of time");
  }
  if (opened.parameters.witness.witness_every > 0 &&
      opened.parameters.certificate.clearance != ClearanceReading::witness) {
    progress.say("witness_every does nothing without clearance=witness: T_t is that of the ticks");
  }
  if (request.truth) {
    add_truth(opened, request.threads, progress);
  }
  const std::optional<study::CertifiedGround> ground = ground_of(request, opened, progress);
  CertifyFiles files;
  files.ground = ground ? &*ground : nullptr;
  if (output.empty()) {
    return certify_to_text(opened, request, files, progress);
  }
  files.series = !request.no_series;
  files.ticks = request.ticks;
  files.ray_margins = request.ray_margins;
  files.witness = request.witness || request.witness_edges;
  files.witness_edges = request.witness_edges;
  files.submaps = request.submaps;
  require_apart(request.bundle, output);
  ResultFolder folder(output, "certify");
  Failures failures(request.truth);
  study::StudyRecord study;
  const CertifySummary summary = certify_trials(
      opened, request.threads, progress, &folder, files, [&](study::TrialRecord&& trial) {
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
  Manifest manifest = manifest_of("certify", opened, written(request), summary);
  if (ground) {
    manifest.inputs.push_back({name_of(request.ground), digest_file(request.ground)});
  }
  folder.commit(std::move(manifest));
  failures.say(progress);
  say_values(summary, progress);
  sum_up(findings, progress);
  return conclude(summary, opened, progress);
}

}  // namespace tcert::cli
