#pragma once
/// \file
/// `hypotheses`: H1, H2 or H3 on a bundle or on a table of trials.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/replay_options.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct HypothesesRequest {
  std::string hypothesis;  ///< "h1", "h2", "h3".
  std::string bundle;
  std::string features;
  std::string predictor;
  std::string baselines;
  std::string success = "success";
  std::string time = "time_s";
  std::string cluster = "day";
  std::string strata = "algorithm";
  std::optional<std::string> within;
  std::string landmark;
  std::string limit;
  bool no_time_rounding = false;
  std::int64_t replicates = 2000;
  std::int64_t folds = 5;
  std::string interval = "expanded";
  double level = 0.95;
  // h2
  std::string group = "lighting";
  double margin = 0.05;
  std::int64_t permutations = 2000;
  std::string table;
  // h3
  std::string replays;
  std::string gated = "M3";
  std::string lead = "CB-V";
  double loss_margin = 0.05;
  std::optional<double> true_loss;  ///< A fifth of the margin.
  std::string beta = "10";
  bool driven = false;
  ReplayLawOptions laws;

  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(HypothesesRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode hypotheses(const HypothesesRequest& request, Progress& progress);

}  // namespace tcert::cli
