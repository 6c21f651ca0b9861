#pragma once
/// \file
/// `calibrate tracking`: the buffers of a robot from its runs, or a table of tracking errors of a
/// model.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct CalibrateTrackingRequest {
  std::string kind;   ///< "tracking".
  std::string runs;   ///< Empty with a model.
  std::string model;  ///< "double-integrator", or none.
  double braking_mps2 = 1.0;
  double disturbance_mps2 = 0.0;
  double disturbance_mps = 0.0;
  double exploring_mps = 0.0;
  std::string speeds = "0,0.05,0.1,0.15,0.2,0.25,0.3,0.4,0.5";
  double lag_s = 2.0;
  double window_m = 0.25;
  bool same_time = false;
  std::string table;
  OutputOptions output;
  bool decimal_comma = false;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(CalibrateTrackingRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode calibrate_tracking(const CalibrateTrackingRequest& request,
                                          Progress& progress);

}  // namespace tcert::cli
