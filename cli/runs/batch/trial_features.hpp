#pragma once
/// \file
/// Features of made trials without their logs: each trial is made, certified and forgotten.

#include "cli/runs/drive.hpp"
#include "cli/runs/simulate.hpp"

namespace tcert::cli {

/// features.csv of the trials that the request asks for, as `simulate` or `drive` and then
/// `certify` would write it, with a manifest. Without an output it is shown. \throws UsageError,
/// WriteError.
[[nodiscard]] ExitCode simulated_features(const SimulateRequest& request,
                                          Progress& progress,
                                          const ItemSource& source);
[[nodiscard]] ExitCode driven_features(const DriveRequest& request,
                                       Progress& progress,
                                       const ItemSource& source);
/// The same, made here.
[[nodiscard]] ExitCode simulated_features(const SimulateRequest& request, Progress& progress);
[[nodiscard]] ExitCode driven_features(const DriveRequest& request, Progress& progress);

/// The trials, a row each; an empty one of a trial that is rejected. \throws UsageError.
[[nodiscard]] std::vector<ItemSet> items_of(const SimulateRequest& request, Progress& progress);
[[nodiscard]] std::vector<ItemSet> items_of(const DriveRequest& request, Progress& progress);

}  // namespace tcert::cli
