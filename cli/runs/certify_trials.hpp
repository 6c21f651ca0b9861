#pragma once
/// \file
/// Certifying the chosen trials of a bundle, with or without a folder of results.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analysis/study/trials/study_tables.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/values/check_values.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

struct CertifyFiles {
  bool series = true;          ///< series/<trial_id>.csv, edges/<trial_id>.csv
  bool ticks = false;          ///< ticks/<trial_id>.csv
  bool ray_margins = false;    ///< Columns in the series.
  bool witness = false;        ///< witness/<trial_id>.json
  bool witness_edges = false;  ///< In it, and in edges/<trial_id>.csv; with `witness` alone.
  bool submaps = false;        ///< submaps/<trial_id>.csv: by `witness_edges` of what is proved.
  const study::CertifiedGround* ground = nullptr;  ///< Only ticks on it count; null: all.
};

struct CertifySummary {
  std::size_t trials = 0;  ///< Certified.
  std::vector<std::string> rejected;
  std::size_t log_bytes = 0;
  std::vector<ManifestFile> inputs;
  ValueSummary values;  ///< What the values of its trials are warned of.
};

/// What a caller wants to see of each trial that was certified, in order.
using TrialSink = std::function<void(study::TrialRecord&&)>;

/// What a caller makes of a trial while its ticks are there: called in parallel, from any thread,
/// for trials that are not rejected; what it returns is called in order, one at a time, just before
/// the sink.
using TrialExtra = std::function<std::function<void()>(const study::StudiedTrial&)>;

/// Writes features.csv, certificates.csv, diagnostics.csv and what `files` asks for into `folder`,
/// if there is one. The findings of check_values() go into diagnostics.csv and the summary. Under
/// --strict it ends at the first rejected trial.
/// \throws BadData under --strict; WriteError.
[[nodiscard]] CertifySummary certify_trials(const OpenedBundle& opened,
                                            std::int64_t threads,
                                            Progress& progress,
                                            const ResultFolder* folder,
                                            const CertifyFiles& files,
                                            const TrialSink& sink,
                                            const TrialExtra& extra = {});

/// Says "Certified 658 trials; rejected: t3, t9."; the exit code that goes with it.
[[nodiscard]] ExitCode conclude(const CertifySummary& summary,
                                const OpenedBundle& opened,
                                Progress& progress);

/// Says what the values of the trials are warned of, a line a kind.
void say_values(const CertifySummary& summary, Progress& progress);

/// The manifest of a command that certified a bundle.
[[nodiscard]] Manifest manifest_of(std::string command,
                                   const OpenedBundle& opened,
                                   WrittenOptions written,
                                   const CertifySummary& summary);

}  // namespace tcert::cli
