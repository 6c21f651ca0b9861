#pragma once
/// \file
/// `assure perturb`: a bundle once more, with faults in its logs, and a list of them.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"
#include "datasets/perturb/fault.hpp"

namespace tcert::cli {

struct AssurePerturbRequest {
  std::string kind;  ///< "perturb".
  std::string bundle;
  perturb::FaultOptions faults;
  std::string streams = "pose,tactile,control";
  OutputPath output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  bool decimal_comma = false;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(AssurePerturbRequest& request);

/// Writes the bundle, injections.csv and manifest.json whole or not at all. Without a kind of fault
/// every file is as it was, and there is no injections.csv that was not there before.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode assure_perturb(const AssurePerturbRequest& request, Progress& progress);

}  // namespace tcert::cli
