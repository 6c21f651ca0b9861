#pragma once
/// \file
/// Trials of a bundle from log to features, several at once, handed over in their order.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <table/diagnostic.hpp>
#include <tcert/certifier.hpp>
#include <vector>

#include "analysis/study/trials/certify_trial.hpp"
#include "analysis/study/trials/features.hpp"
#include "analysis/study/trials/not_issued.hpp"
#include "analysis/study/trials/parameters.hpp"
#include "analysis/study/witness/witness_looks.hpp"
#include "datasets/bundle.hpp"
#include "datasets/ticks.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::study {

class CertifiedGround;

/// Everything about one trial. A rejected one has diagnostics and neither ticks nor series.
struct StudiedTrial {
  const TrialRow* row = nullptr;  ///< In the bundle; never null.
  std::vector<table::Diagnostic> diagnostics;
  bool rejected = false;
  std::size_t log_bytes = 0;
  TickTable ticks;
  TrialSeries series;
  std::vector<double> ray_margins;  ///< Row-major, ticks x rays; empty unless asked for.
  Features features;
  std::optional<NotIssued> not_issued;
  std::optional<Proof> proof;           ///< Empty unless a witness was asked for.
  std::vector<WitnessLook> looks;       ///< Under clearance=witness, while the run went on.
  std::vector<double> speed_cmd_mps;    ///< Of the raw control stream, or of merged ticks.
  std::vector<double> loop_latency_ms;  ///< Of the raw control stream; NaN where missing.
};

struct StudyOptions {
  ReadOptions read;
  int threads = 0;  ///< 0: all cores.
  bool ray_margins = false;
  bool witness = false;        ///< Look for a witness whatever the clearance reading is.
  bool witness_edges = false;  ///< And for those of the edges, where one is looked for.
  /// Only ticks on it count; null: all. Not owned.
  const CertifiedGround* ground = nullptr;
};

/// Reads a trial's log into `trial`: everything but ticks, series and features. Empty if the trial
/// is rejected.
[[nodiscard]] std::optional<TrialLog> read_studied(const Bundle& bundle,
                                                   const TrialRow& row,
                                                   const StudyOptions& options,
                                                   StudiedTrial& trial);

/// What is to happen with a trial: called in parallel, from any thread; what it returns is called
/// in the order of `trials`, one at a time. That returns false to stop the study.
using TrialWork = std::function<std::function<bool()>(StudiedTrial&&)>;

/// Reads, resamples, certifies and summarises the trials with these indices. At most a few trials
/// per thread are in memory at once, however many there are. The calls, their order and their
/// arguments are the same for any number of threads.
/// \throws std::invalid_argument if the robot or the parameters are out of range; whatever `work`
/// throws.
void study_trials(const Bundle& bundle,
                  std::span<const std::size_t> trials,
                  const ParameterSet& parameters,
                  const StudyOptions& options,
                  const TrialWork& work);

/// Calls work(0) ... work(count - 1) in parallel and what they return in order; see TrialWork.
void in_order(std::size_t count,
              int threads,
              const std::function<std::function<bool()>(std::size_t)>& work);

}  // namespace tcert::study
