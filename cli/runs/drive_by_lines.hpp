#pragma once
/// \file
/// A driven trial whose policy is another process: senses out, commands in, a line each.

#include <string>

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "datasets/driven/driven_design.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// Drives the design to its end and writes it as a bundle of one trial, with `manifest`, which says
/// how the world was made; nobody can make the trial again, since its policy is elsewhere.
///
/// Over stdout and stdin, or over `listen` ("unix:PATH"), to which one process connects.
/// There come comments with what is known beforehand ("# robot {...}", "# box x y x y", "# lane
/// LOBE LANE x y x y ..."), the header, then a row for each control step: the columns of ticks.csv,
/// goal_x_m, goal_y_m, travel_m, measured_mps, bump_bearing_rad, bump_force_n. For each row a line
/// "speed_mps,yaw_rate_rps" is waited for. What is driven does not depend on how long it
/// takes: the world stands still meanwhile.
/// \throws BadData for a line that is no command, or if they end before the trial; UsageError for a
/// `listen` that is none; NoInput if it cannot be listened on; WriteError.
[[nodiscard]] ExitCode drive_by_lines(const DrivenDesign& design,
                                      const std::string& listen,
                                      const std::string& output,
                                      Manifest manifest,
                                      Progress& progress);

}  // namespace tcert::cli
