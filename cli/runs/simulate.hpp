#pragma once
/// \file
/// `simulate`: the synthetic corpus with its manifest, and knowing it again.

#include <filesystem>

#include "cli/runs/errors.hpp"
#include "cli/runs/items.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct SimulateRequest {
  std::int64_t trials = 660;
  std::int64_t from = 0;
  double effect = 1.0;
  bool native_rates = false;
  bool micro_study = false;  ///< The 60 gate passes; only the seed counts beside it.
  OutputPath output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(SimulateRequest& request);

/// Writes the bundle and its manifest.json whole or not at all. \throws UsageError, WriteError.
[[nodiscard]] ExitCode simulate(const SimulateRequest& request, Progress& progress);

/// How many trials are asked for, and a bundle of some of them in a new folder.
[[nodiscard]] std::uint64_t trials_of(const SimulateRequest& request);
void make_trials(const SimulateRequest& request,
                 ItemRange trials,
                 const std::filesystem::path& folder);

/// True if the output is this corpus as this build makes it, every file with its bytes.
[[nodiscard]] bool is_there(const SimulateRequest& request);

}  // namespace tcert::cli
