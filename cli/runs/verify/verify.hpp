#pragma once
/// \file
/// `verify`: results made again and every byte compared.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct VerifyRequest {
  std::string results;
  std::vector<std::string> inputs;
  bool files_only = false;
  OutputFormat output;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(VerifyRequest& request);

/// exit_differences if something does not stand, exit_no_input if something cannot be made again.
/// \throws UsageError, NoInput, BadData, WriteError, OutOfResources.
[[nodiscard]] ExitCode verify(const VerifyRequest& request, Progress& progress);

}  // namespace tcert::cli
