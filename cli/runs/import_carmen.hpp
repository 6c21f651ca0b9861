#pragma once
/// \file
/// `import carmen`: a Carnegie Mellon log becomes a bundle of one trial.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"
#include "datasets/import/import_carmen.hpp"

namespace tcert::cli {

struct ImportCarmenRequest {
  std::string format;  ///< "carmen".
  std::string log;
  std::optional<double> goal_x_m;
  std::optional<double> goal_y_m;
  double goal_radius_m = 1.0;
  std::optional<double> fov_deg;
  std::string clock = "ipc";  ///< "ipc", "logger" or "order".
  std::optional<double> rate_hz;
  CarmenImportOptions carmen;
  OutputPath output;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(ImportCarmenRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode import_carmen(const ImportCarmenRequest& request, Progress& progress);

}  // namespace tcert::cli
