#pragma once
/// \file
/// What a live run is of: the bundle that describes it, and what runs at its ticks.

#include <string>
#include <tcert/runtime.hpp>

#include "cli/runs/progress.hpp"
#include "datasets/bundle.hpp"

namespace tcert::cli {

/// Of a bundle, or of its bundle.json alone. \throws UsageError, NoInput, BadData.
[[nodiscard]] BundleInfo describe(const std::string& path, Progress& progress);

/// \throws UsageError if the parameters are none of a live run.
[[nodiscard]] Runtime runtime_of(const Course& course, const ActionSetup& actions);

}  // namespace tcert::cli
