#pragma once
/// \file
/// `import log`: a foreign log becomes a bundle, by a map.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ImportLogRequest {
  std::string format;  ///< "log".
  std::string source;
  std::vector<std::string> more_sources;
  std::string map;
  OutputPath output;
  bool decimal_comma = false;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(ImportLogRequest& request);

/// exit_rejected if some trials were left out. \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode import_log(const ImportLogRequest& request, Progress& progress);

}  // namespace tcert::cli
