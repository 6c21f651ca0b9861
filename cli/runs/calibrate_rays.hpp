#pragma once
/// \file
/// `calibrate rays`: from bends beside measured clearances to the calibration of a bundle's rays.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct CalibrateRaysRequest {
  std::string kind;  ///< "rays".
  std::string pairs;
  std::string bundle;  ///< Whose rays they are; empty: not told.
  double alpha = 0.05;
  bool no_bound = false;
  std::int64_t knots = 12;
  std::string table;
  OutputOptions output;
  std::int64_t seed = 1;
  bool decimal_comma = false;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(CalibrateRaysRequest& request);

/// \throws UsageError, NoInput, BadData (also for too few days), WriteError.
[[nodiscard]] ExitCode calibrate_rays(const CalibrateRaysRequest& request, Progress& progress);

}  // namespace tcert::cli
