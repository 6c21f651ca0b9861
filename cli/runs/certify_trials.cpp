#include "cli/runs/certify_trials.hpp"

#include <functional>
#include <memory>
#include <utility>

#include "analysis/study/trials/study.hpp"
#include "cli/runs/bundle_digest.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/trial_files.hpp"
#include "reports/diagnostics_table.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

/// The tables that have a row or more per trial, written as trials come in.
class TrialTables {
 public:
  TrialTables(const Bundle& bundle, WitnessColumns witness, const std::filesystem::path& folder)
      : features_(features_table(bundle)),
        certificates_(certificates_table(bundle, witness)),
        diagnostics_(diagnostics_table(synthetic_label(bundle.info))),
        features_file_(folder / "features.csv"),
        certificates_file_(folder / "certificates.csv"),
        diagnostics_file_(folder / "diagnostics.csv") {
    write_header(features_file_, features_);
    write_header(certificates_file_, certificates_);
    write_header(diagnostics_file_, diagnostics_);
  }

  void add_diagnostics(const std::string& trial_id,
                       std::span<const table::Diagnostic> diagnostics) {
    for (const table::Diagnostic& diagnostic : diagnostics) {
      write_row(diagnostics_file_, diagnostics_, diagnostics_row(trial_id, diagnostic));
    }
  }

  void add_trial(const study::TrialRecord& trial, const std::vector<TableCell>& certificate) {
    write_row(features_file_, features_, features_row(trial));
    write_row(certificates_file_, certificates_, certificate);
  }

  void close() {
    features_file_.close();
    certificates_file_.close();
    diagnostics_file_.close();
  }

 private:
  static void write_header(ResultFile& file, const Table& table) {
    std::string line;
    append_csv_header(line, table);
    file.write(line);
  }
  static void write_row(ResultFile& file, const Table& table, const std::vector<TableCell>& row) {
    std::string line;
    append_csv_row(line, table, row);
    file.write(line);
  }

  Table features_;
  Table certificates_;
  Table diagnostics_;
  ResultFile features_file_;
  ResultFile certificates_file_;
  ResultFile diagnostics_file_;
};

/// What is left of a trial when its ticks are gone.
struct CertifiedTrial {
  study::TrialRecord record;
  FileDigest digest;
  std::vector<TableCell> certificate;
  std::vector<table::Diagnostic> diagnostics;
  std::vector<ValueFinding> values;
  bool rejected = false;
  std::size_t log_bytes = 0;
  std::function<void()> finish;
};

/// Takes trials in order, one at a time.
class Gathering {
 public:
  /// `tables` may be null.
  Gathering(TrialTables* tables, Progress& progress, const TrialSink& sink)
      : tables_(tables), progress_(progress), sink_(sink) {}

  void take(CertifiedTrial& trial) {
    const std::string& id = trial.record.row.trial.trial_id;
    logs_.add(id, trial.digest);
    summary_.log_bytes += trial.log_bytes;
    say(trial.diagnostics);
    summary_.values.add(trial.values);
    if (tables_ != nullptr) {
      tables_->add_diagnostics(id, trial.diagnostics);
      for (const ValueFinding& finding : trial.values) {
        tables_->add_diagnostics(id, std::span(&finding.diagnostic, 1));
      }
    }
    if (trial.rejected) {
      summary_.rejected.push_back(id);
      return;
    }
    ++summary_.trials;
    if (tables_ != nullptr) {
      tables_->add_trial(trial.record, trial.certificate);
    }
    if (trial.finish) {
      trial.finish();
    }
    if (sink_) {
      sink_(std::move(trial.record));
    }
  }

  [[nodiscard]] CertifySummary& summary() noexcept { return summary_; }
  [[nodiscard]] ListDigest& logs() noexcept { return logs_; }

 private:
  /// Notes are for whoever looks into diagnostics.csv.
  void say(std::span<const table::Diagnostic> diagnostics) {
    for (const table::Diagnostic& one : diagnostics) {
      if (one.severity != table::Severity::note) {
        progress_.say(table::to_string(one));
      }
    }
  }

  TrialTables* tables_;
  Progress& progress_;
  const TrialSink& sink_;
  CertifySummary summary_;
  ListDigest logs_;
};

}  // namespace

CertifySummary certify_trials(const OpenedBundle& opened,
                              std::int64_t threads,
                              Progress& progress,
                              const ResultFolder* folder,
                              const CertifyFiles& files,
                              const TrialSink& sink,
                              const TrialExtra& extra) {
  const Bundle& bundle = opened.bundle;
  const Robot robot = study::with_overrides(bundle.info.robot, opened.parameters.robot);
  SeriesFormat format{
      opened.parameters.speed_law, files.ray_margins, synthetic_label(bundle.info)};
  format.validity = opened.parameters.certificate.obstacle_speed_mps > 0.0;
  const bool has_witness =
      files.witness || opened.parameters.certificate.clearance == ClearanceReading::witness;
  const WitnessColumns witness = files.witness_edges ? WitnessColumns::with_edges
                                 : has_witness       ? WitnessColumns::yes
                                                     : WitnessColumns::no;
  std::unique_ptr<TrialTables> tables;
  if (folder != nullptr) {
    tables = std::make_unique<TrialTables>(bundle, witness, folder->staging());
    tables->add_diagnostics("", opened.diagnostics);
  }
  Gathering gathering(tables.get(), progress, sink);
  Stage stage(progress, "certifying", opened.trials.size());
  const study::StudyOptions study{{opened.logs.repair},
                                  static_cast<int>(threads),
                                  files.ray_margins && folder != nullptr,
                                  files.witness,
                                  files.witness_edges,
                                  files.ground};
  const auto work = [&](study::StudiedTrial&& trial) -> std::function<bool()> {
    auto done = std::make_shared<CertifiedTrial>();
    done->rejected = trial.rejected;
    done->log_bytes = trial.log_bytes;
    if (folder != nullptr) {
      done->digest = log_digest(bundle, *trial.row);
    }
    if (folder != nullptr && !trial.rejected) {
      write_trial_files(trial, *folder, files, format, robot, bundle.info.range_keys);
    }
    if (folder != nullptr && files.witness) {
      write_witness(trial, done->digest.sha256, opened, robot, *folder);
    }
    if (folder != nullptr && files.submaps && !trial.rejected) {
      write_submap(trial, done->digest.sha256, opened, robot, *folder);
    }
    done->certificate = certificates_row(trial, done->digest.sha256, witness);
    done->diagnostics = std::move(trial.diagnostics);
    if (!trial.rejected) {
      done->values =
          check_values(bundle.info, *trial.row, opened.parameters.certificate, trial.ticks);
    }
    if (extra && !trial.rejected) {
      done->finish = extra(trial);
    }
    // The ticks end here: what waits for its turn is small.
    done->record = study::summarise(trial);
    return [&, done]() {
      stage.advance();
      gathering.take(*done);
      return !done->rejected || !opened.logs.strict;
    };
  };
  study::study_trials(bundle, opened.trials, opened.parameters, study, work);
  CertifySummary& summary = gathering.summary();
  if (opened.logs.strict && !summary.rejected.empty()) {
    throw BadData("trial '" + summary.rejected.front() +
                  "' is rejected, and --strict was asked for");
  }
  if (tables) {
    tables->close();
    summary.inputs = bundle_inputs(bundle, gathering.logs().finish());
  }
  return std::move(summary);
}

ExitCode conclude(const CertifySummary& summary, const OpenedBundle& opened, Progress& progress) {
  std::string line =
      "Certified " + std::to_string(summary.trials) + (summary.trials == 1 ? " trial" : " trials");
  for (const std::string& id : summary.rejected) {
    line += (&id == &summary.rejected.front() ? "; rejected: " : ", ") + id;
  }
  const bool bad_rows = table::has_error(opened.diagnostics);
  line += bad_rows ? "; some rows of trials.csv are rejected, see above." : ".";
  if (summary.rejected.empty() && !bad_rows) {
    progress.sum_up(line);
    return exit_done;
  }
  progress.say(line);
  return exit_rejected;
}

void say_values(const CertifySummary& summary, Progress& progress) {
  for (const std::string& line : summary.values.lines()) {
    progress.say(line);
  }
}

Manifest manifest_of(std::string command,
                     const OpenedBundle& opened,
                     WrittenOptions written,
                     const CertifySummary& summary) {
  Manifest manifest;
  manifest.command = std::move(command);
  record(std::move(written), manifest);
  manifest.parameters = as_settings(opened.parameters, opened.bundle.info.robot);
  manifest.synthetic = synthetic_label(opened.bundle.info);
  manifest.inputs = summary.inputs;
  return manifest;
}

}  // namespace tcert::cli
