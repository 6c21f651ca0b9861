#pragma once
/// \file
/// `check`: logs looked at before anything is computed from them.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct CheckRequest {
  std::string path;  ///< Of a bundle or a CSV file.
  OutputFormat output;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(CheckRequest& request);

/// exit_differences if there is a warning or an error. \throws UsageError, NoInput, BadData.
[[nodiscard]] ExitCode check(const CheckRequest& request, Progress& progress);

}  // namespace tcert::cli
