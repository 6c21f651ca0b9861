#pragma once
/// \file
/// `calibrate guards`: speed law and thresholds fitted to driven trials, judged on other days.

#include "cli/runs/errors.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct CalibrateGuardsRequest {
  std::string kind;  ///< "guards".
  std::string bundle;
  std::string laws = "squash,clip";
  std::string betas = "5,10,20,40";
  std::string epsilons = "0,0.005,0.01,0.02,0.04";
  std::string forces = "5,20,40";
  double most_lost = 0.1;
  double most_unsafe = 0.1;
  std::int64_t folds = 5;
  std::string tracking_error;
  std::string table;
  OutputOptions output;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(CalibrateGuardsRequest& request);

/// \throws UsageError, NoInput, BadData (no trial has truth.csv), WriteError.
[[nodiscard]] ExitCode calibrate_guards(const CalibrateGuardsRequest& request, Progress& progress);

}  // namespace tcert::cli
