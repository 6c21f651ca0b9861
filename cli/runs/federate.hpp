#pragma once
/// \file
/// `federate`: the certificate over the submaps of several robots.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct FederateRequest {
  std::string first;
  std::vector<std::string> rest;
  std::optional<double> frame_error_m;
  std::optional<double> frame_error_rad;
  std::string table;
  OutputOptions output;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(FederateRequest& request);

/// The same bytes in whichever order the files are given, but for the list of inputs.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode federate(const FederateRequest& request, Progress& progress);

}  // namespace tcert::cli
