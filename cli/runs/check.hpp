#pragma once
/// \file
/// `check`: logs looked at before anything is computed from them, whatever they are.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct CheckRequest {
  std::string path;       ///< Of a bundle, a bag, a CSV file, a folder of these.
  std::string write_map;  ///< Where a map for 'import log' is drafted; empty: nowhere.
  std::string clock;      ///< Of a CSV file: the column that is its clock.
  OutputFormat output;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(CheckRequest& request);

/// exit_differences if there is a warning or an error. \throws UsageError, NoInput, BadData.
[[nodiscard]] ExitCode check(const CheckRequest& request, Progress& progress);

}  // namespace tcert::cli
