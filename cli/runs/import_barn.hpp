#pragma once
/// \file
/// `import barn`: public outcomes of the BARN challenge become a feature table.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ImportBarnRequest {
  std::string format;  ///< "barn".
  std::vector<std::string> trials;
  std::vector<std::string> more_trials;  ///< Those behind the first, as a pattern of a shell gives.
  std::string planner;                   ///< Of result text; empty: by the names of the files.
  std::string metrics;
  std::string planners;
  bool same_port = false;
  OutputPath output;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(ImportBarnRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode import_barn(const ImportBarnRequest& request, Progress& progress);

}  // namespace tcert::cli
