#pragma once
/// \file
/// `world`: the truth of known worlds.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct WorldRequest {
  std::string first;
  std::vector<std::string> rest;
  std::string clearance = "width";
  double body_width_m = 0.45;
  double min_turn_radius_m = 0.35;
  bool no_curvature = false;
  double step_m = 0.02;
  double path_cell_m = 0.01;
  double turn_cell_m = 0.0;
  double cell_m = 1.0;
  std::string start;
  std::string goal;
  std::string bounds;
  std::string picture;
  OutputOptions output;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(WorldRequest& request);

/// A world that cannot be used is said, the others go on. \throws UsageError, NoInput, BadData,
/// WriteError.
[[nodiscard]] ExitCode world(const WorldRequest& request, Progress& progress);

}  // namespace tcert::cli
